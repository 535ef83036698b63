// SPDX-License-Identifier: MIT
// What numbers the parameters of a configuration may have, for all who take them from a user.
#pragma once

#include <array>
#include <string_view>

namespace lanescope {

/// The least and the greatest value; both are allowed.
struct Limits {
  double low;
  double high;
};

/// The limits of a parameter, by its name in reports, or null if it has none: it is no number, or
/// any number that its type can hold will do.
const Limits* find_limits(std::string_view parameter);

/// Samples a pixel may have.
inline constexpr std::array<int, 5> kSampleCounts{1, 4, 9, 16, 64};

}  // namespace lanescope
