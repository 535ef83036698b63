// SPDX-License-Identifier: MIT
// The contract of a kind of work: pieces that kernels take one at a time, a source that makes them,
// and a descriptor that says what there is to choose from. workloads/<kind>/ holds a kind.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/parameter.h"

namespace lanescope {

/// A piece of work: what a kernel gets at a time, of a type that its kind knows.
class Work {
 public:
  virtual ~Work() = default;
  /// What it consists of: triangles, corners, receivers.
  virtual std::uint64_t element_count() const = 0;
  /// A hash of its content and of its place. A source's hash is the sum over its pieces, modulo
  /// 2^64, so that any order gives the same.
  virtual std::uint64_t hash() const = 0;

  std::uint64_t segment = 0;  ///< Of the source that made it.
  std::uint64_t ordinal = 0;  ///< Within the segment, from 0.

 protected:
  Work() = default;
  Work(const Work&) = default;
  Work(Work&&) = default;
  Work& operator=(const Work&) = default;
  Work& operator=(Work&&) = default;
};

/// Takes pieces; a piece may be changed as soon as the call returns.
using WorkSink = std::function<void(const Work&)>;

/// Makes the pieces of a scene, in segments that are independent of one another: any number of
/// threads can take segments in any order, and the pieces are the same.
class Source {
 public:
  virtual ~Source() = default;
  virtual int segment_count() const = 0;
  /// Hands the pieces of one segment to `sink`, in order. Thread-safe. Returns what the source
  /// counted, in the order of Workload::counters.
  virtual std::vector<std::uint64_t> produce(int segment, const WorkSink& sink) const = 0;
  /// What the user should know of the scene, although it can be used: what of a file was skipped,
  /// why nothing will be seen. Sentences that begin with where.
  virtual std::vector<std::string> notes() const { return {}; }
};

/// Called with the finished share of opening a scene, from 0 to 1, on the thread that opens it.
using OpeningProgress = std::function<void(double fraction)>;

/// How two values of a counter merge.
enum class Merge { kSum, kMaximum };

/// A figure that is counted beside instructions and lanes.
struct CounterInfo {
  std::string_view name;  ///< snake_case, unique among its like.
  std::string_view meaning;
  std::string_view unit;
  Merge merge = Merge::kSum;
};

/// Merges values of counters, each by its rule. Both are in the order of `infos`, or empty.
void merge_counters(std::span<const CounterInfo> infos, std::vector<std::uint64_t>& into,
                    const std::vector<std::uint64_t>& from);

/// A rectangle of the picture, in pixels from its upper left corner.
struct Region {
  int x_px, y_px, width_px, height_px;
};

/// Lets through the elements of pieces that meet a region, in pieces of its own.
class RegionFilter {
 public:
  virtual ~RegionFilter() = default;
  virtual void take(const Work& work, const WorkSink& sink) = 0;
  /// Passes on what is left.
  virtual void flush(const WorkSink& sink) = 0;
};

/// A built-in scene as lists show it.
struct SceneInfo {
  std::string_view name;
  std::string_view summary;  ///< With what else can be chosen of it: `...; frames 0 to 23`.
};

/// The descriptor of a kind of work; workloads/<kind>/workload.cpp defines one.
struct Workload {
  std::string_view name;  ///< Of the kind, a plural.
  std::string_view summary;
  /// Of its sources. Names and options differ from those of its kernels.
  std::vector<Parameter> parameters{};
  std::span<const CounterInfo> counters{};  ///< Of its sources.
  /// The parameter whose values tables and charts show side by side, as they show kernels; empty if
  /// there is none. Runs that differ in others are of different settings.
  std::string_view facet{};
  std::vector<SceneInfo> scenes;  ///< At least one; the first is the default.
  /// Scenes that are no built-in name are files of this ending (`.obj`), whatever its case; empty
  /// if there are none. `file_kind` says what they are: `a mesh`.
  std::string_view file_ending{};
  std::string_view file_kind{};

  /// Completes arguments in which every parameter has a value or nothing: sets what the scene
  /// decides. Throws ParameterError for what does not fit together. Does not open files.
  void (*resolve)(const std::string& scene, Arguments& arguments);
  /// Opens a scene. `progress` may be empty. Throws InputError if a file cannot be used.
  std::unique_ptr<Source> (*open)(const std::string& scene, const Arguments& arguments,
                                  const OpeningProgress& progress);
  /// A figure in proportion to the time that a run takes, to weigh runs against each other.
  double (*expected_work)(const Arguments& arguments);
  /// Throws ParameterError for a region that is not in the picture. Null if the kind has no
  /// regions.
  std::unique_ptr<RegionFilter> (*filter)(const Region& region,
                                          const Arguments& arguments) = nullptr;

  bool is_file(std::string_view scene) const;
  const SceneInfo* find_scene(std::string_view name) const;
};

/// Every kind of work of the program, in the order of its registry.
const std::vector<const Workload*>& workloads();

}  // namespace lanescope
