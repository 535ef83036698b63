// SPDX-License-Identifier: MIT
#include "analysis/pictures/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "kernels/kernel.h"
#include "simulator/base/random.h"

namespace lanescope {
namespace {

// Of the palette of Okabe and Ito (2008), which people who are colour-blind tell apart, those that
// stand out from white paper as well as from a dark screen.
constexpr std::array<Colour, 5> kStageColours{{{0x8c, 0x8c, 0x8c},
                                               {0x00, 0x72, 0xb2},
                                               {0x00, 0x9e, 0x73},
                                               {0xd5, 0x5e, 0x00},
                                               {0xcc, 0x79, 0xa7}}};
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

using Names = std::vector<std::string_view>;

/// Of one kind of work.
struct KindStages {
  Names declared;  ///< In the order in which kernels first declare them.
  Names shown;     ///< In an order that agrees with each kernel's own, as far as they agree.

  void add(std::span<const std::string_view> stages) {
    auto place = shown.begin();
    for (const std::string_view stage : stages) {
      const auto known = std::find(shown.begin(), shown.end(), stage);
      if (known == shown.end()) {
        declared.push_back(stage);
        place = shown.insert(place, stage) + 1;
      } else {
        place = known + 1;
      }
    }
  }
};

const std::vector<KindStages>& kinds() {
  static const std::vector<KindStages> all = [] {
    std::map<const Workload*, std::size_t> places;
    std::vector<KindStages> stages;
    for (const Kernel* kernel : kernels()) {
      const auto place = places.emplace(kernel->workload, stages.size()).first->second;
      stages.resize(std::max(stages.size(), place + 1));
      stages[place].add(kernel->stages);
    }
    return stages;
  }();
  return all;
}

std::size_t hash_of(std::string_view text) {
  std::uint64_t hash = 0;
  for (const char c : text) hash = mix64(hash ^ static_cast<unsigned char>(c));
  return static_cast<std::size_t>(hash);
}

}  // namespace

const std::vector<std::string_view>& known_stages() {
  static const Names all = [] {
    Names names;
    for (const KindStages& kind : kinds())
      for (const std::string_view stage : kind.shown)
        if (std::find(names.begin(), names.end(), stage) == names.end()) names.push_back(stage);
    return names;
  }();
  return all;
}

std::string colour_text(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

Colour stage_colour(std::string_view stage) {
  for (const KindStages& kind : kinds()) {
    const auto place = static_cast<std::size_t>(
        std::find(kind.declared.begin(), kind.declared.end(), stage) - kind.declared.begin());
    if (place < std::min(kStageColours.size(), kind.declared.size())) return kStageColours[place];
    if (place < kind.declared.size())
      return kOtherColours[(place - kStageColours.size()) % kOtherColours.size()];
  }
  return kOtherColours[hash_of(stage) % kOtherColours.size()];
}

Colour heat_colour(double value) {
  const double place = std::clamp(value, 0.0, 1.0) * (kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  return mixed(kViridis[below], kViridis[below + 1], place - static_cast<double>(below));
}

Colour mixed(Colour from, Colour to, double share) {
  Colour colour;
  for (std::size_t c = 0; c < colour.size(); ++c)
    colour[c] = static_cast<std::uint8_t>(
        std::lround(from[c] + share * (static_cast<double>(to[c]) - from[c])));
  return colour;
}

}  // namespace lanescope
