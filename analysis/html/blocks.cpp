// SPDX-License-Identifier: MIT
#include "analysis/html/blocks.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/html/markup.h"
#include "analysis/html/packed.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// A place of a section, and what stands there in each setting; null for nothing.
struct Place {
  std::string key;
  std::vector<const SectionBlock*> blocks;
};

/// Charts are told apart by their ids, markup by its place among the markup.
std::vector<Place> places_of(const std::vector<std::vector<SectionBlock>>& by_setting) {
  std::vector<Place> places;
  for (std::size_t setting = 0; setting < by_setting.size(); ++setting) {
    std::size_t markups = 0;
    for (const SectionBlock& block : by_setting[setting]) {
      const Chart* chart = std::get_if<Chart>(&block);
      const std::string key = chart ? chart->id : fmt::format("markup {}", markups++);
      auto place = std::find_if(places.begin(), places.end(),
                                [&](const Place& other) { return other.key == key; });
      if (place == places.end())
        place = places.insert(place,
                              {key, std::vector<const SectionBlock*>(by_setting.size(), nullptr)});
      place->blocks[setting] = &block;
    }
  }
  return places;
}

/// The place of a value in the list, at its end if it was not there.
template <class T>
std::size_t place_in(std::vector<T>& list, const T& value) {
  const auto found = std::find(list.begin(), list.end(), value);
  const auto place = static_cast<std::size_t>(found - list.begin());
  if (found == list.end()) list.push_back(value);
  return place;
}

std::string markup_html(const std::vector<const SectionBlock*>& blocks, std::size_t first) {
  std::vector<std::string> different;
  Json of_settings = Json::array();
  for (const SectionBlock* block : blocks)
    of_settings.push_back(
        place_in(different, block ? std::get<Markup>(*block).html : std::string()));
  if (different.size() == 1) return different.front();
  return fmt::format("<div class=\"varies\">\n<div class=\"content\">{}</div>\n{}</div>\n",
                     different[of_settings[first].get<std::size_t>()],
                     packed_script({{"settings", of_settings}, {"html", different}}));
}

/// The charts of all settings: what differs among drawings once, rows in one frame if their columns
/// are the same.
class ChartPack {
 public:
  void add(const Chart* chart) {
    if (!chart || chart->rows.empty()) {
      settings_.push_back(nullptr);
      return;
    }
    Json drawing{{"spec", chart->spec}, {"caption", chart->caption}, {"picks", Json::array()}};
    drawing["spec"]["description"] = chart->caption;
    for (const Pick& pick : chart->picks)
      drawing["picks"].push_back({{"column", pick.column}, {"first", pick.first}});
    auto frame = std::find_if(frames_.begin(), frames_.end(), [&](const DataFrame& other) {
      return other.columns() == chart->rows.columns();
    });
    if (frame == frames_.end()) frame = frames_.insert(frame, DataFrame(chart->rows.columns()));
    const std::size_t from = frame->rows().size();
    frame->append(chart->rows);
    settings_.push_back({{"drawing", place_in(drawings_, drawing)},
                         {"frame", frame - frames_.begin()},
                         {"from", from},
                         {"to", frame->rows().size()}});
  }

  bool empty() const { return frames_.empty(); }

  Json to_json() const {
    Json frames = Json::array();
    for (const DataFrame& frame : frames_) frames.push_back(frame.to_json());
    return {{"settings", settings_}, {"drawings", drawings_}, {"frames", std::move(frames)}};
  }

 private:
  Json settings_ = Json::array();
  std::vector<Json> drawings_;
  std::vector<DataFrame> frames_;
};

std::string chart_html(const std::vector<const SectionBlock*>& blocks, std::size_t first,
                       const std::string& id) {
  ChartPack pack;
  const Chart* shown = nullptr;
  for (const SectionBlock* block : blocks) {
    const Chart* chart = block ? std::get_if<Chart>(block) : nullptr;
    pack.add(chart);
    if (chart && (!shown || block == blocks[first])) shown = chart;
  }
  if (pack.empty()) return {};
  return fmt::format(
      "<figure class=\"chart\" id=\"{0}\" data-drawn=\"false\">\n<div class=\"picks\"></div>\n"
      "<div class=\"scroll\" tabindex=\"0\"><div class=\"drawing\"></div></div>\n"
      "<figcaption>{1}</figcaption>\n"
      "<details class=\"numbers\"><summary>Numbers<span class=\"hidden\">: {1}</span></summary>"
      "</details>\n{2}</figure>\n",
      id, html_escaped(shown->caption), packed_script(pack.to_json()));
}

}  // namespace

std::string blocks_html(const std::vector<std::vector<SectionBlock>>& by_setting, std::size_t first,
                        const std::string& section_id) {
  std::string html;
  bool has_figures = false;
  for (const auto& [key, blocks] : places_of(by_setting)) {
    const SectionBlock* any =
        *std::find_if(blocks.begin(), blocks.end(), [](auto* b) { return b; });
    const bool is_chart = std::holds_alternative<Chart>(*any);
    const std::string part =
        is_chart ? chart_html(blocks, first, section_id + '-' + key) : markup_html(blocks, first);
    has_figures |= !part.empty();
    html += part;
  }
  return has_figures ? html : std::string();
}

}  // namespace lanescope
