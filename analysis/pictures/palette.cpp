// SPDX-License-Identifier: MIT
#include "analysis/pictures/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "simulator/base/random.h"

namespace lanescope {
namespace {

// Of the palette of Okabe and Ito (2008), which people who are colour-blind tell apart, those that
// stand out from white paper as well as from a dark screen.
constexpr std::array<std::string_view, 5> kStages{"Setup", "Bound", "Test Stream-load", "Test",
                                                  "Process"};
constexpr std::array<Colour, kStages.size()> kStageColours{{{0x8c, 0x8c, 0x8c},
                                                            {0x00, 0x72, 0xb2},
                                                            {0xcc, 0x79, 0xa7},
                                                            {0x00, 0x9e, 0x73},
                                                            {0xd5, 0x5e, 0x00}}};
constexpr std::array<Colour, 3> kOtherColours{
    {{0xe6, 0x9f, 0x00}, {0x56, 0xb4, 0xe9}, {0xb8, 0xa8, 0x00}}};

constexpr std::array<Colour, 10> kViridis{{{68, 1, 84},
                                           {72, 40, 120},
                                           {62, 73, 137},
                                           {49, 104, 142},
                                           {38, 130, 142},
                                           {31, 158, 137},
                                           {53, 183, 121},
                                           {110, 206, 88},
                                           {181, 222, 43},
                                           {253, 231, 37}}};

}  // namespace

std::span<const std::string_view> coloured_stages() { return kStages; }

std::string colour_text(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

Colour stage_colour(std::string_view stage, std::size_t place) {
  for (std::size_t i = 0; i < kStages.size(); ++i)
    if (kStages[i] == stage) return kStageColours[i];
  return kOtherColours[place % kOtherColours.size()];
}

Colour heat_colour(double value) {
  const double place = std::clamp(value, 0.0, 1.0) * (kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  return mixed(kViridis[below], kViridis[below + 1], place - static_cast<double>(below));
}

Colour identity_colour(std::uint64_t micropolygon_id) {
  const std::uint64_t hash = mix64(micropolygon_id);
  const auto channel = [&](int place) {
    return static_cast<std::uint8_t>(70 + (hash >> (8 * place) & 0xff) * 185 / 255);
  };
  return {channel(0), channel(1), channel(2)};
}

Colour mixed(Colour from, Colour to, double share) {
  Colour colour;
  for (std::size_t c = 0; c < colour.size(); ++c)
    colour[c] = static_cast<std::uint8_t>(
        std::lround(from[c] + share * (static_cast<double>(to[c]) - from[c])));
  return colour;
}

}  // namespace lanescope
