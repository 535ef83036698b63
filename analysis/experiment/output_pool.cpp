// SPDX-License-Identifier: MIT
#include "analysis/experiment/output_pool.h"

#include <utility>

namespace lanescope {

std::unique_ptr<Output> OutputPool::take(const Configuration& configuration, const Source& source) {
  const OpenOutput open = find_kernel(configuration.kernel).open;
  for (std::size_t i = idle_.size(); i-- > 0;) {
    if (idle_[i].open != open) continue;
    std::unique_ptr<Output> output = std::move(idle_[i].output);
    idle_.erase(idle_.begin() + static_cast<std::ptrdiff_t>(i));
    if (output->reopen(configuration.arguments, source)) return output;
  }
  idle_.clear();
  return open(configuration.arguments, source);
}

void OutputPool::give_back(const Kernel& kernel, std::unique_ptr<Output> output) {
  idle_.push_back({kernel.open, std::move(output)});
}

}  // namespace lanescope
