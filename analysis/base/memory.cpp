// SPDX-License-Identifier: MIT
#include "analysis/base/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::streamsize kLongest = std::numeric_limits<std::streamsize>::max();

std::uint64_t difference(std::uint64_t limit, std::uint64_t used) {
  return limit > used ? limit - used : 0;
}

/// The number after a word of a file such as `MemAvailable:   123 kB`.
std::optional<std::uint64_t> number_after(const fs::path& file, std::string_view word) {
  std::ifstream lines(file);
  for (std::string first; lines >> first; lines.ignore(kLongest, '\n')) {
    std::uint64_t number = 0;
    if (first == word && lines >> number) return number;
  }
  return std::nullopt;
}

/// The number that a file holds; none if it holds a word, such as `max`.
std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::uint64_t number = 0;
  if (std::ifstream(file) >> number) return number;
  return std::nullopt;
}

std::uint64_t left_on_the_host() {
  constexpr const char* kFile = "/proc/meminfo";
  const auto kilobytes = number_after(kFile, "MemAvailable:");
  if (!kilobytes) return kUnlimited;
  return (*kilobytes + number_after(kFile, "SwapFree:").value_or(0)) << 10;
}

std::uint64_t left_of_limit(int resource, std::string_view used) {
  rlimit limit{};
  if (::getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0 ||
      limit.rlim_cur == RLIM_INFINITY)
    return kUnlimited;
  return difference(limit.rlim_cur, number_after("/proc/self/status", used).value_or(0) << 10);
}

/// What a control group and those above it leave. Pages of files count as used and can be had.
std::uint64_t left_of_groups(const fs::path& root, fs::path group, std::string_view limit,
                             std::string_view used) {
  std::uint64_t left = kUnlimited;
  for (;; group = group.parent_path()) {
    const fs::path directory = root / group.relative_path();
    const auto most = number_in(directory / limit);
    const std::uint64_t pages_of_files =
        number_after(directory / "memory.stat", "inactive_file").value_or(0);
    if (most)
      left = std::min(left,
                      difference(*most + pages_of_files, number_in(directory / used).value_or(0)));
    if (!group.has_relative_path()) return left;
  }
}

/// Of the second version of control groups, or of the first one's for memory.
std::uint64_t left_of_control_groups() {
  std::uint64_t left = kUnlimited;
  std::ifstream lines("/proc/self/cgroup");
  for (std::string line; std::getline(lines, line);) {
    const std::size_t controllers = line.find(':') + 1;
    const std::size_t path = line.find(':', controllers) + 1;
    if (controllers == 0 || path == 0) continue;
    const std::string_view names =
        std::string_view(line).substr(controllers, path - 1 - controllers);
    const fs::path group = line.substr(path);
    if (names.empty())
      left =
          std::min(left, left_of_groups("/sys/fs/cgroup", group, "memory.max", "memory.current"));
    else if (names == "memory")
      left = std::min(left, left_of_groups("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes",
                                           "memory.usage_in_bytes"));
  }
  return left;
}

}  // namespace

std::uint64_t available_memory_bytes() {
  return std::min({left_on_the_host(), left_of_limit(RLIMIT_AS, "VmSize:"),
                   left_of_limit(RLIMIT_DATA, "VmData:"), left_of_control_groups()});
}

void require_memory(std::uint64_t output_bytes) {
  const std::uint64_t available = available_memory_bytes();
  if (output_bytes > available)
    throw InputError("memory",
                     "outputs (frames) take {}, and {} can be had; ask for smaller ones, or run "
                     "fewer at a time",
                     memory_text(output_bytes), memory_text(available));
}

std::string memory_text(std::uint64_t bytes) {
  const double megabytes = static_cast<double>(bytes) / 1e6;
  return megabytes < 1000.0 ? fmt::format("{:.0f} MB", megabytes)
                            : fmt::format("{:.1f} GB", megabytes / 1000.0);
}

}  // namespace lanescope
