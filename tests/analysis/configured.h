// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>

#include "analysis/configuration/configuration.h"

namespace lanescope::testing {

/// A configuration with these values; all else is as it is by default.
inline Configuration configured(std::initializer_list<Arguments::Argument> given) {
  Arguments arguments;
  for (const auto& [name, value] : given) arguments.set(name, value);
  return resolved(arguments);
}

}  // namespace lanescope::testing
