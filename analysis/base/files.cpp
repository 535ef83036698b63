// SPDX-License-Identifier: MIT
#include "analysis/base/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

bool write_all(int descriptor, std::string_view contents) {
  while (!contents.empty()) {
    const ssize_t written = ::write(descriptor, contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Where the symbolic links lead that a path ends in, even if nothing is there.
fs::path target_of(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i)
    path = path.parent_path() / fs::read_symlink(path, error);
  return path;
}

/// Standard output or error, if it goes where that file is and can be written; else -1.
int standard_stream_of(const struct stat& there) {
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat of_stream {};
    const int flags = ::fcntl(stream, F_GETFL);
    if (flags >= 0 && (flags & O_PATH) == 0 && (flags & O_ACCMODE) != O_RDONLY &&
        ::fstat(stream, &of_stream) == 0 && of_stream.st_dev == there.st_dev &&
        of_stream.st_ino == there.st_ino)
      return stream;
  }
  return -1;
}

/// Not so of a file that is open but has no name any more.
bool is_named_file(const struct stat& there) {
  return S_ISREG(there.st_mode) && there.st_nlink > 0;
}

}  // namespace

std::string read_file(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw InputError(path, "is a directory; a file is needed");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path, "cannot be read: {}", std::strerror(errno));
  std::ostringstream contents;
  contents << file.rdbuf();
  if (file.bad()) throw InputError(path, "cannot be read: {}", std::strerror(errno));
  return std::move(contents).str();
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(path_) {
  struct stat there {};
  const bool is_there = ::stat(path_.c_str(), &there) == 0;
  if (path_.empty() || path_.ends_with('/') || (is_there && S_ISDIR(there.st_mode)))
    throw InputError(path_.empty() ? "output file" : path_, "is not the name of a file");
  if (!is_there && errno != ENOENT) fail();
  const int stream = is_there ? standard_stream_of(there) : -1;
  is_standard_output_ = stream == STDOUT_FILENO;
  if (stream >= 0)
    descriptor_ = ::fcntl(stream, F_DUPFD_CLOEXEC, 0);
  else if (is_there && !is_named_file(there))
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  else
    open_file(is_there ? &there : nullptr);
  if (descriptor_ < 0) fail();
}

OutputFile::~OutputFile() {
  if (!temporary_ && descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::open_file(const struct stat* there) {
  target_ = target_of(path_);
  try {
    temporary_.emplace(target_);
    descriptor_ = temporary_->descriptor();
    if (there) ::fchmod(descriptor_, there->st_mode & 0777);
  } catch (const std::system_error& error) {
    // The directory takes no new file, but the one that is there may be written.
    if (there) descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    has_old_contents_ = descriptor_ >= 0;
    if (!there) errno = error.code().value();
  }
}

void OutputFile::append(std::string_view contents) {
  LANESCOPE_CHECK(!is_committed_, "{} is written after it was committed", path_);
  if (std::exchange(has_old_contents_, false) && ::ftruncate(descriptor_, 0) != 0) fail();
  if (!write_all(descriptor_, contents)) fail();
}

void OutputFile::commit(std::string_view rest) {
  append(rest);
  is_committed_ = true;
  if (temporary_ && !temporary_->rename_to_target()) copy_to_target();
}

/// Where another file may not take the name, its contents may.
void OutputFile::copy_to_target() const {
  const int refusal = errno;
  const int target = ::open(target_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  errno = refusal;
  if (target < 0) fail();
  const bool is_written = write_all(target, read_file(temporary_->path()));
  const int reason = errno;
  ::close(target);
  errno = reason;
  if (!is_written) fail();
}

void OutputFile::fail() const {
  throw InputError(path_, "cannot be written: {}", std::strerror(errno));
}

void write_file(const std::string& path, std::string_view contents) {
  OutputFile(path).commit(contents);
}

void make_directory(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path))
    throw InputError(path, "cannot be created as a directory{}{}", error ? ": " : "",
                     error ? error.message() : "");
}

}  // namespace lanescope
