// SPDX-License-Identifier: MIT
// Parameters and the values that a spec gives them.
#pragma once

#include <string>
#include <vector>

#include "analysis/base/json_cursor.h"
#include "simulator/base/parameter.h"

namespace lanescope {

/// A value of a parameter, and the place in the spec that gives it.
struct AxisValue {
  std::string where;
  Value value;
};

/// A parameter and the values given for it, at least one.
struct Axis {
  std::string parameter;
  std::string where;
  std::vector<AxisValue> values;
};

/// Reads an object of parameters, each with one value or a list of them. Throws InputError for a
/// parameter that no kernel takes, and for a value that no run could have.
std::vector<Axis> read_axes(const JsonCursor& object);

}  // namespace lanescope
