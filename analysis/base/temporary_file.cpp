// SPDX-License-Identifier: MIT
#include "analysis/base/temporary_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <limits.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <string_view>
#include <system_error>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// Stands between the name of a file and the id of the process that writes it.
constexpr std::string_view kMark = ".tmp-";

/// The names of temporary files where a signal handler can read them: in memory that never moves.
class Names {
 public:
  static constexpr std::size_t kNone = 256;  ///< More files than this at a time are not listed.

  bool contains(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    for (const Slot& slot : slots_)
      if (slot.used.load() && name == slot.name.data()) return true;
    return false;
  }
  std::size_t add(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    for (std::size_t i = 0; i < slots_.size() && name.size() < PATH_MAX; ++i) {
      if (slots_[i].used.load()) continue;
      std::memcpy(slots_[i].name.data(), name.c_str(), name.size() + 1);
      slots_[i].used.store(true);
      return i;
    }
    return kNone;
  }
  void remove(std::size_t place) {
    if (place != kNone) slots_[place].used.store(false);
  }
  void unlink_all() const noexcept {
    for (const Slot& slot : slots_)
      if (slot.used.load()) ::unlink(slot.name.data());
  }

 private:
  struct Slot {
    std::atomic<bool> used{false};
    std::array<char, PATH_MAX> name{};
  };
  std::mutex mutex_;
  std::array<Slot, kNone> slots_;
};

constinit Names names;

/// `dir/report.json.tmp-123`, of a name as long as there may be.
std::string temporary_path(const std::string& target) {
  const std::filesystem::path path(target);
  const std::string end = fmt::format("{}{}", kMark, ::getpid());
  return path.parent_path() / (path.filename().string().substr(0, NAME_MAX - end.size()) + end);
}

/// The process that writes, or wrote, a temporary file of that name; 0 if it is not one.
pid_t writer_of(const std::string& name) {
  const std::size_t mark = name.rfind(kMark);
  if (mark == name.npos) return 0;
  const char* const first = name.data() + mark + kMark.size();
  const char* const last = name.data() + name.size();
  pid_t process = 0;
  const auto read = std::from_chars(first, last, process);
  return read.ec == std::errc() && read.ptr == last && process > 0 ? process : 0;
}

bool is_running(pid_t process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

}  // namespace

TemporaryFile::TemporaryFile(const std::string& target)
    : target_(target), path_(temporary_path(target)) {
  if (names.contains(path_)) throw InputError(target, "is given as the file of two outputs");
  slot_ = names.add(path_);
  // What is there has been left by a dead process that had the same id.
  ::unlink(path_.c_str());
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) return;
  const int reason = errno;
  names.remove(slot_);
  throw std::system_error(reason, std::generic_category());
}

TemporaryFile::~TemporaryFile() {
  ::close(descriptor_);
  if (path_ != target_) ::unlink(path_.c_str());
  names.remove(slot_);
}

bool TemporaryFile::rename_to_target() {
  if (std::rename(path_.c_str(), target_.c_str()) != 0) return false;
  path_ = target_;
  return true;
}

void remove_temporary_files() noexcept { names.unlink_all(); }

void remove_dead_temporaries(const std::string& directory) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
    const pid_t writer = writer_of(entry.path().filename());
    if (writer != 0 && !is_running(writer)) std::filesystem::remove(entry.path(), error);
  }
}

}  // namespace lanescope
