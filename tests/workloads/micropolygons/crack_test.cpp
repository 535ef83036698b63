// SPDX-License-Identifier: MIT
// Cracks: samples that no front face covers although all of their neighbours are covered.
#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/random.h"
#include "tests/workloads/micropolygons/tessellation.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

/// One jittered sample a cell; which of them a front face covers.
class Coverage {
 public:
  Coverage(int width, int height)
      : width_(width), height_(height), covered_(static_cast<std::size_t>(width * height)) {}

  void add(const test::Polygon& p) {
    if (p.area() <= 0.0) return;
    const auto [left, right] = std::minmax({p.x(0), p.x(1), p.x(2)});
    const auto [top, bottom] = std::minmax({p.y(0), p.y(1), p.y(2)});
    for (int y = first(top); y <= last(bottom, height_); ++y)
      for (int x = first(left); x <= last(right, width_); ++x)
        if (inside(p, x, y)) covered_[index(x, y)] = 1;
  }

  /// Uncovered samples whose 24 nearest are all covered.
  int cracks() const {
    int count = 0;
    for (int y = 2; y < height_ - 2; ++y)
      for (int x = 2; x < width_ - 2; ++x)
        if (!covered_[index(x, y)] && neighbours(x, y) == 24) ++count;
    return count;
  }

 private:
  static int first(float low) { return std::max(0, static_cast<int>(std::floor(low))); }
  static int last(float high, int size) {
    return std::min(size - 1, static_cast<int>(std::floor(high)));
  }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * width_ + x); }

  bool inside(const test::Polygon& p, int x, int y) const {
    const std::uint64_t hash = mix64(index(x, y));
    const double sx = x + double{unit_float(hash)}, sy = y + double{unit_float(mix64(hash))};
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const double dx = double{p.x(j)} - p.x(i), dy = double{p.y(j)} - p.y(i);
      if (dx * (sy - p.y(i)) - dy * (sx - p.x(i)) < 0.0) return false;
    }
    return true;
  }

  int neighbours(int x, int y) const {
    int count = 0;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) count += covered_[index(x + dx, y + dy)];
    return count;
  }

  int width_, height_;
  std::vector<std::uint8_t> covered_;
};

int cracks(const SurfaceScene& descriptor, float overlap_px) {
  const Scene scene = descriptor.build(descriptor.default_frame);
  TessellationOptions options = test::small_options(Micropolygon::kTriangle);
  options.grid_overlap_px = overlap_px;
  Coverage coverage(options.width_px * samples_per_axis(options.samples_per_pixel),
                    options.height_px * samples_per_axis(options.samples_per_pixel));
  const Tessellator tessellator(scene, options);
  for (int segment = 0; segment < tessellator.segment_count(); ++segment)
    tessellator.tessellate(segment, [&](const Packet& packet) {
      for (int i = 0; i < packet.size(); ++i) coverage.add(test::polygon_of(packet, i));
    });
  return coverage.cracks();
}

TEST(Cracks, OverlappingGridsCloseThem) {
  int without = 0, with = 0;
  for (const SurfaceScene* scene : surface_scenes()) {
    without += cracks(*scene, 0.0f);
    const int left = cracks(*scene, kGridOverlapPx);
    EXPECT_LE(left, 4) << scene->name;
    with += left;
  }
  EXPECT_GT(without, 10 * with);
  EXPECT_GT(without, 0);
}

}  // namespace
}  // namespace lanescope
