// SPDX-License-Identifier: MIT
#include "analysis/cli/output.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>

#include "analysis/base/printable.h"
#include "simulator/base/error.h"

namespace lanescope {

void print(std::string_view text) {
  // An empty view may have no characters to point at, which fwrite does not take.
  const std::size_t written = text.empty() ? 0 : std::fwrite(text.data(), 1, text.size(), stdout);
  if (written == text.size() && std::fflush(stdout) == 0) return;
  if (errno == EPIPE) throw ClosedPipe();
  throw InputError("standard output", "cannot be written: {}", std::strerror(errno));
}

void tell(std::string_view line) {
  std::fputs(fmt::format("lanescope: {}\n", printable(line)).c_str(), stderr);
}

Destination::Destination(const std::string& path) : is_stdout_(path == "-") {
  if (!path.empty() && !is_stdout_) file_ = std::make_unique<OutputFile>(path);
}

void Destination::append(std::string_view text) {
  if (is_stdout_) print(text);
  if (file_) file_->append(text);
}

void Destination::write(std::string_view text) {
  if (is_stdout_) print(text);
  if (file_) file_->commit(text);
}

void make_all(const std::vector<std::function<void()>>& outputs) {
  std::exception_ptr failure;
  for (const auto& make : outputs) try {
      make();
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace lanescope
