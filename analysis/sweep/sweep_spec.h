// SPDX-License-Identifier: MIT
// What a sweep runs: a JSON document that names values of parameters, and the configurations that
// follow from it. docs/sweeps.md is its reference.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/configuration/configuration.h"

namespace lanescope {

inline constexpr int kSweepSpecVersion = 1;
inline constexpr std::string_view kSweepSpecSchema = "lanescope-sweep";

/// The cells of a sweep, each once: the cross product of the parameters without what is excluded,
/// the parameter named last varying fastest, then what is included. `where` names the spec in
/// messages (the file). Throws InputError, beginning with `where:/json/pointer`, for text that is
/// not JSON, for unknown members, for values that no run could have, alone or together, and for a
/// parameter that no cell takes; a scene that is a file is not opened.
std::vector<Configuration> parse_sweep_spec(std::string_view text, const std::string& where);

/// The parameters of which configurations have different values, by name, in the order of
/// all_parameters(). Not to take a parameter is no value.
std::vector<std::string> varying_parameters(const std::vector<Configuration>& configurations);

}  // namespace lanescope
