// SPDX-License-Identifier: MIT
#include "kernels/kernel.h"

#include <algorithm>

#include "kernels/widths.h"
#include "simulator/base/error.h"

namespace lanescope {

namespace {

void add_up(std::vector<std::uint64_t>& to, const std::vector<std::uint64_t>& from) {
  if (to.size() < from.size()) to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) to[i] += from[i];
}

}  // namespace

void merge(const Kernel& kernel, KernelResult& into, const KernelResult& from) {
  into.counts += from.counts;
  into.hits_hash += from.hits_hash;
  for (std::size_t i = 0; i < kernel.series.size(); ++i) add_up(into.series[i], from.series[i]);
  for (std::size_t i = 0; i < kernel.counters.size(); ++i) {
    if (kernel.counters[i].merge == Merge::kMaximum)
      into.counters[i] = std::max(into.counters[i], from.counters[i]);
    else
      into.counters[i] += from.counters[i];
  }
}

std::span<const int> built_widths() { return kBuiltWidths; }

const Kernel& find_kernel(std::string_view name) {
  std::vector<std::string> names;
  for (const Kernel* kernel : kernels()) {
    if (kernel->name == name) return *kernel;
    names.emplace_back(kernel->name);
  }
  throw InputError("--kernel", "there is no kernel '{}'{} (one of: {})", name,
                   did_you_mean(name, names), fmt::join(names, ", "));
}

}  // namespace lanescope
