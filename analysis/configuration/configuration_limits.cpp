// SPDX-License-Identifier: MIT
#include "analysis/configuration/configuration_limits.h"

#include <utility>

namespace lanescope {
namespace {

constexpr double kMaxSize_px = 16384;
constexpr double kMaxCount = 1 << 20;

constexpr std::array<std::pair<std::string_view, Limits>, 10> kLimits{
    {{"frame", {0, kMaxCount}},
     {"turn_degrees", {-360, 360}},
     {"stream_load_threshold", {0, 1}},
     {"width_px", {1, kMaxSize_px}},
     {"height_px", {1, kMaxSize_px}},
     {"dice_area_px", {0.01, 10000}},
     {"grid_limit", {1, 128}},
     {"packet_capacity", {1, kMaxCount}},
     {"grid_overlap_px", {0, 1}},
     {"observe_every", {0, kMaxCount}}}};

}  // namespace

const Limits* find_limits(std::string_view parameter) {
  for (const auto& [name, limits] : kLimits)
    if (name == parameter) return &limits;
  return nullptr;
}

}  // namespace lanescope
