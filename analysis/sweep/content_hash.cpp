// SPDX-License-Identifier: MIT
#include "analysis/sweep/content_hash.h"

#include <filesystem>
#include <map>
#include <mutex>

#include "analysis/base/files.h"
#include "simulator/base/error.h"
#include "simulator/base/random.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

/// What can be seen of a file without reading it.
struct Look {
  std::uintmax_t size;
  fs::file_time_type changed;
  bool operator==(const Look&) const = default;
};

struct Known {
  Look look;
  std::uint64_t hash;
};

}  // namespace

/// FNV-1a, whose low bits mix64 spreads over the whole word.
std::uint64_t text_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return mix64(hash);
}

std::optional<std::uint64_t> file_hash(const std::string& path) {
  static std::mutex mutex;
  static std::map<std::string, Known> known;
  try {
    const Look look{fs::file_size(path), fs::last_write_time(path)};
    const std::scoped_lock lock(mutex);
    const auto found = known.find(path);
    if (found != known.end() && found->second.look == look) return found->second.hash;
    const std::uint64_t hash = text_hash(read_file(path));
    known.insert_or_assign(path, Known{look, hash});
    return hash;
  } catch (const fs::filesystem_error&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace lanescope
