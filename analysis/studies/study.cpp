// SPDX-License-Identifier: MIT
#include "analysis/studies/study.h"

#include <algorithm>

namespace lanescope {
namespace {

std::vector<std::string> own_scenes(const Study& study) {
  return {study.scenes.begin(), study.scenes.end()};
}

void add(std::vector<const Section*>& sections, const Section* section) {
  const auto same = std::find_if(sections.begin(), sections.end(),
                                 [&](const Section* other) { return other->id == section->id; });
  if (same == sections.end())
    sections.push_back(section);
  else
    *same = section;
}

}  // namespace

ReportView view_of(const Study& study, const Report& report) {
  return ReportView(report, scenes_of(report, own_scenes(study)));
}

PagePlan page_plan(const Report& setting, const std::vector<const Study*>& studies) {
  PagePlan plan{sections(), {}};
  for (const Study* study : studies) {
    if (!study->is_about(setting)) continue;
    for (const Section* section : study->sections()) add(plan.sections, section);
    const std::vector<std::string> scenes = own_scenes(*study);
    plan.scenes.insert(plan.scenes.end(), scenes.begin(), scenes.end());
  }
  return plan;
}

}  // namespace lanescope
