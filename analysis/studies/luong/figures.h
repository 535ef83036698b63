// SPDX-License-Identifier: MIT
// The figures of the thesis's tables, of the scenes of a view: means over scenes of each scene's
// ratio, as in the thesis (4). Sums go over the stages of its tables, so without Setup, unless
// said.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/tables/means.h"
#include "analysis/tables/report_view.h"
#include "analysis/tables/table.h"

namespace lanescope::luong {

inline constexpr std::string_view kTriangle = "triangle";
inline constexpr std::string_view kQuad = "quad";

inline const Series kLockstepTriangle{"lockstep", "triangle"};
inline const Series kLockstepQuad{"lockstep", "quad"};
inline const Series kRepackTriangle{"repack", "triangle"};
inline const Series kRepackQuad{"repack", "quad"};

/// The stages of its tables: all but Setup.
inline constexpr std::string_view kSetup = "Setup";
inline const Stages kAllButSetup = Stages::all_but(kSetup);

/// Where a claim of the thesis does not say at which width it was measured, ours is measured here:
/// the width of its section 4.3.
inline constexpr int kClaimWidth = 16;

inline constexpr Unit kInstructionsPerMp{"instructions/micropolygon", 1.0, "", 2, 2,
                                         Difference::kRelative};
inline constexpr Unit kRoundInstructions{"instructions/micropolygon", 1.0, "", 1, 1,
                                         Difference::kRelative};
inline constexpr Unit kWidths{"W", 1.0, " W", 2, 1, Difference::kAbsolute};

/// `triangles`.
std::string plural(std::string_view facet);

/// Widths of the series in the report, ascending; the thesis's if it has none.
std::vector<int> widths_of(const ReportView& view, const Series& series);

/// Instructions of a stage over those of all stages that `of` names.
std::optional<double> stage_share(const ReportView& view, const Series& series,
                                  std::string_view stage, int width, Stages of = kAllButSetup);
std::optional<double> overall_utilization(const ReportView& view, const Series& series, int width,
                                          Stages stages = kAllButSetup);
std::optional<double> instructions(const ReportView& view, const Series& series, int width,
                                   Stages stages = kAllButSetup);
/// Share of a stage's instructions that the kernel marked as overhead (table 4.3): arithmetic mean
/// over the widths of the report.
std::optional<double> overhead_over_widths(const ReportView& view, const Series& series,
                                           std::string_view stage);
/// Test and Test Stream-load together (4.1.2).
std::optional<double> test_and_load_utilization(const ReportView& view, const Series& series,
                                                int width);

/// A figure that no kernel or width changes, as a mean over the scenes.
std::optional<double> mean_of_any(const ReportView& view, std::string_view facet,
                                  const RunFigure& figure);
/// Hits over tests.
std::optional<double> sample_test_efficiency(const ReportView& view, std::string_view facet);
/// Those that face the viewer, are on screen and have an area: the ones that are rasterized.
std::optional<double> micropolygons_rasterized(const ReportView& view, std::string_view facet);
/// Share of all instructions that quads save over triangles, scene by scene (4.2).
std::optional<double> saved_by_quads(const ReportView& view, std::string_view kernel, int width);

/// Micropolygons alive over W: the mean over scenes of the averages.
std::optional<double> average_working_set(const ReportView& view, const Series& series, int width);
/// Micropolygons alive over W: the largest of any scene.
std::optional<double> largest_working_set(const ReportView& view, const Series& series, int width);
/// Process invocations in which two lanes hit one sample, over all invocations.
std::optional<double> conflicting_invocations(const ReportView& view, const Series& series,
                                              int width);
/// Hits of a sample that an earlier lane of the same invocation hit, over all hits.
std::optional<double> conflicting_hits(const ReportView& view, const Series& series, int width);

/// Of the estimate of the thesis (4.3).
inline constexpr double kFramesPerSecond = 60.0;

/// Instructions a second at kFramesPerSecond, at kClaimWidth (4.3). With `before_culling`, as if
/// micropolygons that are culled cost as much as the others.
std::optional<double> instructions_per_second(const ReportView& view, const Series& series,
                                              bool before_culling);

/// Instructions a second of a Larrabee unit: the thesis divides its 22 billion among 20 of them.
std::optional<double> instructions_of_a_unit();

}  // namespace lanescope::luong
