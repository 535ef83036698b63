// SPDX-License-Identifier: MIT
#include "analysis/cli/example_words.h"

#include <fmt/format.h>

#include <map>

#include "analysis/cli/defaults.h"
#include "analysis/studies/study.h"

namespace lanescope {
namespace {

using Words = std::map<std::string, std::string, std::less<>>;

std::string facet_option(const Workload& workload) {
  for (const Parameter& parameter : workload.parameters)
    if (parameter.name() == workload.facet && !parameter.choices.empty())
      return fmt::format("{} {}", parameter.words.option, fmt::join(parameter.choices, ","));
  return {};
}

std::string view_of(const Workload& workload) {
  for (const Kernel* kernel : kernels())
    if (kernel->workload == &workload && !kernel->views.empty())
      return std::string(kernel->views.front().name);
  return {};
}

Words words_of_the_program() {
  const Workload& workload = usual_workload();
  const auto groups = scene_groups(workload);
  return {
      {"kernel", std::string(usual_kernels().back()->name)},
      {"scene", std::string(workload.scenes.back().name)},
      {"group", groups.empty() ? "all" : std::string(groups.front()->scene_group)},
      {"facet", facet_option(workload)},
      {"file", workload.file_ending.empty() ? "" : fmt::format("model{}", workload.file_ending)},
      {"view", view_of(workload)},
      {"study", studies().empty() ? "" : std::string(studies().front()->name)}};
}

/// The line, or nothing if a word that it needs is not there.
std::string replaced(std::string_view line, const Words& words) {
  std::string text;
  while (true) {
    const std::size_t open = line.find('{');
    text += line.substr(0, open);
    if (open == line.npos) return text;
    const std::size_t close = line.find('}', open);
    const std::string& word = words.at(std::string(line.substr(open + 1, close - open - 1)));
    if (word.empty()) return {};
    text += word;
    line.remove_prefix(close + 1);
  }
}

}  // namespace

std::string with_words(std::string_view lines) {
  static const Words words = words_of_the_program();
  std::string text;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string line = replaced(lines.substr(0, end), words);
    if (!line.empty()) text += (text.empty() ? "" : "\n") + line;
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return text;
}

}  // namespace lanescope
