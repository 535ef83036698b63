// SPDX-License-Identifier: MIT
#include "analysis/cli/output.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// A word as a shell takes it.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + '\'';
}

}  // namespace

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw InputError("standard output", "cannot be written: {}", std::strerror(errno));
}

Destination::Destination(const std::string& path) : is_stdout_(path == "-") {
  if (!path.empty() && !is_stdout_) file_ = std::make_unique<AtomicFile>(path);
}

void Destination::append(std::string_view text) {
  if (is_stdout_) print(text);
  if (file_) file_->append(text);
}

void Destination::write(std::string_view text) {
  if (is_stdout_) print(text);
  if (file_) file_->commit(text);
}

std::string command_of(const CLI::App& app) {
  std::string command = "lanescope " + app.get_name();
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0 || option->get_group() == "Output") continue;
    if (!option->get_positional()) command += ' ' + option->get_name();
    for (const std::string& value : option->results()) command += ' ' + quoted(value);
  }
  return command;
}

}  // namespace lanescope
