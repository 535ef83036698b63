// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/frame.h"

#include <algorithm>
#include <cmath>

#include "kernels/micropolygons/options.h"
#include "simulator/base/random.h"
#include "workloads/micropolygons/scene_source.h"

namespace lanescope {
namespace {

/// A channel in [0, 1] as displayed, clamped.
std::uint8_t displayed(float channel) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(channel, 0.0f, 1.0f) * 255.0f));
}

Colour background_of(const Source& source) {
  const Vec3 background = static_cast<const SceneSource&>(source).background();
  return {displayed(background.x), displayed(background.y), displayed(background.z)};
}

Colour sample_colour(std::uint64_t sample, Colour background) {
  if (sample == Frame::kEmpty) return background;
  return {static_cast<std::uint8_t>(sample), static_cast<std::uint8_t>(sample >> 8),
          static_cast<std::uint8_t>(sample >> 16)};
}

}  // namespace

std::uint64_t Frame::hash() const {
  std::uint64_t hash = 0;
  for (const std::uint64_t sample : samples_) hash = mix64(hash ^ sample);
  return hash;
}

std::uint64_t Frame::covered() const {
  return static_cast<std::uint64_t>(samples_.size()) -
         static_cast<std::uint64_t>(std::count(samples_.begin(), samples_.end(), kEmpty));
}

std::optional<Raster> Frame::picture() const {
  const int axis = grid_.samples_per_axis();
  Raster raster;
  raster.width_px = grid_.width_px();
  raster.height_px = grid_.height_px();
  const auto width = static_cast<std::size_t>(raster.width_px);
  std::vector<std::array<std::uint32_t, 3>> light(width);  // Of one row of pixels.
  std::size_t sample = 0;
  for (int y = 0; y < raster.height_px; ++y) {
    std::fill(light.begin(), light.end(), std::array<std::uint32_t, 3>{});
    for (int line = 0; line < axis; ++line)
      for (std::size_t cell = 0; cell < width * static_cast<std::size_t>(axis); ++cell) {
        const Colour colour = sample_colour(samples_[sample++], background_);
        auto& pixel = light[cell / static_cast<std::size_t>(axis)];
        for (std::size_t c = 0; c < 3; ++c) pixel[c] += std::uint32_t{colour[c]} * colour[c];
      }
    for (const auto& pixel : light) {
      Colour& mean = raster.pixels.emplace_back();
      for (std::size_t c = 0; c < 3; ++c)
        mean[c] = static_cast<std::uint8_t>(
            std::lround(std::sqrt(static_cast<double>(pixel[c]) / (axis * axis))));
    }
  }
  return raster;
}

bool Frame::reopen(const Arguments& arguments, const Source& source) {
  SampleGrid grid = sample_grid(arguments);
  if (grid.sample_count() != grid_.sample_count()) return false;
  grid_ = std::move(grid);
  background_ = background_of(source);
  std::fill(samples_.begin(), samples_.end(), kEmpty);
  return true;
}

std::unique_ptr<Output> open_frame(const Arguments& arguments, const Source& source) {
  return std::make_unique<Frame>(sample_grid(arguments), background_of(source));
}

std::uint64_t frame_samples(const Arguments& arguments) {
  const auto frame = decoded(tessellation_parameters(), arguments);
  return static_cast<std::uint64_t>(frame.width_px) * static_cast<std::uint64_t>(frame.height_px) *
         static_cast<std::uint64_t>(frame.samples_per_pixel);
}

std::uint64_t frame_bytes(const Arguments& arguments) {
  return frame_samples(arguments) * sizeof(std::uint64_t);
}

}  // namespace lanescope
