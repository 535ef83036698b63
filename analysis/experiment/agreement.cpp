// SPDX-License-Identifier: MIT
#include "analysis/experiment/agreement.h"

#include <algorithm>
#include <numeric>

#include "analysis/base/json_text.h"
#include "analysis/base/memory.h"
#include "analysis/configuration/configuration_json.h"
#include "simulator/base/error.h"
#include "simulator/base/random.h"

namespace lanescope {
namespace {

/// The width at which the first vector program of a kind makes the output to compare with.
constexpr int kWidthOfOutput = 16;

const Kernel& first_vector_program(const Workload& workload) {
  for (const Kernel* kernel : kernels())
    if (kernel->workload == &workload && !kernel->stages.empty()) return *kernel;
  return *oracle_of(workload);
}

/// Segments in an order that spreads any number of the first of them.
std::vector<int> spread_segments(const Source& source) {
  std::vector<int> segments(static_cast<std::size_t>(source.segment_count()));
  std::iota(segments.begin(), segments.end(), 0);
  std::stable_sort(segments.begin(), segments.end(), [](int a, int b) {
    return mix64(static_cast<std::uint64_t>(a)) < mix64(static_cast<std::uint64_t>(b));
  });
  return segments;
}

/// The first counter that both have in which they differ: `<name> is <found>, not <expected>`.
std::optional<std::string> differing_counter(const Kernel& kernel,
                                             const std::vector<std::uint64_t>& found,
                                             const Kernel& oracle,
                                             const std::vector<std::uint64_t>& expected) {
  for (std::size_t i = 0; i < oracle.counters.size(); ++i)
    for (std::size_t k = 0; k < kernel.counters.size(); ++k)
      if (kernel.counters[k].name == oracle.counters[i].name && found[k] != expected[i])
        return fmt::format("{} is {}, not {}", oracle.counters[i].name, found[k], expected[i]);
  return std::nullopt;
}

}  // namespace

const Kernel* oracle_of(const Workload& workload) {
  for (const Kernel* kernel : kernels())
    if (kernel->workload == &workload && kernel->is_oracle) return kernel;
  return nullptr;
}

Agreement::Agreement(const Configuration& configuration, int pieces, const OpeningListener& opening)
    : chosen_for_(configuration), source_(open_source(configuration, opening)) {
  for (const int segment : spread_segments(*source_)) {
    if (pieces != 0 && piece_count_ >= static_cast<std::size_t>(pieces)) break;
    std::size_t found = 0;
    source_->produce(segment, [&](const Work&) { ++found; });
    if (found == 0) continue;
    segments_.push_back(segment);
    piece_count_ += found;
  }
  std::sort(segments_.begin(), segments_.end());
}

Agreement::Trail Agreement::trail_of(const Configuration& configuration) const {
  const Kernel& kernel = find_kernel(configuration.kernel);
  require_memory(kernel.output_bytes(configuration.arguments));
  const std::unique_ptr<Output> output = kernel.open(configuration.arguments, *source_);
  const auto execution =
      kernel.start({configuration.width, configuration.mode, configuration.arguments, *output});
  Trail trail;
  try {
    for (const int segment : segments_)
      source_->produce(segment, [&](const Work& piece) {
        trail.steps.push_back({piece.segment, piece.ordinal, 0, {}});
        execution->run(piece);
        KernelResult result = execution->result();
        trail.steps.back().results_hash = result.results_hash;
        trail.steps.back().counters = std::move(result.counters);
      });
  } catch (const CheckError& error) {
    trail.complaint = error.what();
  }
  trail.output_hash = output->hash();
  return trail;
}

const Agreement::Trail& Agreement::trail_of(const Kernel& other,
                                            const Configuration& configuration) {
  Arguments given = all_values(configuration);
  given.set("kernel", std::string(other.name));
  given.set("width_lanes", static_cast<std::uint64_t>(std::min(kWidthOfOutput, other.most_width)));
  given.set("mode", std::string(name_of(kModes, Mode::kCounting)));
  const Configuration its = resolved(given);
  const auto [known, is_new] = known_.try_emplace(configuration_json(its).dump());
  if (is_new) known->second = trail_of(its);
  return known->second;
}

std::optional<std::string> Agreement::difference(const Configuration& configuration) {
  const Workload& workload = workload_of(configuration);
  const Kernel& kernel = find_kernel(configuration.kernel);
  const Kernel& oracle = *oracle_of(workload);
  const Trail& expected = trail_of(oracle, configuration);
  const Trail found = trail_of(configuration);
  for (std::size_t i = 0; i < found.steps.size(); ++i) {
    const Step& step = found.steps[i];
    const std::string place = fmt::format("piece {} of segment {}: ", step.ordinal, step.segment);
    if (!found.complaint.empty() && i + 1 == found.steps.size()) return place + found.complaint;
    if (configuration.mode != Mode::kUncounted)
      if (const auto counter =
              differing_counter(kernel, step.counters, oracle, expected.steps[i].counters))
        return place + *counter;
    if (step.results_hash != expected.steps[i].results_hash)
      return place + fmt::format("its results are not those of {}", oracle.name);
  }
  const Kernel& first = first_vector_program(workload);
  if (found.output_hash != trail_of(first, configuration).output_hash)
    return fmt::format("its output is not that of {}", first.name);
  return std::nullopt;
}

}  // namespace lanescope
