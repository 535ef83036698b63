// SPDX-License-Identifier: MIT
#include "tests/analysis/test_kind.h"

#include <algorithm>
#include <array>
#include <bit>
#include <fstream>
#include <source_location>

#include "simulator/base/random.h"

namespace lanescope {
namespace {

// ---- The kind of work

enum class Parity { kEven, kOdd };
constexpr std::array<Choice<Parity>, 2> kParities{{{"even", Parity::kEven}, {"odd", Parity::kOdd}}};

struct NumbersOptions {
  std::optional<int> segments;  ///< A file is one segment.
  int pieces = 4;
  int piece_size = 10;
  Parity parity = Parity::kEven;
};

const Parameters<NumbersOptions>& numbers_parameters() {
  using N = NumbersOptions;
  static const Parameters<N> all{
      {&N::segments, {"segments", "--segments", "segments", "Segments of numbers"}, 1, 64},
      {&N::pieces, {"segment_pieces", "--segment-pieces", "pieces", "Pieces of a segment"}, 1, 64},
      {&N::piece_size, {"piece_size", "--piece-size", "numbers", "Numbers of a piece"}, 1, 1000},
      {&N::parity, {"parity", "--parity", kNoUnit, "Whether numbers are even or odd"}, kParities},
  };
  return all;
}

constexpr std::array<CounterInfo, 2> kNumbersCounters{
    {{"numbers_made", "numbers that the source made", "numbers"},
     {"most_in_a_piece", "numbers of the largest piece", "numbers", Merge::kMaximum}}};

/// Hands out numbers of the parity that is asked for, in pieces.
class NumbersSource final : public Source {
 public:
  /// Without values they are made: scattered, or rising with the place.
  NumbersSource(const NumbersOptions& options, bool rising, std::vector<std::uint64_t> values = {})
      : options_(options), rising_(rising), values_(std::move(values)) {}

  int segment_count() const override { return options_.segments.value_or(1); }

  std::vector<std::uint64_t> produce(int segment, const WorkSink& sink) const override {
    const std::size_t count = values_.empty()
                                  ? static_cast<std::size_t>(options_.pieces * options_.piece_size)
                                  : values_.size();
    Numbers piece;
    piece.segment = static_cast<std::uint64_t>(segment);
    std::uint64_t most = 0;
    const auto flush = [&] {
      if (piece.values.empty()) return;
      most = std::max<std::uint64_t>(most, piece.values.size());
      sink(piece);
      piece.values.clear();
      ++piece.ordinal;
    };
    for (std::size_t i = 0; i < count; ++i) {
      piece.values.push_back(number(segment, i, count));
      if (piece.values.size() == static_cast<std::size_t>(options_.piece_size)) flush();
    }
    flush();
    return {count, most};
  }

 private:
  std::uint64_t number(int segment, std::size_t i, std::size_t count) const {
    const std::uint64_t place = static_cast<std::uint64_t>(segment) * count + i;
    const std::uint64_t value = !values_.empty() ? values_[i]
                                : rising_        ? place
                                                 : mix64(place) % 1000;
    return 2 * value + (options_.parity == Parity::kOdd ? 1 : 0);
  }

  NumbersOptions options_;
  bool rising_;
  std::vector<std::uint64_t> values_;
};

void resolve_numbers(const std::string& scene, Arguments& arguments) {
  if (w_numbers.is_file(scene)) {
    arguments.set("segments", {});
    return;
  }
  auto options = decoded(numbers_parameters(), arguments);
  if (!options.segments) arguments.set("segments", std::uint64_t{3});
  const int pieces = options.segments.value_or(3) * options.pieces;
  if (pieces > 200)
    throw ParameterError(
        numbers_parameters()[1].parameter().words,
        fmt::format("{} pieces are too many; use at most 200 in all segments", pieces));
}

std::unique_ptr<Source> open_numbers(const std::string& scene, const Arguments& arguments,
                                     const OpeningProgress& /*progress*/) {
  const auto options = decoded(numbers_parameters(), arguments);
  if (!w_numbers.is_file(scene)) {
    if (!w_numbers.find_scene(scene)) throw InputError("--scene", "there is no '{}'", scene);
    return std::make_unique<NumbersSource>(options, scene == "rising");
  }
  std::ifstream file(scene);
  if (!file) throw InputError(scene, "cannot be opened");
  std::vector<std::uint64_t> values;
  for (std::uint64_t value = 0; file >> value;) values.push_back(value);
  if (values.empty()) throw InputError(scene, "has no numbers");
  return std::make_unique<NumbersSource>(options, false, std::move(values));
}

double expected_numbers(const Arguments& arguments) {
  const auto options = decoded(numbers_parameters(), arguments);
  return static_cast<double>(options.segments.value_or(1)) * options.pieces * options.piece_size;
}

// ---- The kernels

constexpr InstructionInfo kLoadNumbers{"load_numbers", "numbers of a piece",
                                       InstructionClass::kMemory};
constexpr InstructionInfo kAddNumbers{"add_numbers", "adds numbers to a sum",
                                      InstructionClass::kArithmetic};
constexpr InstructionInfo kRaise{"raise", "the highest number so far",
                                 InstructionClass::kArithmetic};
constexpr std::array<const InstructionInfo*, 3> kInstructions{&kLoadNumbers, &kAddNumbers, &kRaise};

enum Stage : std::size_t { kAdd, kRaised };
constexpr std::string_view kStages[] = {"Add", "Raise"};

/// A machine that counts what it is told and computes nothing.
class TellingMachine {
 public:
  TellingMachine(const Launch& launch, std::size_t stages)
      : width_(launch.width),
        observer_(launch.observer),
        counts_(launch.width, launch.mode == Mode::kUncounted ? 0 : stages) {}

  int width() const { return width_; }
  void begin_batch() {
    if (observer_) observer_->batch_begins();
  }
  void issue(const InstructionInfo& info, std::size_t stage, std::uint64_t active,
             std::span<const Touch> touches = {},
             std::source_location at = std::source_location::current()) {
    const IssueEvent event{info, stage, width_, active, false, at, touches};
    if (observer_) observer_->issued(event);
    if (counts_.stages.empty()) return;
    counts_.add(stage, {&info, 1, event.charged(), 0, 0});
    StageCounts& counts = counts_.stages[stage];
    for (int lane = 0; lane < width_; ++lane)
      counts.lane_active[static_cast<std::size_t>(lane)] += active >> lane & 1;
    counts.histogram[static_cast<std::size_t>(std::popcount(active))] += 1;
  }
  const Counts& counts() const { return counts_; }

 private:
  int width_;
  Observer* observer_;
  Counts counts_;
};

/// Goes through a piece in batches of W numbers, loading them.
template <class Batch>
void for_batches(TellingMachine& vm, const Numbers& piece, const Batch& batch) {
  const auto width = static_cast<std::size_t>(vm.width());
  for (std::size_t first = 0; first < piece.values.size(); first += width) {
    const std::size_t size = std::min(width, piece.values.size() - first);
    std::vector<Touch> touches;
    for (std::size_t i = 0; i < size; ++i)
      touches.push_back({static_cast<int>(i), 8 * (first + i), 8, Access::kLoad});
    const std::uint64_t active = size == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << size) - 1;
    vm.begin_batch();
    vm.issue(kLoadNumbers, kAdd, active, touches);
    vm.issue(kAddNumbers, kAdd, active);
    batch(std::span(piece.values).subspan(first, size));
  }
}

struct SumOptions {
  std::optional<std::uint64_t> refused;
};

const Parameters<SumOptions>& sum_parameters() {
  static const Parameters<SumOptions> all{
      {&SumOptions::refused,
       {"refused", "--refused", kNoUnit, "A number that the kernel cannot take"},
       0,
       1 << 20},
  };
  return all;
}

class Sum final : public Execution {
 public:
  explicit Sum(const Launch& launch)
      : refused_(decoded(sum_parameters(), launch.arguments).refused),
        output_(static_cast<NumberForEachPiece&>(launch.output)),
        vm_(launch, 1) {}

  void run(const Work& work) override {
    std::uint64_t sum = 0;
    for_batches(vm_, static_cast<const Numbers&>(work), [&](auto numbers) {
      for (const std::uint64_t number : numbers) {
        if (number == refused_) throw InputError("--refused", "{} is refused", number);
        ++numbers_;
        sum += number;
        results_hash_ += mix64(number);
      }
    });
    sum_ += sum;
    output_.write(work, sum);
  }

  KernelResult result() const override {
    return {vm_.counts(), {numbers_, sum_}, {}, results_hash_};
  }

 private:
  std::optional<std::uint64_t> refused_;
  NumberForEachPiece& output_;
  TellingMachine vm_;
  std::uint64_t numbers_ = 0;
  std::uint64_t sum_ = 0;
  std::uint64_t results_hash_ = 0;
};

struct RunningSumOptions {
  std::uint64_t start = 0;
};

const Parameters<RunningSumOptions>& running_sum_parameters() {
  static const Parameters<RunningSumOptions> all{
      {&RunningSumOptions::start,
       {"start", "--start", kNoUnit, "What the sum starts with"},
       0,
       1 << 20},
  };
  return all;
}

class RunningSum final : public Execution {
 public:
  explicit RunningSum(const Launch& launch)
      : start_(decoded(running_sum_parameters(), launch.arguments).start),
        output_(static_cast<NumberForEachPiece&>(launch.output)),
        vm_(launch, 2) {}

  void run(const Work& work) override {
    for_batches(vm_, static_cast<const Numbers&>(work), [&](auto numbers) {
      std::uint64_t raised = 0;
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        ++numbers_;
        output_.running_sum += numbers[i];
        if (output_.highest && numbers[i] <= *output_.highest) continue;
        output_.highest = numbers[i];
        results_hash_ += mix64(numbers[i]);
        ++highs_;
        raised |= std::uint64_t{1} << i;
      }
      if (raised != 0) vm_.issue(kRaise, kRaised, raised);
    });
    output_.write(work, start_ + output_.running_sum);
  }

  KernelResult result() const override {
    return {vm_.counts(), {numbers_, highs_}, {}, results_hash_};
  }

 private:
  std::uint64_t start_;
  NumberForEachPiece& output_;
  TellingMachine vm_;
  std::uint64_t numbers_ = 0;
  std::uint64_t highs_ = 0;
  std::uint64_t results_hash_ = 0;
};

template <class Kind>
std::unique_ptr<Execution> start(const Launch& launch) {
  return std::make_unique<Kind>(launch);
}

std::unique_ptr<Output> open_output(const Arguments&, const Source&) {
  return std::make_unique<NumberForEachPiece>();
}

std::uint64_t output_bytes(const Arguments& arguments) {
  const auto options = decoded(numbers_parameters(), arguments);
  return std::uint64_t{8} * static_cast<std::uint64_t>(options.segments.value_or(1)) *
         static_cast<std::uint64_t>(options.pieces);
}

constexpr std::array<CounterInfo, 2> kSumCounters{
    {{"numbers", "numbers added", "numbers"}, {"sum", "sum of all numbers", ""}}};
constexpr std::array<CounterInfo, 2> kRunningSumCounters{
    {{"numbers", "numbers added", "numbers"},
     {"highs", "numbers that are higher than all before", "numbers"}}};
constexpr std::array<MetricInfo, 1> kMetrics{
    {{"highs_share", "numbers that are higher than all before, of all", "highs", "numbers"}}};
constexpr std::array<CounterInfo, 1> kOutputCounters{
    {{"pieces_written", "pieces that have a number", "pieces"}}};
const std::array<View, 1> kSums{
    {{"sums", "the sum of each piece", open_output, output_bytes, start<Sum>}}};

}  // namespace

std::uint64_t Numbers::hash() const {
  std::uint64_t hash = mix64(segment) ^ mix64(ordinal + 1);
  for (const std::uint64_t value : values) hash = mix64(hash ^ value);
  return hash;
}

void NumberForEachPiece::write(const Work& piece, std::uint64_t number) {
  const std::scoped_lock lock(mutex_);
  numbers_[{piece.segment, piece.ordinal}] = number;
}

std::uint64_t NumberForEachPiece::hash() const {
  std::uint64_t hash = 0;
  for (const auto& [place, number] : numbers_)
    hash = mix64(mix64(hash ^ place.first) ^ place.second) ^ mix64(number);
  return hash;
}

std::vector<std::uint64_t> NumberForEachPiece::counters() const { return {numbers_.size()}; }

bool NumberForEachPiece::reopen(const Arguments&, const Source&) {
  numbers_.clear();
  running_sum = 0;
  highest.reset();
  return true;
}

const Workload w_numbers{
    .name = "numbers",
    .summary = "lists of numbers, for tests",
    .parameters = joined(numbers_parameters()),
    .counters = kNumbersCounters,
    .facet = "parity",
    .scenes = {{"scattered", "numbers in no order"}, {"rising", "each number higher"}},
    .file_ending = ".numbers",
    .file_kind = "a number list",
    .resolve = resolve_numbers,
    .open = open_numbers,
    .expected_work = expected_numbers,
    .filter = nullptr,
};

const Kernel k_sum{
    .name = "sum",
    .summary = "the sum of each piece, for tests",
    .workload = &w_numbers,
    .parameters = joined(sum_parameters()),
    .stages = std::span(kStages).first<1>(),
    .counters = kSumCounters,
    .metrics = {},
    .series = {},
    .output_counters = kOutputCounters,
    .element = {"numbers", "number", "num"},
    .instructions = std::span(kInstructions).first<2>(),
    .most_width = 64,
    .open = open_output,
    .output_bytes = output_bytes,
    .start = start<Sum>,
    .views = kSums,
};

const Kernel k_running_sum{
    .name = "running_sum",
    .summary = "the sum of all numbers so far, for tests",
    .workload = &w_numbers,
    .order = Order::kSequential,
    .parameters = joined(running_sum_parameters()),
    .stages = kStages,
    .counters = kRunningSumCounters,
    .metrics = kMetrics,
    .series = {},
    .output_counters = kOutputCounters,
    .element = {"numbers", "number", "num"},
    .instructions = kInstructions,
    .most_width = 64,
    .open = open_output,
    .output_bytes = output_bytes,
    .start = start<RunningSum>,
    .views = {},
};

}  // namespace lanescope
