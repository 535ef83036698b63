// SPDX-License-Identifier: MIT
// The colours of pictures, in one place. Those of stages are of the palette of Okabe and Ito
// (2008), which readers with any kind of colour vision tell apart.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "analysis/pictures/image.h"

namespace lanescope {

inline constexpr Colour kPaper{255, 255, 255};
inline constexpr Colour kInk{30, 30, 30};
inline constexpr Colour kFaintInk{110, 110, 110};
/// A lane that is off.
inline constexpr Colour kLaneOff{38, 38, 42};
/// A pixel that nothing touches.
inline constexpr Colour kNothing{24, 24, 27};

/// Stages that have colours of their own, in the order in which they are shown.
std::span<const std::string_view> coloured_stages();

/// `#rrggbb`.
std::string colour_text(Colour colour);

/// The colour of a stage by its name. Names that no kernel of ours uses share the palette's other
/// colours, by `place`, the stage's place in its kernel.
Colour stage_colour(std::string_view stage, std::size_t place);

/// The colour of a value from 0 (dark) to 1 (light), clamped: `viridis` of Smith and van der Walt
/// (2015), which is perceptually uniform, interpolated between ten of its colours.
Colour heat_colour(double value);

/// A colour that tells a micropolygon from its neighbours; none is as dark as kNothing.
Colour identity_colour(std::uint64_t micropolygon_id);

/// `from` and `to` mixed as displayed; share 0 is `from`, 1 is `to`.
Colour mixed(Colour from, Colour to, double share);

}  // namespace lanescope
