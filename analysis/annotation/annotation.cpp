// SPDX-License-Identifier: MIT
#include "analysis/annotation/annotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "analysis/annotation/sources.h"
#include "analysis/configuration/special_options.h"

namespace lanescope {
namespace {

using LineKey = std::tuple<SourcePlace, std::string, std::optional<SourcePlace>>;

bool same_program(const Annotation& a, const Configuration& c) {
  return a.kernel == c.kernel && a.width == c.width && a.facet == facet_of(c);
}

void add_run(Annotation& annotation, std::map<LineKey, SourceLineRecord>& lines,
             const RunRecord& run) {
  annotation.scenes.push_back(run.configuration.scene);
  annotation.pieces += run.source.pieces;
  annotation.pieces_observed += run.source.pieces_observed;
  for (const SourceLineRecord& record : run.source_lines) {
    SourceLineRecord& line = lines[{record.place, record.stage, record.block}];
    line.place = record.place;
    line.stage = record.stage;
    line.block = record.block;
    line.issued += record.issued;
    line.active += record.active;
    line.overhead += record.overhead;
    annotation.issued += record.issued;
  }
}

bool hotter(const SourceLineRecord& a, const SourceLineRecord& b) {
  return std::tie(b.issued, a.place, a.stage, a.block) <
         std::tie(a.issued, b.place, b.stage, b.block);
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

std::string shown(const SourcePlace& place) { return fmt::format("{}:{}", place.file, place.line); }

std::string_view text_of(const SourcePlace& place) {
  return trimmed(source_line(place.file, place.line));
}

/// `kernel.h:181: auto on = sites.testing.on(active);`: the folder is mostly that of the line.
std::string shown_block(const SourcePlace& block) {
  const std::string_view file = std::string_view(block.file).substr(block.file.rfind('/') + 1);
  return fmt::format("{}:{}: {}", file, block.line, text_of(block));
}

Row row_of(const Annotation& annotation, const SourceLineRecord& line) {
  const auto figure = [](const Ratio& ratio) {
    return Cell{Figure{ratio.value(), std::nullopt, &kPercent}, std::nullopt, ""};
  };
  return {shown(line.place),
          {figure(annotation.share(line)), figure(annotation.utilization(line)),
           Cell{Figure{static_cast<double>(line.issued), std::nullopt, &kCount}, std::nullopt, ""},
           words(line.stage), words(std::string(text_of(line.place))),
           words(line.block ? shown_block(*line.block) : "")}};
}

std::string margin(const Annotation& annotation, const SourceLineRecord* line) {
  if (!line) return fmt::format("{:>7} {:>7} {:>12}", "", "", "");
  return fmt::format("{:>7} {:>7} {:>12}", percent(annotation.share(*line)),
                     percent(annotation.utilization(*line)), line->issued);
}

std::string annotated_file(const Annotation& annotation, const SourceFile& file) {
  std::map<std::uint32_t, SourceLineRecord> by_number;
  for (const SourceLineRecord& line : annotation.lines)
    if (line.place.file == file.path) {
      SourceLineRecord& sum = by_number[line.place.line];
      sum.issued += line.issued;
      sum.active += line.active;
    }
  if (by_number.empty()) return "";
  std::string text = fmt::format("{}\n{:>7} {:>7} {:>12}\n", file.path, "share", "util.", "issued");
  std::string_view rest = file.text;
  for (std::uint32_t number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const auto found = by_number.find(number);
    text += fmt::format("{} {:>4} | {}\n",
                        margin(annotation, found == by_number.end() ? nullptr : &found->second),
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

Ratio Annotation::utilization(const SourceLineRecord& line) const {
  return {line.active, line.issued * static_cast<std::uint64_t>(width)};
}

std::vector<Annotation> annotate(const Report& report) {
  std::vector<Annotation> annotations;
  std::vector<std::map<LineKey, SourceLineRecord>> lines;
  std::vector<std::vector<const Configuration*>> configurations;
  for (const RunRecord& run : report.runs) {
    if (run.source_lines.empty()) continue;
    const auto known = std::find_if(annotations.begin(), annotations.end(), [&](const auto& a) {
      return same_program(a, run.configuration);
    });
    const auto place = static_cast<std::size_t>(known - annotations.begin());
    if (known == annotations.end()) {
      const Configuration& c = run.configuration;
      annotations.push_back({c.kernel, c.width, facet_of(c), {}, "", 0, 0, 0, {}});
      lines.emplace_back();
      configurations.emplace_back();
    }
    configurations[place].push_back(&run.configuration);
    add_run(annotations[place], lines[place], run);
  }
  for (std::size_t i = 0; i < annotations.size(); ++i) {
    annotations[i].setting = shown_setting(configurations[i]);
    for (auto& [key, line] : lines[i]) annotations[i].lines.push_back(std::move(line));
    std::sort(annotations[i].lines.begin(), annotations[i].lines.end(), hotter);
  }
  return annotations;
}

TableData hottest_lines(const Annotation& annotation, std::size_t count) {
  TableData table;
  table.name = "hottest_lines";
  table.caption =
      fmt::format("{} of {} pieces of work", annotation.pieces_observed, annotation.pieces);
  table.setting = annotation.setting;
  table.title = "Hottest lines of " + annotation.title();
  table.row_header = "Line";
  table.columns = {"Share", "Utilization", "Issued", "Stage", "Source", "In the block of"};
  for (std::size_t i = 0; i < std::min(count, annotation.lines.size()); ++i)
    table.rows.push_back(row_of(annotation, annotation.lines[i]));
  table.notes = {
      "A line of a helper is a row for each block that called it: the block, named by the line "
      "that opened it, says for whom."};
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
