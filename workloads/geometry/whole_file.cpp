// SPDX-License-Identifier: MIT
#include "workloads/geometry/whole_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "simulator/base/error.h"

namespace lanescope {

std::string whole_file(const std::string& path, std::string_view wanted,
                       const std::function<void()>& goes_on) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw InputError(path, "is a folder; use {}", wanted);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path, "cannot be opened: {}", std::strerror(errno));
  constexpr std::size_t kBlock = 1 << 20;
  std::string bytes;
  while (file) {
    const std::size_t size = bytes.size();
    bytes.resize(size + kBlock);
    file.read(bytes.data() + size, kBlock);
    bytes.resize(size + static_cast<std::size_t>(file.gcount()));
    if (goes_on) goes_on();
  }
  if (file.bad()) throw InputError(path, "cannot be read: {}", std::strerror(errno));
  return bytes;
}

}  // namespace lanescope
