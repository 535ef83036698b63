// SPDX-License-Identifier: MIT
#include "kernels/kernel.h"

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
  into.results_hash += from.results_hash;
  for (std::size_t i = 0; i < kernel.series.size(); ++i) add_up(into.series[i], from.series[i]);
  merge_counters(kernel.counters, into.counters, from.counters);
}

const Kernel* known_kernel(std::string_view name) {
  for (const Kernel* kernel : kernels())
    if (kernel->name == name) return kernel;
  return nullptr;
}

const Kernel& find_kernel(std::string_view name) {
  if (const Kernel* kernel = known_kernel(name)) return *kernel;
  const std::vector<std::string> names = names_of(kernels());
  throw InputError("--kernel", "there is no kernel '{}'{} (one of: {})", name,
                   did_you_mean(name, names), fmt::join(names, ", "));
}

}  // namespace lanescope
