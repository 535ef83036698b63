// SPDX-License-Identifier: MIT
#include "analysis/annotation/annotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "analysis/annotation/sources.h"

namespace lanescope {
namespace {

using LineKey = std::pair<std::string, std::uint32_t>;

bool same_program(const Annotation& a, const Configuration& c) {
  return a.kernel == c.kernel && a.width == c.width && a.facet == facet_of(c);
}

void add_stage(std::string& stages, const std::string& stage) {
  if (stages.empty())
    stages = stage;
  else if (std::string_view(stages).find(stage) == stages.npos)
    stages += ", " + stage;
}

void add_run(Annotation& annotation, std::map<LineKey, AnnotatedLine>& lines,
             const RunRecord& run) {
  annotation.scenes.push_back(run.configuration.scene);
  annotation.pieces += run.source.pieces;
  annotation.pieces_observed += run.source.pieces_observed;
  for (const SourceLineRecord& record : run.source_lines) {
    AnnotatedLine& line = lines[{record.file, record.line}];
    line.file = record.file;
    line.line = record.line;
    add_stage(line.stages, record.stage);
    line.issued += record.issued;
    line.active += record.active;
    line.overhead += record.overhead;
    annotation.issued += record.issued;
  }
}

bool hotter(const AnnotatedLine& a, const AnnotatedLine& b) {
  return std::tie(b.issued, a.file, a.line) < std::tie(a.issued, b.file, b.line);
}

std::string percent(const Ratio& ratio) {
  const auto value = ratio.value();
  return value ? fmt::format("{:.1f}%", 100.0 * *value) : "";
}

/// Without the white space around it.
std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == text.npos ? std::string_view() : text.substr(begin);
}

Cell words(std::string text) { return {std::nullopt, std::nullopt, std::move(text)}; }

Row row_of(const Annotation& annotation, const AnnotatedLine& line) {
  const auto figure = [](const Ratio& ratio) {
    return Cell{Figure{ratio.value(), std::nullopt, &kPercent}, std::nullopt, ""};
  };
  return {fmt::format("{}:{}", line.file, line.line),
          {figure(annotation.share(line)), figure(annotation.utilization(line)),
           Cell{Figure{static_cast<double>(line.issued), std::nullopt, &kCount}, std::nullopt, ""},
           words(line.stages), words(std::string(trimmed(source_line(line.file, line.line))))}};
}

std::string margin(const Annotation& annotation, const AnnotatedLine* line) {
  if (!line) return fmt::format("{:>7} {:>7} {:>12}", "", "", "");
  return fmt::format("{:>7} {:>7} {:>12}", percent(annotation.share(*line)),
                     percent(annotation.utilization(*line)), line->issued);
}

std::string annotated_file(const Annotation& annotation, const SourceFile& file) {
  std::map<std::uint32_t, const AnnotatedLine*> by_number;
  for (const AnnotatedLine& line : annotation.lines)
    if (line.file == file.path) by_number[line.line] = &line;
  if (by_number.empty()) return "";
  std::string text = fmt::format("{}\n{:>7} {:>7} {:>12}\n", file.path, "share", "util.", "issued");
  std::string_view rest = file.text;
  for (std::uint32_t number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const auto found = by_number.find(number);
    text += fmt::format("{} {:>4} | {}\n",
                        margin(annotation, found == by_number.end() ? nullptr : found->second),
                        number, rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return text;
}

}  // namespace

std::string Annotation::title() const {
  return fmt::format("{}, W = {}{}{}: {}", kernel, width, facet.empty() ? "" : ", ", facet,
                     fmt::join(scenes, ", "));
}

Ratio Annotation::utilization(const AnnotatedLine& line) const {
  return {line.active, line.issued * static_cast<std::uint64_t>(width)};
}

std::vector<Annotation> annotate(const Report& report) {
  std::vector<Annotation> annotations;
  std::vector<std::map<LineKey, AnnotatedLine>> lines;
  for (const RunRecord& run : report.runs) {
    if (run.source_lines.empty()) continue;
    const auto known = std::find_if(annotations.begin(), annotations.end(), [&](const auto& a) {
      return same_program(a, run.configuration);
    });
    const auto place = static_cast<std::size_t>(known - annotations.begin());
    if (known == annotations.end()) {
      const Configuration& c = run.configuration;
      annotations.push_back({c.kernel, c.width, facet_of(c), {}, 0, 0, 0, {}});
      lines.emplace_back();
    }
    add_run(annotations[place], lines[place], run);
  }
  for (std::size_t i = 0; i < annotations.size(); ++i) {
    for (auto& [key, line] : lines[i]) annotations[i].lines.push_back(std::move(line));
    std::sort(annotations[i].lines.begin(), annotations[i].lines.end(), hotter);
  }
  return annotations;
}

TableData hottest_lines(const Annotation& annotation, std::size_t count) {
  TableData table{"hottest_lines",
                  "",
                  "Hottest lines of " + annotation.title(),
                  "Line",
                  {"Share", "Utilization", "Issued", "Stage", "Source"},
                  {},
                  {}};
  for (std::size_t i = 0; i < std::min(count, annotation.lines.size()); ++i)
    table.rows.push_back(row_of(annotation, annotation.lines[i]));
  table.caption =
      fmt::format("{} of {} pieces of work", annotation.pieces_observed, annotation.pieces);
  return table;
}

std::string annotated_source(const Annotation& annotation) {
  std::string text;
  for (const SourceFile& file : kernel_sources()) {
    const std::string part = annotated_file(annotation, file);
    if (!part.empty()) text += (text.empty() ? "" : "\n") + part;
  }
  return text;
}

}  // namespace lanescope
