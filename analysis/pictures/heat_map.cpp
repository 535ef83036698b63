// SPDX-License-Identifier: MIT
#include "analysis/pictures/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/pictures/canvas.h"
#include "analysis/pictures/palette.h"

namespace lanescope {
namespace {

// In pixels.
constexpr int kMargin = 16;
constexpr int kHead = 34;
constexpr int kMinWidth = 420;  ///< So that the line below a small picture has room.
constexpr int kBarGap = 16, kBarWidth = 18, kLabels = 74;
constexpr TextStyle kTitle{15.0, kInk, true};
constexpr int kTitleAdvance = 9;  ///< At least the mean of its letters.
constexpr TextStyle kText{13.0, kInk};

/// The share of the pixels with a count that the scale holds.
constexpr double kShareInScale = 0.995;

Image picture_of(const Raster& raster, double end) {
  Image image{raster.width_px, raster.height_px, {}};
  for (const std::uint64_t count : raster.counts)
    image.pixels.push_back(count == 0
                               ? kNothing
                               : heat_colour(static_cast<double>(count) /
                                             (static_cast<double>(raster.count_unit) * end)));
  return image;
}

/// 1, 2 or 5 times a power of ten that divides the scale into some four parts.
double tick_step(double end) {
  const double power = std::pow(10.0, std::floor(std::log10(end / 4.0)));
  for (const double step : {1.0, 2.0, 5.0})
    if (end / (step * power) <= 6.0) return step * power;
  return 10.0 * power;
}

void draw_bar(Canvas& canvas, double end, double x, double y, int height) {
  for (int i = 0; i < height; ++i)
    canvas.fill(heat_colour(1.0 - (i + 0.5) / height), {x, y + i, kBarWidth, 1});
  const double step = tick_step(end);
  for (int i = 0; i * step <= end; ++i) {
    const double at = std::floor(y + height * (1.0 - i * step / end));
    canvas.fill(kInk, {x + kBarWidth, std::min(at, y + height - 1), 5, 1});
    canvas.text(x + kBarWidth + 9, at + 5, fmt::format("{:g}", i * step), kText);
  }
}

}  // namespace

std::string raster_png(const Raster& raster, const std::string& title) {
  return raster.counts.empty() ? png(raster) : heat_map_png(raster, title);
}

double scale_end(const Raster& raster) {
  std::vector<std::uint64_t> touched;
  for (const std::uint64_t count : raster.counts)
    if (count > 0) touched.push_back(count);
  if (touched.empty()) return 1.0;
  const auto place =
      static_cast<std::ptrdiff_t>(kShareInScale * static_cast<double>(touched.size() - 1));
  std::nth_element(touched.begin(), touched.begin() + place, touched.end());
  return static_cast<double>(touched[static_cast<std::size_t>(place)]) /
         static_cast<double>(raster.count_unit);
}

std::string heat_map_png(const Raster& raster, const std::string& title) {
  const double end = scale_end(raster);
  const std::uint64_t most = *std::max_element(raster.counts.begin(), raster.counts.end());
  const int width = std::max({kMinWidth, kMargin + raster.width_px + kBarGap + kBarWidth + kLabels,
                              2 * kMargin + kTitleAdvance * static_cast<int>(title.size())});
  const int height = kHead + raster.height_px + kMargin + 18;
  const auto canvas = make_canvas(PictureFormat::kPng, width, height);
  canvas->text(kMargin, 22, title, kTitle);
  canvas->image(kMargin, kHead, picture_of(raster, end));
  draw_bar(*canvas, end, kMargin + raster.width_px + kBarGap, kHead, raster.height_px);
  TextStyle right = kText;
  right.align = Align::kRight;
  canvas->text(width - kMargin, height - 12,
               fmt::format("{}; at most {:g}; dark: 0", raster.counted,
                           static_cast<double>(most) / static_cast<double>(raster.count_unit)),
               right);
  return canvas->finish();
}

}  // namespace lanescope
