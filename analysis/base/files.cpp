// SPDX-License-Identifier: MIT
#include "analysis/base/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

bool write_all(int descriptor, std::string_view contents) {
  while (!contents.empty()) {
    const ssize_t written = ::write(descriptor, contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Stands between the name of a file and the id of the process that writes it.
constexpr std::string_view kTemporaryMark = ".tmp-";

/// The process that writes, or wrote, a temporary file of that name; 0 if it is not one.
pid_t writer_of(const std::string& name) {
  const std::size_t mark = name.rfind(kTemporaryMark);
  if (mark == name.npos) return 0;
  const char* const first = name.data() + mark + kTemporaryMark.size();
  const char* const last = name.data() + name.size();
  pid_t process = 0;
  const auto read = std::from_chars(first, last, process);
  return read.ec == std::errc() && read.ptr == last && process > 0 ? process : 0;
}

bool is_running(pid_t process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

}  // namespace

std::string read_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw InputError(path, "is a directory; a file is needed");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path, "cannot be read: {}", std::strerror(errno));
  std::ostringstream contents;
  contents << file.rdbuf();
  if (file.bad()) throw InputError(path, "cannot be read: {}", std::strerror(errno));
  return std::move(contents).str();
}

AtomicFile::AtomicFile(std::string path)
    : path_(std::move(path)),
      temporary_path_(fmt::format("{}{}{}", path_, kTemporaryMark, ::getpid())) {
  std::error_code error;
  if (path_.empty() || std::filesystem::is_directory(path_, error))
    throw InputError(path_.empty() ? "output file" : path_, "is not the name of a file");
  descriptor_ = ::open(temporary_path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw InputError(path_, "cannot be written: {}", std::strerror(errno));
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_path_.c_str());
}

void AtomicFile::append(std::string_view contents) {
  LANESCOPE_CHECK(descriptor_ >= 0, "{} is written after it was committed", path_);
  if (!write_all(descriptor_, contents))
    throw InputError(path_, "cannot be written: {}", std::strerror(errno));
}

void AtomicFile::commit(std::string_view rest) {
  append(rest);
  if (std::rename(temporary_path_.c_str(), path_.c_str()) != 0)
    throw InputError(path_, "cannot be written: {}", std::strerror(errno));
  ::close(std::exchange(descriptor_, -1));
}

void write_file(const std::string& path, std::string_view contents) {
  AtomicFile(path).commit(contents);
}

void remove_dead_temporaries(const std::string& directory) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
    const pid_t writer = writer_of(entry.path().filename());
    if (writer != 0 && !is_running(writer)) std::filesystem::remove(entry.path(), error);
  }
}

void make_directory(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    throw InputError(path, "cannot be created as a directory{}{}", error ? ": " : "",
                     error ? error.message() : "");
}

}  // namespace lanescope
