// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "analysis/annotation/annotation.h"
#include "analysis/annotation/sources.h"
#include "analysis/base/json_text.h"
#include "analysis/html/section.h"
#include "analysis/html/spec.h"

namespace lanescope {
namespace {

constexpr std::size_t kLines = 200;      ///< In the table.
constexpr std::size_t kCharacters = 90;  ///< Of a line of source beside its bar.

/// The name of a file without its folders: bars have little room.
std::string short_place(const SourcePlace& place) {
  return fmt::format("{}:{}", place.file.substr(place.file.rfind('/') + 1), place.line);
}

/// With the block that it is issued in: lines of helpers are issued in many.
std::string place_of(const SourceLineRecord& line) {
  return line.block ? fmt::format("{} in {}", short_place(line.place), short_place(*line.block))
                    : short_place(line.place);
}

/// Without the white space before it.
std::string source_of(const SourceLineRecord& line) {
  std::string_view text = source_line(line.place.file, line.place.line);
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  if (text.size() <= kCharacters) return std::string(text);
  return std::string(text.substr(0, kCharacters)) + "...";
}

DataFrame rows(const ReportView& view) {
  DataFrame frame(series_columns({{"rank", "Rank", ""},
                                  {"file", "Line", ""},
                                  {"place", "Short", ""},
                                  {"stage", "Stage", ""},
                                  {"share", "Share", ".2%"},
                                  {"utilization", "Utilization", ".1%"},
                                  {"source", "Source", ""}}));
  for (const Annotation& annotation : annotate(view.report())) {
    const Series series{annotation.kernel, annotation.facet};
    for (std::size_t i = 0; i < std::min(kLines, annotation.lines.size()); ++i) {
      const SourceLineRecord& line = annotation.lines[i];
      frame.add({shown_kernel(series.kernel), shown_facet(series), annotation.width, i + 1,
                 fmt::format("{}:{}", line.place.file, line.place.line), place_of(line), line.stage,
                 number_or_null(annotation.share(line).value()),
                 number_or_null(annotation.utilization(line).value()), source_of(line)});
    }
  }
  return frame;
}

std::vector<SectionBlock> build(const ReportView& view) {
  constexpr std::string_view kSpec = R"json({
    "transform": [{"filter": "datum.rank <= 20"}],
    "width": 330, "height": {"step": 20},
    "encoding": {
      "y": {"field": "place", "type": "nominal", "title": null,
            "sort": {"field": "rank", "op": "min"}, "axis": {"labelLimit": 220}},
      "x": {"field": "share", "type": "quantitative", "title": "Share of the instructions",
            "axis": {"format": "%", "tickCount": 5}}},
    "layer": [
      {"mark": "bar", "encoding": {"color": "@stage"}},
      {"mark": {"type": "text", "align": "left", "x": {"expr": "width + 6"}, "fill": "currentColor",
                "font": "ui-monospace, 'Liberation Mono', monospace", "fontSize": 11,
                "limit": 430},
       "encoding": {"x": null, "text": {"field": "source"}}}]
  })json";
  DataFrame lines = rows(view);
  if (lines.empty()) return {};
  auto spec = spec_from(kSpec, view.report());
  spec["layer"][0]["encoding"]["color"]["legend"] = {{"orient", "top"}};  // The source is beside.
  return {Chart{"lines",
                "The 20 lines of source that issue most, over the pieces of work that were "
                "observed, of all scenes, each with the line that opened its block; a bar has the "
                "colour of its stage. "
                "The numbers have 200 lines.",
                std::move(spec),
                std::move(lines),
                {pick_of_kernel(), pick_of_facet(), pick_of_lanes(view.report())}}};
}

}  // namespace

extern const Section s_hot_lines{
    "hot-lines", "Costliest lines of source",
    "Where in the kernels most instructions are issued: what to look at first.", build};

}  // namespace lanescope
