// SPDX-License-Identifier: MIT
// The contract of a kernel: a descriptor that says what it works on, what it takes, what it counts,
// and functions that open its output and start an execution on a machine of a given width and mode.
// It knows no kind of work: kernels/<kind>/ does.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "kernels/output.h"
#include "simulator/counts.h"
#include "simulator/mode.h"
#include "simulator/observer.h"
#include "workloads/work.h"

namespace lanescope {

/// Which pieces an execution may be given.
enum class Order {
  /// Any, in any order, on any number of executions: the counts of a piece are its own, and taking
  /// it a second time changes nothing in the output.
  kAny,
  /// All, in the order of the source, on one execution: later work depends on earlier work. Whoever
  /// takes pieces a second time needs an output of its own.
  kSequential,
};

/// A ratio of two of the kernel's counters.
struct MetricInfo {
  std::string_view name;
  std::string_view meaning;
  std::string_view numerator;    ///< Name of a counter.
  std::string_view denominator;  ///< Name of a counter.
};

/// What holds of a kernel's counters, by name: the parts add up to a multiple of the whole. Readers
/// of reports check it.
struct CounterSum {
  std::string_view whole;
  std::span<const std::string_view> parts;
  std::uint64_t times = 1;
};

/// A list of figures that a kernel counts: a histogram, or a course over time. Lists merge by
/// adding element by element.
struct SeriesInfo {
  std::string_view name;  ///< snake_case, unique in the kernel
  std::string_view meaning;
  std::string_view index;  ///< What the place in the list is.
  std::string_view unit;   ///< Of the values.
};

/// What instructions are divided by to compare kernels.
struct Element {
  std::string_view counter;       ///< Name of the kernel's counter of them.
  std::string_view name;          ///< In the singular.
  std::string_view abbreviation;  ///< For tables: `Instr./<abbreviation>`.
};

/// What one execution did.
struct KernelResult {
  Counts counts;                                   ///< Without stages if nothing is counted.
  std::vector<std::uint64_t> counters;             ///< In the order of Kernel::counters.
  std::vector<std::vector<std::uint64_t>> series;  ///< In the order of Kernel::series.
  /// Sum over all results (hits, say) of a hash of each: equal for equal sets of results.
  std::uint64_t results_hash = 0;
};

/// A kernel at work: takes pieces, keeps counts. Not thread-safe.
class Execution {
 public:
  virtual ~Execution() = default;
  /// Takes a piece of the kernel's kind of work and finishes what it began.
  virtual void run(const Work& work) = 0;
  virtual KernelResult result() const = 0;
};

/// What an execution is started with. The references must outlive it.
struct Launch {
  int width;
  Mode mode;
  const Arguments& arguments;    ///< Of the workload and of the kernel, resolved.
  Output& output;                ///< Opened by the kernel for these arguments.
  Observer* observer = nullptr;  ///< Of Mode::kTracing.
};

/// The output keeps no reference to either: it may outlive both.
using OpenOutput = std::unique_ptr<Output> (*)(const Arguments& arguments, const Source& source);
using StartExecution = std::unique_ptr<Execution> (*)(const Launch& launch);

/// Something else to see of a kernel's work than its output: an execution that draws it. Is of
/// Order::kAny; its width and mode are 1 and uncounted.
struct View {
  std::string_view name;
  std::string_view summary;
  OpenOutput open;
  /// Memory that its output takes.
  std::uint64_t (*output_bytes)(const Arguments& arguments);
  StartExecution start;
};

/// The descriptor; kernels/<kind>/<name>.cpp ends in one, and the registry lists them.
struct Kernel {
  std::string_view name;
  std::string_view summary;
  const Workload* workload;
  Order order = Order::kAny;
  /// Whether it is the plain scalar reference that the other kernels of its kind agree with.
  bool is_oracle = false;
  std::vector<Parameter> parameters{};         ///< Of the kernel alone.
  std::span<const std::string_view> stages{};  ///< Empty if it issues no instructions.
  std::span<const CounterInfo> counters{};
  std::span<const CounterSum> sums{};
  std::span<const MetricInfo> metrics{};
  std::span<const SeriesInfo> series{};
  std::span<const CounterInfo> output_counters{};
  Element element;
  /// Those that it issues beside the instruction set.
  std::span<const InstructionInfo* const> instructions{};
  /// Runs at every width from 1 to this.
  int most_width = 1;
  OpenOutput open;
  /// Memory that an output takes.
  std::uint64_t (*output_bytes)(const Arguments& arguments);
  /// Starts an execution. Requires a width from 1 to most_width.
  StartExecution start;
  std::span<const View> views{};  ///< Named differently for all kernels of a kind.
};

/// Merges results of executions of one kernel at one width.
void merge(const Kernel& kernel, KernelResult& into, const KernelResult& from);

/// Every kernel of the program, in the order of its registry.
const std::vector<const Kernel*>& kernels();

/// The kernel of that name. Throws InputError, with the nearest name, if there is none.
const Kernel& find_kernel(std::string_view name);

/// The kernel of that name, or null.
const Kernel* known_kernel(std::string_view name);

}  // namespace lanescope
