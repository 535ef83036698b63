// SPDX-License-Identifier: MIT
// The figures of the thesis's tables, of the scenes of a view: means over scenes of each scene's
// ratio, as in the thesis (4). Sums go over the stages of its tables, so without Setup, unless
// said.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "analysis/report/figures.h"
#include "analysis/tables/report_view.h"

namespace lanescope {

inline constexpr Series kLockstepTriangle{"lockstep", Micropolygon::kTriangle};
inline constexpr Series kLockstepQuad{"lockstep", Micropolygon::kQuad};
inline constexpr Series kRepackTriangle{"repack", Micropolygon::kTriangle};
inline constexpr Series kRepackQuad{"repack", Micropolygon::kQuad};

/// Where a claim of the thesis does not say at which width it was measured, ours is measured here:
/// the width of its section 4.3.
inline constexpr int kClaimWidth = 16;

std::optional<double> stage_utilization(const ReportView& view, const Series& series,
                                        std::string_view stage, int width);
/// Instructions of a stage over those of all stages that `of` names.
std::optional<double> stage_share(const ReportView& view, const Series& series,
                                  std::string_view stage, int width, Stages of = Stages::kThesis);
std::optional<double> overall_utilization(const ReportView& view, const Series& series, int width,
                                          Stages stages = Stages::kThesis);
std::optional<double> instructions(const ReportView& view, const Series& series, int width,
                                   Stages stages = Stages::kThesis);
std::optional<double> stage_instructions(const ReportView& view, const Series& series,
                                         std::string_view stage, int width);
/// Share of a stage's instructions that the kernel marked as overhead (table 4.3).
std::optional<double> overhead_share(const ReportView& view, const Series& series,
                                     std::string_view stage, int width);
/// Arithmetic mean of overhead_share over the widths of the report.
std::optional<double> mean_overhead_share(const ReportView& view, const Series& series,
                                          std::string_view stage);
/// Test and Test Stream-load together (4.1.2).
std::optional<double> test_and_load_utilization(const ReportView& view, const Series& series,
                                                int width);

/// Hits over tests.
std::optional<double> sample_test_efficiency(const ReportView& view, Micropolygon shape);
/// Those that face the viewer, are on screen and have an area: the ones that are rasterized.
std::optional<double> micropolygons_rasterized(const ReportView& view, Micropolygon shape);
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

/// Instructions a second at 60 frames a second, at kClaimWidth on LOCKSTEP (4.3). With
/// `before_culling`, as if micropolygons that are culled cost as much as the others.
std::optional<double> instructions_per_second(const ReportView& view, Micropolygon shape,
                                              bool before_culling);

/// a / b; none where either is missing or b is 0.
std::optional<double> quotient(std::optional<double> a, std::optional<double> b);

}  // namespace lanescope
