// SPDX-License-Identifier: MIT
#include "analysis/studies/littlest/tables/over_fill.h"

namespace lanescope::littlest {
namespace {

TableData build(const ReportView& view) {
  TableData data =
      over_fill(view, "Instructions for each octant, over how full the world is", kPerOctant,
                [](const ReportView& scene, const Series& series, int width) {
                  return per_octant(scene, series, width);
                });
  data.notes = {"Cubes are filled at random. An octant ends when its image is full."};
  return data;
}

}  // namespace
}  // namespace lanescope::littlest

namespace lanescope {

extern const Table littlest_t_fill{
    "fill", "instructions for each octant, over how full the world is", littlest::build};

}  // namespace lanescope
