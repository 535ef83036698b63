// SPDX-License-Identifier: MIT
// The contract of a study: a paper's experiment, its tables and charts with the paper's numbers
// beside ours, and its claims, checked. analysis/studies/<name>/ holds one.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/configuration/configuration.h"
#include "analysis/html/page.h"
#include "analysis/html/section.h"
#include "analysis/report/report.h"
#include "analysis/tables/table.h"

namespace lanescope {

/// The descriptor; analysis/studies/<name>/study.cpp defines one, and the registry lists them.
struct Study {
  std::string_view name;
  std::string_view summary;  ///< With the paper.
  /// Its kernels, by name, which are of one kind of work; an experiment runs them all.
  std::span<const std::string_view> kernels;
  /// Parameters and the values, as the command line takes them, that its experiment crosses.
  struct Axis {
    std::string_view parameter;
    std::span<const std::string_view> values;
  };
  std::span<const Axis> axes;
  /// A word that stands for some scenes on the command line, and these scenes: those that its
  /// tables average, or all of a report that has none of them. The experiment runs all scenes of
  /// the kind of work.
  std::string_view scene_group;
  std::span<const std::string_view> scenes;
  const std::vector<const Table*>& (*tables)();
  /// Sections of the page, which take the places of general ones of the same id; the others follow.
  const std::vector<const Section*>& (*sections)();
  /// Whether a report has runs, of which something was counted, that its tables and sections are
  /// about.
  bool (*is_about)(const Report& report);
  /// All its figures as one document, with the paper's keys; null if there is none.
  nlohmann::ordered_json (*figures)(const ReportView& view);
};

/// Every study of the program, in the order of its registry.
const std::vector<const Study*>& studies();

/// The scenes of a report that a study's tables average.
ReportView view_of(const Study& study, const Report& report);

/// What a page shows of the runs of one setting: the general sections, and those of each study that
/// the runs are about. Figures are averaged over the scenes of these studies.
PagePlan page_plan(const Report& setting, const std::vector<const Study*>& studies);

}  // namespace lanescope
