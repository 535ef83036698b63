// SPDX-License-Identifier: MIT
// The figures of the study, of the scenes of a view: means over scenes of each scene's ratio.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/tables/means.h"
#include "analysis/tables/report_view.h"
#include "analysis/tables/table.h"

namespace lanescope::littlest {

inline constexpr std::string_view kFaces = "faces";
inline constexpr std::string_view kDirections = "directions";
inline constexpr std::string_view kArticlesForm = "across_image";
inline constexpr std::string_view kSkyError = "sky_error";
inline constexpr std::string_view kProject = "Project";

inline constexpr Unit kPerOctant{"instructions/octant", 1.0, "", 1, 1, Difference::kRelative};

/// Whether a run is of a vector program of the study.
bool is_program(const RunRecord& run);
/// The series of a report that are, in its order.
std::vector<Series> programs_of(const Report& report);
/// Those with that projection.
std::vector<Series> programs_of(const Report& report, std::string_view projection);

/// Instructions for each octant that was rendered; none where nothing was counted.
std::optional<double> per_octant(const RunRecord& run);
std::optional<double> per_octant(const ReportView& view, const Series& series, int width);
/// The same of one stage.
std::optional<double> stage_per_octant(const ReportView& view, const Series& series,
                                       std::string_view stage, int width);

/// The scattered worlds of a report, with the share of cubes that is filled, ascending.
struct Filled {
  std::string scene;
  double share;
};
std::vector<Filled> filled_scenes(const Report& report);

/// The scenes of a view, and the scattered worlds of its report behind them; each once.
std::vector<std::string> scenes_and_filled(const ReportView& view);

/// The program that needs the fewest instructions for an octant; none unless all were run.
struct Winner {
  Series series;
  double per_octant;
};
std::optional<Winner> winner(const ReportView& scene, std::string_view projection, int width);

/// The root of a mean square that sky_error counts, in open skies.
std::optional<double> root_mean_square(const ReportView& view, std::string_view projection,
                                       std::string_view counter, std::string_view count);

}  // namespace lanescope::littlest
