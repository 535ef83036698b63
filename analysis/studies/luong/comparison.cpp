// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "analysis/base/json_text.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/studies/luong/study.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

using Json = nlohmann::ordered_json;

/// The members of the setup that the thesis gives and that figures depend on.
constexpr std::array<std::string_view, 4> kSettings{"resolution", "msaa", "quad_area_px",
                                                    "backface_culling"};

bool has(std::span<const std::string_view> list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// `1728x1080`, `on`, `4`.
std::string shown_setting(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (!value.is_array()) return value.dump();
  return fmt::format("{}x{}", value.at(0).dump(), value.at(1).dump());
}

std::string with_spaces(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

/// What of one run is not the thesis's.
void add_differences(std::set<std::string>& differences, const Configuration& configuration) {
  const Json ours = setup_json(configuration, {});
  const Json& theirs = thesis().at("setup");
  for (const std::string_view name : kSettings)
    if (const Json& a = ours.at(std::string(name)), &b = theirs.at(std::string(name)); a != b)
      differences.insert(fmt::format("{} is {} (thesis: {})", with_spaces(name), shown_setting(a),
                                     shown_setting(b)));
}

bool are_the_studys(const std::vector<std::string>& scenes) {
  return scenes.size() == study_luong.scenes.size() &&
         std::all_of(scenes.begin(), scenes.end(),
                     [](const std::string& scene) { return has(study_luong.scenes, scene); });
}

void mark_not_comparable(TableData& data) {
  for (Row& row : data.rows)
    for (Cell& cell : row.cells) {
      if (cell.figure) cell.figure->comparable = false;
      if (cell.share) cell.share->comparable = false;
    }
}

bool says_not_comparable(const TableData& data) {
  return std::any_of(data.rows.begin(), data.rows.end(), [](const Row& row) {
    return std::any_of(row.cells.begin(), row.cells.end(), [](const Cell& cell) {
      return shown_paper(cell) == kNotComparable || cell.words == kNotComparable;
    });
  });
}

}  // namespace

Json setup_json(const Configuration& configuration, const std::vector<std::string>& scenes) {
  const auto parameter = [&](std::string_view name) {
    return value_json(value_of(configuration, name));
  };
  const Value area = value_of(configuration, "dice_area_px");
  const float* const quad_area = std::get_if<float>(&area);
  return {{"widths", kThesisWidths},
          {"resolution", {parameter("width_px"), parameter("height_px")}},
          {"msaa", parameter("samples_per_pixel")},
          {"triangle_area_px", quad_area ? Json(json_number(*quad_area / 2)) : Json(nullptr)},
          {"quad_area_px", parameter("dice_area_px")},
          {"backface_culling", parameter("cull_backfaces")},
          {"averaged_over_scenes", scenes},
          {"instruction_counts_are",
           "vector instructions (one for all lanes), per rasterized micropolygon where marked "
           "ops_per_mp"}};
}

std::vector<std::string> differences_from_thesis(const ReportView& view) {
  std::set<std::string> differences;
  for (const RunRecord& run : view.report().runs) {
    const Configuration& c = run.configuration;
    const bool is_shown =
        std::find(view.scenes().begin(), view.scenes().end(), c.scene) != view.scenes().end();
    if (is_shown && has(study_luong.kernels, c.kernel)) add_differences(differences, c);
  }
  if (!are_the_studys(view.scenes()))
    differences.insert(
        fmt::format("scenes: {} (thesis: the mean of its four, for which {} stand in)",
                    view.caption(), fmt::join(study_luong.scenes, ", ")));
  return {differences.begin(), differences.end()};
}

TableData beside_thesis(const ReportView& view, TableData data) {
  const std::vector<std::string> differences = differences_from_thesis(view);
  if (differences.empty()) return data;
  mark_not_comparable(data);
  if (!says_not_comparable(data)) return data;
  data.notes.push_back(
      fmt::format("Not comparable with the thesis: {}.", fmt::join(differences, "; ")));
  return data;
}

}  // namespace lanescope::luong
