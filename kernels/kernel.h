// SPDX-License-Identifier: MIT
// The contract of a kernel: a descriptor that names its stages and what it counts, and a function
// that starts an execution of it on a machine of a given width and mode.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "kernels/micropolygons/frame.h"
#include "simulator/base/random.h"
#include "simulator/counts.h"
#include "simulator/mode.h"
#include "simulator/observer.h"
#include "workloads/micropolygons/micropolygon.h"

namespace lanescope {

/// When the edge equations of a micropolygon are computed (the thesis, 3.2.1, "optional").
enum class Edges {
  kInline,       ///< In each Test, from the vertices.
  kPrecomputed,  ///< Once, in Bound.
};

/// What a kernel is started with, beside its width and mode.
struct KernelOptions {
  Micropolygon shape = Micropolygon::kTriangle;
  bool cull_backfaces = true;
  Edges edges = Edges::kInline;
  /// REPACK loads new work into free lanes only when at least this share of the W lanes is free,
  /// or none is busy (the thesis, 4.1.2). 0 loads whenever a lane is free.
  float stream_load_threshold = 0.0f;
};

/// How two values of a counter merge.
enum class Merge { kSum, kMaximum };

/// A figure that a kernel counts beside instructions and lanes.
struct CounterInfo {
  std::string_view name;  ///< snake_case, unique in the kernel
  std::string_view meaning;
  std::string_view unit;
  Merge merge = Merge::kSum;
};

/// A ratio of two of the kernel's counters.
struct MetricInfo {
  std::string_view name;
  std::string_view meaning;
  std::string_view numerator;    ///< Name of a counter.
  std::string_view denominator;  ///< Name of a counter.
};

/// A list of figures that a kernel counts: a histogram, or a course over time. Lists merge by
/// adding element by element.
struct SeriesInfo {
  std::string_view name;  ///< snake_case, unique in the kernel
  std::string_view meaning;
  std::string_view index;  ///< What the place in the list is.
  std::string_view unit;   ///< Of the values.
};

/// What one execution did.
struct KernelResult {
  Counts counts;                        ///< Empty stages in Mode::kUncounted.
  std::vector<std::uint64_t> counters;  ///< In the order of Kernel::counters.
  std::vector<std::vector<std::uint64_t>> series;  ///< In the order of Kernel::series.
  /// Sum over all hits (micropolygon, sample) of hit_hash: equal for equal sets of hits.
  std::uint64_t hits_hash = 0;
};

struct Kernel;

/// Merges results of executions of one kernel at one width.
void merge(const Kernel& kernel, KernelResult& into, const KernelResult& from);

/// A kernel at work: takes packets, keeps counts. Not thread-safe; use one for each thread and
/// merge their results. A packet's counts do not depend on the packets before it.
class Execution {
 public:
  virtual ~Execution() = default;
  /// Rasterizes a packet into the frame and drains. Requires the shape of the options.
  virtual void rasterize(const Packet& packet) = 0;
  virtual KernelResult result() const = 0;
};

/// What an execution is started with.
struct Launch {
  int width;
  Mode mode;
  KernelOptions options;
  Frame& frame;                  ///< Written to; must outlive the execution.
  Observer* observer = nullptr;  ///< Of Mode::kTracing; must outlive the execution.
};

/// The descriptor; kernels/<name>.cpp ends in one, and the registry lists them.
struct Kernel {
  std::string_view name;
  std::string_view summary;
  std::span<const std::string_view> stages;
  std::span<const CounterInfo> counters;
  std::span<const MetricInfo> metrics;
  std::span<const SeriesInfo> series;
  /// Those that it issues and that are not of the machine's instruction set.
  std::span<const InstructionInfo* const> instructions;
  /// Widths the kernel can be started with, ascending.
  std::span<const int> widths;
  /// Starts an execution. Requires a width among `widths`.
  std::unique_ptr<Execution> (*start)(const Launch& launch);
};

/// The contribution of one hit to KernelResult::hits_hash.
inline std::uint64_t hit_hash(std::uint64_t micropolygon_id, std::uint32_t sample) {
  return mix64(micropolygon_id * 0xd6e8feb86659fd93u ^ sample);
}

/// Every kernel, in the order of kernels/CMakeLists.txt.
const std::vector<const Kernel*>& kernels();

/// The kernel of that name. Throws InputError, with the nearest name, if there is none.
const Kernel& find_kernel(std::string_view name);

/// Every width that vector programs can be started with, ascending: 1 ... the most lanes built.
std::span<const int> built_widths();

}  // namespace lanescope
