// SPDX-License-Identifier: MIT
// RASTMP (the thesis, figure 3.1) as plain scalar code: the reference that every other kernel's
// hits and frame are compared with.
#include "kernels/micropolygons/rastmp.h"

#include <algorithm>
#include <cmath>

#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/fill_rule.h"
#include "kernels/micropolygons/frame.h"
#include "kernels/micropolygons/options.h"
#include "kernels/micropolygons/sample_views.h"
#include "workloads/micropolygons/micropolygon.h"
#include "workloads/micropolygons/workload.h"

namespace lanescope {
namespace {

struct Corner {
  float x, y, z, red, green, blue, alpha;
};

// The same expressions as the vector kernels, so that rounding is the same where it happens.
float min(float a, float b) { return a < b ? a : b; }
float max(float a, float b) { return a > b ? a : b; }

class Rastmp final : public Execution {
 public:
  /// Without a frame, hits are only shown to the observer.
  Rastmp(const KernelOptions& options, const SampleGrid& grid, Frame* frame,
         SampleObserver* observer)
      : options_(options), grid_(grid), frame_(frame), observer_(observer) {}

  void run(const Work& work) override {
    const auto& packet = static_cast<const Packet&>(work);
    n_ = corner_count(packet.shape());
    for (int i = 0; i < packet.size(); ++i) {
      for (int k = 0; k < n_; ++k) corners_[k] = corner(packet, k, i);
      rasterize_one(packet.first_id + static_cast<std::uint64_t>(i));
    }
  }

  KernelResult result() const override {
    KernelResult result;
    result.counts = Counts(1, 0);
    result.counters.assign(counts_.begin(), counts_.begin() + kHits + 1);
    result.results_hash = hits_hash_;
    return result;
  }

 private:
  static Corner corner(const Packet& packet, int k, int i) {
    const auto value = [&](Attribute a) { return packet.values(k, a)[i]; };
    return {value(Attribute::kX),    value(Attribute::kY),     value(Attribute::kZ),
            value(Attribute::kRed),  value(Attribute::kGreen), value(Attribute::kBlue),
            value(Attribute::kAlpha)};
  }

  /// Twice the area; of a quad, from its diagonals.
  float doubled_area() const {
    const Corner &a = corners_[0], &b = corners_[1], &c = corners_[2];
    if (n_ == 3) return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const Corner& d = corners_[3];
    return (c.x - a.x) * (d.y - b.y) - (c.y - a.y) * (d.x - b.x);
  }

  void rasterize_one(std::uint64_t id) {
    ++counts_[kSeen];
    float area = doubled_area();
    if (area < 0.0f) {
      if (options_.cull_backfaces) {
        ++counts_[kCulled];
        return;
      }
      std::swap(corners_[1], corners_[n_ - 1]);
      area = doubled_area();
    }
    if (!(area > 0.0f)) {
      ++counts_[kDegenerate];
      return;
    }
    ++counts_[kRasterized];
    inverse_area_ = 1.0f / area;
    area_ = area;
    test_box(id);
  }

  void test_box(std::uint64_t id) {
    float x0 = corners_[0].x, x1 = x0, y0 = corners_[0].y, y1 = y0;
    for (int k = 1; k < n_; ++k) {
      x0 = min(x0, corners_[k].x);
      x1 = max(x1, corners_[k].x);
      y0 = min(y0, corners_[k].y);
      y1 = max(y1, corners_[k].y);
    }
    x0 = max(std::floor(x0), 0.0f);
    y0 = max(std::floor(y0), 0.0f);
    x1 = min(std::floor(x1), static_cast<float>(grid_.width_cells() - 1));
    y1 = min(std::floor(y1), static_cast<float>(grid_.height_cells() - 1));
    if (!(x0 <= x1 && y0 <= y1)) {
      ++counts_[kOffScreen];
      return;
    }
    for (int y = static_cast<int>(y0); y <= static_cast<int>(y1); ++y)
      for (int x = static_cast<int>(x0); x <= static_cast<int>(x1); ++x) test(id, x, y);
  }

  void test(std::uint64_t id, int x, int y) {
    ++counts_[kTests];
    const auto sample = static_cast<std::uint32_t>(y * grid_.width_cells() + x);
    if (observer_) observer_->tested(sample);
    const std::size_t offset = 2 * std::size_t{sample % SampleGrid::kJitterPeriod};
    const float px = static_cast<float>(x) + grid_.jitter()[offset];
    const float py = static_cast<float>(y) + grid_.jitter()[offset + 1];
    float edges[4] = {};
    for (int k = 0; k < n_; ++k)
      edges[k] =
          options_.edges == Edges::kInline ? inline_edge(k, px, py) : precomputed_edge(k, px, py);
    if (!covers(edges)) return;
    ++counts_[kHits];
    hits_hash_ += hit_hash(id, sample);
    process(id, sample, edges);
  }

  const Corner& from(int k) const { return corners_[k]; }
  const Corner& to(int k) const { return corners_[(k + 1) % n_]; }

  /// Edge function of the edge from corner k to the next; positive inside.
  float inline_edge(int k, float px, float py) const {
    const float ax = from(k).x - px, ay = from(k).y - py;
    const float bx = to(k).x - px, by = to(k).y - py;
    return ax * by - ay * bx;
  }

  /// The same from the equation A x + B y + C relative to corner 0.
  float precomputed_edge(int k, float px, float py) const {
    const float a = from(k).y - to(k).y;
    const float b = to(k).x - from(k).x;
    const float rx = px - corners_[0].x, ry = py - corners_[0].y;
    return std::fma(a, rx, std::fma(b, ry, edge_constant(k)));
  }

  float edge_constant(int k) const {
    if (k == 0 || k == n_ - 1) return 0.0f;
    if (n_ == 3) return area_;
    const float ax = from(k).x - corners_[0].x, ay = from(k).y - corners_[0].y;
    const float bx = to(k).x - corners_[0].x, by = to(k).y - corners_[0].y;
    return ax * by - ay * bx;
  }

  bool covers(const float (&edges)[4]) const {
    float least = edges[0];
    for (int k = 1; k < n_; ++k) least = min(least, edges[k]);
    if (least > 0.0f) return true;
    if (least != 0.0f) return false;
    for (int k = 0; k < n_; ++k)
      if (edges[k] == 0.0f && !owns_edge(to(k).x - from(k).x, to(k).y - from(k).y)) return false;
    return true;
  }

  void process(std::uint64_t id, std::uint32_t sample, const float (&e)[4]) {
    float weights[4];
    if (n_ == 3) {
      weights[0] = e[1] * inverse_area_;
      weights[1] = e[2] * inverse_area_;
      weights[2] = e[0] * inverse_area_;
    } else {
      const float u = e[3] / (e[3] + e[1]);
      const float v = e[0] / (e[0] + e[2]);
      weights[2] = u * v;
      weights[1] = u - weights[2];
      weights[3] = v - weights[2];
      weights[0] = (1.0f - u) - weights[3];
    }
    const auto blend = [&](float Corner::*attribute) {
      float sum = weights[0] * corners_[0].*attribute;
      for (int k = 1; k < n_; ++k) sum = std::fma(weights[k], corners_[k].*attribute, sum);
      return sum;
    };
    const auto colour = static_cast<std::uint32_t>(pack_channels(
        blend(&Corner::red), blend(&Corner::green), blend(&Corner::blue), blend(&Corner::alpha)));
    const float depth = blend(&Corner::z);
    if (frame_) frame_->merge(sample, depth, colour);
    if (observer_) observer_->hit(id, sample, depth, colour);
  }

  KernelOptions options_;
  SampleGrid grid_;
  Frame* frame_;
  SampleObserver* observer_;
  int n_ = 0;
  Corner corners_[4]{};
  float area_ = 0.0f;
  float inverse_area_ = 0.0f;
  RasterizerCounts counts_{};
  std::uint64_t hits_hash_ = 0;
};

std::unique_ptr<Execution> start(const Launch& launch) {
  auto& frame = static_cast<Frame&>(launch.output);
  return std::make_unique<Rastmp>(kernel_options(launch.arguments), frame.grid(), &frame, nullptr);
}

}  // namespace

std::unique_ptr<Execution> start_observed_rastmp(const Arguments& arguments,
                                                 SampleObserver& observer) {
  return std::make_unique<Rastmp>(kernel_options(arguments), sample_grid(arguments), nullptr,
                                  &observer);
}

extern const Kernel k_rastmp;
const Kernel k_rastmp{
    .name = "rastmp",
    .summary = "the scalar reference: one micropolygon and one sample at a time",
    .workload = &w_micropolygons,
    .is_oracle = true,
    .parameters = joined(raster_parameters(), sampling_parameters()),
    .counters = std::span(kRasterizerCounters).first<kHits + 1>(),
    .sums = kRasterizerSums,
    .metrics = std::span(kRasterizerMetrics).first<1>(),
    .output_counters = kFrameCounters,
    .element = kMicropolygon,
    .open = open_frame,
    .output_bytes = frame_bytes,
    .start = start,
    .views = kSampleViews,
};

}  // namespace lanescope
