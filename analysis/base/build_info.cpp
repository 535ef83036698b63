// SPDX-License-Identifier: MIT
#include "analysis/base/build_info.h"

#include <sys/resource.h>

#include <fstream>

#include "analysis/commit.h"

namespace lanescope {

std::string_view program_version() { return LANESCOPE_VERSION; }

std::string_view program_commit() { return LANESCOPE_COMMIT; }

std::string_view compiler() {
#if defined(__clang__)
  return __VERSION__;
#else
  return "GCC " __VERSION__;
#endif
}

std::string processor_model() {
  std::ifstream processors("/proc/cpuinfo");
  for (std::string line; std::getline(processors, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != line.npos)
      return line.substr(line.find(": ") + 2);
  return "unknown";
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace lanescope
