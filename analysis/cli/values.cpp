// SPDX-License-Identifier: MIT
#include "analysis/cli/values.h"

#include <algorithm>
#include <charconv>
#include <thread>

#include "analysis/base/parallel.h"
#include "analysis/cli/output.h"

namespace lanescope {
namespace {

constexpr int kMaxThreads = 256;

}  // namespace

void Argument::fail(std::string_view expected) const {
  throw InputError(option, "'{}' is not {}", text, expected);
}

int parse_integer(const Argument& argument, int low, int high) {
  int number = 0;
  const char* const end = argument.text.data() + argument.text.size();
  const auto result = std::from_chars(argument.text.data(), end, number);
  const bool whole = result.ec == std::errc() && result.ptr == end;
  if (!whole || number < low || number > high)
    argument.fail(fmt::format("an integer from {} to {}", low, high));
  return number;
}

int parse_threads(const std::string& text) {
  const int of_the_host = static_cast<int>(std::thread::hardware_concurrency());
  const int wanted = text.empty() ? std::clamp(of_the_host, 1, kMaxThreads)
                                  : parse_integer({"--threads", text}, 1, kMaxThreads);
  const int threads = startable_threads(wanted);
  if (threads < wanted)
    tell(fmt::format("--threads: only {} of {} can be had; going on with {}", threads, wanted,
                     threads));
  return threads;
}

std::vector<Argument> parse_list(const Argument& argument) {
  std::vector<Argument> elements;
  std::string_view rest = argument.text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const Argument element{argument.option, rest.substr(0, comma)};
    more = comma != rest.npos;
    if (more) rest.remove_prefix(comma + 1);
    if (element.text.empty())
      throw InputError(argument.option,
                       "'{}' has an empty element; separate values by single commas",
                       argument.text);
    if (std::any_of(elements.begin(), elements.end(),
                    [&](const Argument& other) { return other.text == element.text; }))
      throw InputError(argument.option, "'{}' has '{}' twice", argument.text, element.text);
    elements.push_back(element);
  }
  return elements;
}

std::string parse_name(const Argument& argument, std::string_view kind,
                       const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), argument.text) != names.end())
    return std::string(argument.text);
  throw InputError(argument.option, "'{}' is not {}; use {}{}", argument.text, kind, list_or(names),
                   did_you_mean(argument.text, names));
}

}  // namespace lanescope
