// SPDX-License-Identifier: MIT
// A tracing machine computes as a counting one does, and tells its observer all that it issues.
#include <gtest/gtest.h>

#include <vector>

#include "simulator/instruction_set.h"
#include "tests/simulator/counting_observer.h"

namespace lanescope {
namespace {

using Tracing = SlowMachine<8>;
using Counting = Machine<8, Mode::kCounting>;

/// Keeps a copy of every event.
struct Recorder final : Observer {
  struct Kept {
    std::string mnemonic;
    std::size_t stage;
    std::uint64_t active;
    bool overhead;
    std::uint32_t line;
    std::vector<Touch> touches;
  };
  void issued(const IssueEvent& event) override {
    events.push_back({std::string(event.info.mnemonic),
                      event.stage,
                      event.active,
                      event.overhead,
                      event.at.line(),
                      {event.touches.begin(), event.touches.end()}});
    file = event.at.file_name();
  }
  void batch_begins() override { ++batches; }

  std::vector<Kept> events;
  std::string file;
  int batches = 0;
};

constexpr std::uint32_t kFirstLine = __LINE__ + 7;

/// Three instructions under the lanes of `active`, one of them overhead, and one in all lanes.
template <class Vm>
typename Vm::Int program(Vm& vm, Memory<std::int32_t> memory, Mask<8> active) {
  auto site = vm.site(1);
  auto on = site.on(active);
  const auto index = isa::lane_index(on);
  const auto doubled = isa::add(on.overhead(), index, index);
  isa::scatter(on, memory, isa::bit_and(on, index, 1), doubled);
  return isa::gather(on, memory, doubled);
}

TEST(Tracing, TellsEveryInstructionWithItsPlace) {
  Recorder recorder;
  Tracing vm(8, 2, Mode::kTracing, &recorder);
  Buffer<std::int32_t> buffer(64, "buffer", false);
  vm.begin_batch();
  program(vm, buffer.memory(), Mask<8>::first_n(5));
  ASSERT_EQ(recorder.events.size(), 5u);
  EXPECT_EQ(recorder.batches, 1);
  EXPECT_EQ(recorder.file, "tests/simulator/tracing_test.cpp");
  const char* const kMnemonics[] = {"lane_index", "add", "bit_and", "scatter", "gather"};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(recorder.events[i].mnemonic, kMnemonics[i]);
    EXPECT_EQ(recorder.events[i].stage, 1u);
    EXPECT_EQ(recorder.events[i].active, 0b11111u);
    EXPECT_EQ(recorder.events[i].overhead, i == 1);
  }
  EXPECT_EQ(recorder.events[0].line, kFirstLine);
  EXPECT_EQ(recorder.events[1].line, kFirstLine + 1);
  EXPECT_EQ(recorder.events[4].line, kFirstLine + 3);
}

TEST(Tracing, TellsTheElementsThatMemoryInstructionsTouch) {
  Recorder recorder;
  Tracing vm(8, 2, Mode::kTracing, &recorder);
  Buffer<std::int32_t> buffer(64, "buffer", false);
  program(vm, buffer.memory(), Mask<8>::first_n(3));
  ASSERT_EQ(recorder.events.size(), 5u);
  EXPECT_TRUE(recorder.events[2].touches.empty());
  const std::vector<Touch>& stored = recorder.events[3].touches;
  const std::vector<Touch>& read = recorder.events[4].touches;
  ASSERT_EQ(stored.size(), 3u);
  ASSERT_EQ(read.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(stored[i].lane, static_cast<int>(i));
    EXPECT_EQ(stored[i].byte, 4 * (i % 2));
    EXPECT_EQ(stored[i].access, Access::kStore);
    EXPECT_EQ(read[i].byte, 8 * i);
    EXPECT_EQ(read[i].bytes, 4u);
    EXPECT_EQ(read[i].access, Access::kLoad);
  }
}

TEST(Tracing, ComputesAndTellsWhatACountingMachineCounts) {
  test::CountingObserver observer(8, 2);
  Tracing tracing(8, 2, Mode::kTracing, &observer);
  Counting counting(8, 2);
  Buffer<std::int32_t> one(64, "one", false), other(64, "other", false);
  for (int n = 0; n <= 8; ++n)
    EXPECT_EQ(program(tracing, one.memory(), Mask<8>::first_n(n)).vec.lanes(),
              program(counting, other.memory(), Mask<8>::first_n(n)).lanes());
  EXPECT_EQ(observer.counts(), counting.counts());
  EXPECT_TRUE(tracing.counts().stages.empty()) << "an observer counts, if anyone does";
}

/// Loads records of three words.
struct LoadTriple {
  static constexpr InstructionInfo kInfo{"load_triple", "", InstructionClass::kMemory};
  template <int L>
  static Vec<std::int32_t, L> apply(Mask<L>, Memory<std::int32_t>, int) {
    return {};
  }
  template <int L, class F>
  static void touch(Mask<L> active, F&& f, Memory<std::int32_t> memory, int stride) {
    for_each_lane(active, [&](int i) {
      for (int word = 0; word < 3; ++word) f(i, memory, i * stride + word, Access::kLoad);
    });
  }
};

TEST(Tracing, TellsAnyNumberOfElements) {
  Recorder recorder;
  Tracing vm(8, 1, Mode::kTracing, &recorder);
  Buffer<std::int32_t> buffer(64, "buffer", false);
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  Instruction<LoadTriple>{}(on, buffer.memory(), 3);
  ASSERT_EQ(recorder.events.size(), 1u);
  ASSERT_EQ(recorder.events[0].touches.size(), 24u);
  EXPECT_EQ(recorder.events[0].touches[23].lane, 7);
  EXPECT_EQ(recorder.events[0].touches[23].byte, 4 * 23u);
}

TEST(Tracing, TellsOfAtomicsThatTheyReadAndStore) {
  Recorder recorder;
  Tracing vm(8, 1, Mode::kTracing, &recorder);
  Buffer<std::int32_t> buffer(64, "buffer", false);
  auto site = vm.site(0);
  auto on = site.on(vm.first_n(1));
  isa::scatter_add(on, buffer.memory(), isa::lane_index(on), isa::lane_index(on));
  EXPECT_EQ(recorder.events.back().touches.at(0).access, Access::kUpdate);
  EXPECT_TRUE(recorder.events.back().touches.at(0).stores());
}

TEST(Tracing, NeedsAnObserverAndOnlyThen) {
  EXPECT_THROW(Tracing(8, 1, Mode::kTracing), CheckError);
  Recorder recorder;
  EXPECT_THROW(Tracing(8, 1, Mode::kChecked, &recorder), CheckError);
  EXPECT_THROW(Tracing(8, 1, Mode::kCounting), CheckError);
}

}  // namespace
}  // namespace lanescope
