// SPDX-License-Identifier: MIT
// Memory and source lines: by hand for a few instructions, and against the counts of a whole run.
#include "analysis/experiment/observation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "analysis/annotation/sources.h"
#include "analysis/experiment/experiment.h"
#include "simulator/base/random.h"
#include "simulator/instruction_set.h"
#include "tests/analysis/configured.h"
#include "tests/analysis/test_kind.h"

namespace lanescope {
namespace {

using Vm = SlowMachine<8>;
using Ints = Vec<std::int32_t, 8>;

Ints ints(std::initializer_list<int> values) {
  Ints v;
  int i = 0;
  for (const int value : values) v.set(i++, value);
  return v;
}

constexpr std::string_view kStages[] = {"Only"};

class Observing : public ::testing::Test {
 protected:
  MemoryAndSource seen;
  Vm vm{8, 1, Mode::kTracing, &seen};
  Buffer<std::int32_t> buffer{256, "buffer", false};

  MemoryRecord only_memory() {
    const std::vector<MemoryRecord> memory = seen.memory(0);
    EXPECT_EQ(memory.size(), 1u);
    return memory.empty() ? MemoryRecord{} : memory.front();
  }
};

TEST_F(Observing, CountsDistinctLinesOfAGather) {
  auto site = vm.site(0);
  // A line has 16 elements: these are in lines 0, 0, 1, 1, 2, 15, 15, 0.
  const Ints index = ints({0, 15, 16, 31, 32, 240, 255, 3});
  isa::gather(site.on(Mask<8>::all()), buffer.memory(), index);
  isa::gather(site.on(Mask<8>::first_n(4)), buffer.memory(), index);
  isa::gather(site.on(Mask<8>::none()), buffer.memory(), index);
  const MemoryRecord gather = only_memory();
  EXPECT_EQ(gather.mnemonic, "gather");
  EXPECT_EQ(gather.issued, 3u);
  EXPECT_EQ(gather.active, 12u);
  EXPECT_EQ(gather.lines, 4u + 2u);
  EXPECT_EQ(gather.lines_histogram, (std::vector<std::uint64_t>{1, 0, 1, 0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(gather.conflicts, 0u);
}

TEST_F(Observing, CountsLanesThatStoreToOneElement) {
  auto site = vm.site(0);
  const Ints index = ints({7, 7, 8, 7, 8, 9, 10, 11});
  isa::scatter(site.on(Mask<8>::all()), buffer.memory(), index, index);
  EXPECT_EQ(only_memory().conflicts, 3u);
  isa::scatter(site.on(Mask<8>::first_n(2)), buffer.memory(), index, index);
  EXPECT_EQ(only_memory().conflicts, 4u);
}

TEST_F(Observing, APairIsOneLaneInConflict) {
  auto site = vm.site(0);
  const Ints index = ints({1, 1, 2, 3, 4, 5, 6, 7});
  isa::scatter_pair(site.on(Mask<8>::all()), buffer.memory(), index, index, index);
  EXPECT_EQ(only_memory().conflicts, 1u);
  EXPECT_EQ(only_memory().lines, 1u);
}

/// Records of several words, far apart: more lines than lanes.
struct GatherTriple {
  static constexpr InstructionInfo kInfo{"gather_triple", "", InstructionClass::kMemory,
                                         Charge::kOneLane};
  template <int L>
  static Ints apply(Mask<L>, Memory<std::int32_t>, int) {
    return {};
  }
  template <int L, class F>
  static void touch(Mask<L> active, F&& f, Memory<std::int32_t> memory, int stride) {
    for_each_lane(active, [&](int i) {
      for (int word = 0; word < 3; ++word) f(i, memory, (3 * i + word) * stride, Access::kLoad);
    });
  }
};

TEST_F(Observing, CountsMoreLinesThanLanes) {
  auto site = vm.site(0);
  Instruction<GatherTriple>{}(site.on(vm.first_n(5)), buffer.memory(), 16);
  const MemoryRecord memory = only_memory();
  EXPECT_EQ(memory.lines, 15u);
  ASSERT_EQ(memory.lines_histogram.size(), 16u);
  EXPECT_EQ(memory.lines_histogram[15], 1u);
  EXPECT_EQ(memory.active, 5u) << "the lanes that access memory, whatever is charged";
}

TEST_F(Observing, CountsTheGroupsOfLanes) {
  auto site = vm.site(0);
  isa::add(site.on(Mask<8>::from_bits(0b10000110)), ints({1, 2, 3}), 1);
  isa::add(site.on(Mask<8>::first_n(1)), ints({1, 2, 3}), 1);
  isa::add(site.on(Mask<8>::none()), ints({1, 2, 3}), 1);
  const std::vector<LaneGroupRecord> records = seen.lane_groups(0);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].mnemonic, "add");
  EXPECT_EQ(records[0].issued, 3u);
  EXPECT_EQ(records[0].groups.active, (GroupCounts{3 + 1, 3 + 1, 2 + 1, 1 + 1, 2, 2, 2}));
  EXPECT_EQ(records[0].groups.dense, (GroupCounts{3 + 1, 2 + 1, 1 + 1, 1 + 1, 2, 2, 2}));
}

TEST(LaneGroups, AreWhatALoopCounts) {
  for (std::uint64_t round = 0; round < 500; ++round) {
    const std::uint64_t mask = mix64(round) & mix64(round / 3 + 7);
    const LaneGroups groups = lane_groups_of(mask);
    for (std::size_t place = 0; place < kGroupLanes.size(); ++place) {
      std::uint64_t active = 0, lanes = 0;
      for (int first = 0; first < 64; first += kGroupLanes[place]) {
        const int size = kGroupLanes[place];
        const auto on = std::popcount(mask >> first & low_bits(size));
        active += on > 0;
        lanes += static_cast<std::uint64_t>(on);
      }
      const auto size = static_cast<std::uint64_t>(kGroupLanes[place]);
      EXPECT_EQ(groups.active[place], active);
      EXPECT_EQ(groups.dense[place], (lanes + size - 1) / size);
    }
  }
}

TEST(FewNumbers, AreDistinct) {
  FewNumbers set;
  for (int round = 0; round < 2; ++round) {
    set.clear();
    EXPECT_EQ(set.size(), 0u);
    for (std::uint64_t i = 0; i < 3000; ++i) EXPECT_TRUE(set.insert(i * 64));
    for (std::uint64_t i = 0; i < 3000; ++i) EXPECT_FALSE(set.insert(i * 64));
    EXPECT_EQ(set.size(), 3000u);
  }
}

TEST_F(Observing, CountsConflictsOfAtomics) {
  auto site = vm.site(0);
  const Ints index = ints({7, 7, 8, 7, 8, 9, 10, 11});
  isa::scatter_add(site.on(vm.all()), buffer.memory(), index, index);
  EXPECT_EQ(only_memory().conflicts, 3u);
}

TEST_F(Observing, AddsUpByLineOfSource) {
  auto site = vm.site(0);
  constexpr std::uint32_t kLine = __LINE__ + 3;
  for (int n = 1; n <= 3; ++n) {
    auto on = site.on(Mask<8>::first_n(n));
    const auto twice = isa::add(on, ints({1, 2, 3}), 1);
    isa::add(on.overhead(), twice, 1);
  }
  const auto lines = seen.source_lines(kStages);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].place.file, "tests/analysis/observation_test.cpp");
  EXPECT_EQ(lines[0].place.line, kLine);
  EXPECT_EQ(lines[0].stage, "Only");
  EXPECT_EQ(lines[0].issued, 3u);
  EXPECT_EQ(lines[0].active, 6u);
  EXPECT_EQ(lines[0].overhead, 0u);
  EXPECT_EQ(lines[1].place.line, kLine + 1);
  EXPECT_EQ(lines[1].overhead, 3u);
}

/// What a helper issues, for whoever calls it.
template <class On>
auto helped(On& on, const Ints& v) {
  return isa::add(on, v, 1);
}

TEST_F(Observing, TellsTheBlocksOfALineApart) {
  auto site = vm.site(0);
  constexpr std::uint32_t kLine = __LINE__ + 1;
  auto one = site.on(vm.first_n(3));
  auto other = site.on(vm.first_n(5));
  for (int n = 0; n < 2; ++n) helped(one, ints({1, 2, 3}));
  auto extra = other.overhead();
  helped(extra, ints({1, 2, 3}));
  const auto lines = seen.source_lines(kStages);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].place.line, lines[1].place.line);
  EXPECT_EQ(lines[0].block, (SourcePlace{"tests/analysis/observation_test.cpp", kLine}));
  EXPECT_EQ(lines[0].issued, 2u);
  EXPECT_EQ(lines[0].active, 6u);
  EXPECT_EQ(lines[1].block, (SourcePlace{"tests/analysis/observation_test.cpp", kLine + 1}));
  EXPECT_EQ(lines[1].active, 5u);
  EXPECT_EQ(lines[1].overhead, 1u);
}

TEST_F(Observing, AddsToOthers) {
  auto site = vm.site(0);
  isa::gather(site.on(Mask<8>::all()), buffer.memory(), ints({0, 16, 32, 0, 0, 0, 0, 0}));
  MemoryAndSource sum;
  sum += seen;
  sum += seen;
  ASSERT_EQ(sum.memory(0).size(), 1u);
  EXPECT_EQ(sum.memory(0)[0].issued, 2u);
  EXPECT_EQ(sum.memory(0)[0].lines, 6u);
  EXPECT_EQ(sum.memory(0)[0].lines_histogram[3], 2u);
  EXPECT_EQ(sum.source_lines(kStages).at(0).issued, 2u);
}

TEST(ObservedPieces, AreEveryNthOfASegment) {
  const auto observed = [](std::uint64_t segment, std::uint64_t ordinal, int every) {
    Numbers piece;
    piece.segment = segment;
    piece.ordinal = ordinal;
    return is_observed(piece, every);
  };
  EXPECT_TRUE(observed(0, 0, 16));
  EXPECT_FALSE(observed(0, 1, 16));
  EXPECT_TRUE(observed(0, 16, 16));
  EXPECT_TRUE(observed(3, 13, 16));
  EXPECT_FALSE(observed(0, 0, 0));
  EXPECT_TRUE(observed(5, 7, 1));
}

/// A whole run of which every piece is observed agrees with what the machine counted.
class WholeRun : public ::testing::TestWithParam<std::tuple<const char*, unsigned, const char*>> {
 protected:
  RunRecord run(unsigned observe_every) const {
    const auto& [kernel, width, micropolygon] = GetParam();
    const Configuration c = testing::configured({{"kernel", kernel},
                                                 {"width_lanes", width},
                                                 {"micropolygon", micropolygon},
                                                 {"scene", "teapot"},
                                                 {"width_px", 64u},
                                                 {"height_px", 40u},
                                                 {"packet_capacity", 500u},
                                                 {"observe_every", observe_every}});
    ExperimentOptions options;
    options.threads = 2;
    return run_experiment({c}, options).runs.front();
  }
};

TEST_P(WholeRun, SourceLinesAddUpToTheCounts) {
  const RunRecord all = run(1);
  EXPECT_GT(all.source.pieces, 1u);
  EXPECT_EQ(all.source.pieces_observed, all.source.pieces);
  for (const StageRecord& stage : all.stages) {
    SourceLineRecord sum;
    for (const SourceLineRecord& line : all.source_lines) {
      if (line.stage != stage.name) continue;
      sum.issued += line.issued;
      sum.active += line.active;
      sum.overhead += line.overhead;
      EXPECT_FALSE(source_line(line.place.file, line.place.line).empty())
          << line.place.file << ":" << line.place.line;
      ASSERT_TRUE(line.block) << line.place.file << ":" << line.place.line;
      const std::string_view opening = source_line(line.block->file, line.block->line);
      EXPECT_NE(opening.find(".on("), opening.npos) << line.block->file << ":" << line.block->line;
    }
    EXPECT_EQ(sum.issued, stage.total().issued) << stage.name;
    EXPECT_EQ(sum.active, stage.total().active) << stage.name;
    EXPECT_EQ(sum.overhead, stage.total().overhead_issued) << stage.name;
  }
}

TEST_P(WholeRun, GroupsOfOneLaneAreTheLanesCounted) {
  const RunRecord all = run(1);
  for (const StageRecord& stage : all.stages) {
    ASSERT_EQ(stage.lane_groups.size(), stage.instructions.size()) << stage.name;
    for (std::size_t i = 0; i < stage.instructions.size(); ++i) {
      const InstructionRecord& counts = stage.instructions[i];
      const LaneGroupRecord& record = stage.lane_groups[i];
      EXPECT_EQ(record.mnemonic, counts.mnemonic);
      EXPECT_EQ(record.issued, counts.issued) << counts.mnemonic;
      EXPECT_EQ(record.groups.active.front(), counts.active) << counts.mnemonic;
      EXPECT_EQ(record.groups.dense.front(), counts.active) << counts.mnemonic;
    }
  }
}

TEST_P(WholeRun, MemoryAddsUpToTheCounts) {
  const RunRecord all = run(1);
  bool saw_frame = false;
  for (const StageRecord& stage : all.stages)
    for (const MemoryRecord& memory : stage.memory) {
      const auto counted =
          std::find_if(stage.instructions.begin(), stage.instructions.end(),
                       [&](const auto& i) { return i.mnemonic == memory.mnemonic; });
      ASSERT_NE(counted, stage.instructions.end()) << memory.mnemonic;
      EXPECT_EQ(memory.issued, counted->issued) << memory.mnemonic;
      EXPECT_EQ(memory.active, counted->active) << memory.mnemonic;
      EXPECT_EQ(std::accumulate(memory.lines_histogram.begin(), memory.lines_histogram.end(),
                                std::uint64_t{0}),
                memory.issued);
      EXPECT_LE(memory.lines, memory.active);
      if (memory.mnemonic == "frame_merge") {
        saw_frame = true;
        EXPECT_EQ(memory.conflicts, all.counter("conflict_hits"));
      } else {
        EXPECT_EQ(memory.conflicts, 0u) << memory.mnemonic;
      }
    }
  EXPECT_TRUE(saw_frame);
}

TEST_P(WholeRun, ObservingChangesNothingElse) {
  const RunRecord all = run(1);
  const RunRecord some = run(3);
  const RunRecord none = run(0);
  EXPECT_EQ(none.source.pieces_observed, 0u);
  EXPECT_TRUE(none.source_lines.empty());
  EXPECT_TRUE(none.stages.back().memory.empty());
  EXPECT_LT(some.source.pieces_observed, some.source.pieces);
  EXPECT_FALSE(some.source_lines.empty());
  for (const RunRecord* other : {&some, &none}) {
    EXPECT_EQ(other->output.hash, all.output.hash);
    EXPECT_EQ(other->results_hash, all.results_hash);
    for (std::size_t i = 0; i < all.stages.size(); ++i)
      EXPECT_EQ(other->stages[i].histogram, all.stages[i].histogram);
    for (std::size_t i = 0; i < all.counters.size(); ++i)
      EXPECT_EQ(other->counters[i].value, all.counters[i].value);
  }
}

TEST_P(WholeRun, TheWorkingSetsHistogramAndCourseAddUpToItsSum) {
  const RunRecord all = run(0);
  const SeriesRecord* histogram = all.find_series("working_set_histogram");
  if (all.configuration.kernel == "lockstep") {
    EXPECT_EQ(histogram, nullptr);
    return;
  }
  const SeriesRecord* sums = all.find_series("working_set_course_sum");
  const SeriesRecord* packets = all.find_series("working_set_course_packets");
  ASSERT_TRUE(histogram && sums && packets);
  std::uint64_t observations = 0, sum = 0;
  for (std::size_t k = 0; k < histogram->values.size(); ++k) {
    observations += histogram->values[k];
    sum += k * histogram->values[k];
  }
  EXPECT_EQ(observations, all.counter("working_set_observations"));
  EXPECT_EQ(sum, all.counter("working_set_sum"));
  EXPECT_EQ(histogram->values.size() - 1, all.counter("working_set_maximum"));
  const auto total = [](const SeriesRecord& series) {
    return std::accumulate(series.values.begin(), series.values.end(), std::uint64_t{0});
  };
  EXPECT_EQ(total(*sums), sum);
  EXPECT_EQ(total(*packets), observations);
  // A packet that is culled as a whole has no Bound.
  EXPECT_LE(packets->values.front(), all.source.pieces);
  EXPECT_TRUE(std::is_sorted(packets->values.rbegin(), packets->values.rend()));
}

INSTANTIATE_TEST_SUITE_P(Kernels, WholeRun,
                         ::testing::Combine(::testing::Values("lockstep", "repack"),
                                            ::testing::Values(8u, 64u),
                                            ::testing::Values("triangle", "quad")),
                         [](const auto& info) {
                           return fmt::format("{}_W{}_{}", std::get<0>(info.param),
                                              std::get<1>(info.param), std::get<2>(info.param));
                         });

}  // namespace
}  // namespace lanescope
