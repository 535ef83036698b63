// SPDX-License-Identifier: MIT
// The colours of pictures, in one place. Those of stages are of the palette of Okabe and Ito
// (2008), which readers with any kind of colour vision tell apart.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/output.h"

namespace lanescope {

inline constexpr Colour kPaper{255, 255, 255};
inline constexpr Colour kInk{30, 30, 30};
inline constexpr Colour kFaintInk{110, 110, 110};
/// A lane that is off.
inline constexpr Colour kLaneOff{38, 38, 42};
/// A pixel that nothing touches.
inline constexpr Colour kNothing{24, 24, 27};

/// The stages of all kernels of the program, in the order in which they are shown: a stage that
/// some kernels of a kind of work lack stands where the others have it.
const std::vector<std::string_view>& known_stages();

/// `#rrggbb`.
std::string colour_text(Colour colour);

/// The colour of a stage by its name. The first stages that kernels of a kind of work declare, in
/// the order of the registry, have colours of their own, so that a new kernel changes none; later
/// ones and names that no kernel has share the rest of the palette.
Colour stage_colour(std::string_view stage);

/// The colour of a value from 0 (dark) to 1 (light), clamped: `viridis` of Smith and van der Walt
/// (2015), which is perceptually uniform, interpolated between ten of its colours.
Colour heat_colour(double value);

/// `from` and `to` mixed as displayed; share 0 is `from`, 1 is `to`.
Colour mixed(Colour from, Colour to, double share);

}  // namespace lanescope
