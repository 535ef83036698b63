// SPDX-License-Identifier: MIT
#include "analysis/html/charts/overhead_chart.h"
#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

/// Table 4.3, which is of REPACK on triangles.
std::optional<double> thesis_overhead(const Series& series, const std::string& stage) {
  if (series != kRepackTriangle) return {};
  return thesis_value({"table_4_3", "overhead", stage});
}

std::vector<SectionBlock> build(const ReportView& view) {
  if (!differences_from_thesis(view).empty()) return overhead_chart(view);
  return overhead_chart(view, PaperOverhead{"Thesis, of no width in particular",
                                            "Strokes: the thesis's figures of table 4.3, which it "
                                            "gives for no width in particular.",
                                            thesis_overhead});
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Section luong_s_overhead{
    "overhead", "Overhead",
    "What is spent on loading from, compacting into and scheduling of buffers.", luong::build};

}  // namespace lanescope
