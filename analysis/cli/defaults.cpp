// SPDX-License-Identifier: MIT
#include "analysis/cli/defaults.h"

namespace lanescope {

const Workload& usual_workload() { return *kernels().front()->workload; }

std::vector<const Kernel*> usual_kernels(const Workload& workload) {
  std::vector<const Kernel*> all;
  std::vector<const Kernel*> issuing;
  for (const Kernel* kernel : kernels()) {
    if (kernel->workload != &workload) continue;
    all.push_back(kernel);
    if (!kernel->stages.empty()) issuing.push_back(kernel);
  }
  return issuing.empty() ? all : issuing;
}

std::vector<std::uint64_t> usual_widths(const Kernel& kernel) {
  const auto most = static_cast<std::uint64_t>(kernel.most_width);
  std::vector<std::uint64_t> widths;
  for (const std::uint64_t width : {8, 16, 32, 64})
    if (width <= most) widths.push_back(width);
  return widths.empty() ? std::vector{most} : widths;
}

std::vector<const Study*> scene_groups(const Workload& workload) {
  std::vector<const Study*> groups;
  for (const Study* study : studies()) {
    const Kernel* const kernel = known_kernel(study->kernels.front());
    if (kernel && kernel->workload == &workload && !study->scene_group.empty())
      groups.push_back(study);
  }
  return groups;
}

}  // namespace lanescope
