// SPDX-License-Identifier: MIT
#include "analysis/build_info.h"

#include <fstream>

namespace lanescope {

std::string_view program_version() { return LANESCOPE_VERSION; }

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

}  // namespace lanescope
