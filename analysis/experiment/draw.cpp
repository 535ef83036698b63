// SPDX-License-Identifier: MIT
#include "analysis/experiment/draw.h"

#include <vector>

#include "analysis/base/memory.h"
#include "analysis/base/parallel.h"

namespace lanescope {

std::unique_ptr<Output> draw(const Configuration& configuration, const View& view, int threads,
                             const std::function<void(double)>& progress,
                             const OpeningListener& opening) {
  require_memory(view.output_bytes(configuration.arguments));
  const std::unique_ptr<Source> source = open_source(configuration, opening);
  std::unique_ptr<Output> output = view.open(configuration.arguments, *source);
  std::vector<std::unique_ptr<Execution>> executions;
  for (int i = 0; i < threads; ++i)
    executions.push_back(view.start({1, Mode::kUncounted, configuration.arguments, *output}));
  const int segments = source->segment_count();
  parallel_for(
      threads, segments,
      [&](int worker, int segment) {
        Execution& execution = *executions[static_cast<std::size_t>(worker)];
        source->produce(segment, [&](const Work& piece) { execution.run(piece); });
      },
      [&](int done) { progress(static_cast<double>(done) / segments); });
  return output;
}

}  // namespace lanescope
