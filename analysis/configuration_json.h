// SPDX-License-Identifier: MIT
// The JSON form of a configuration, and back: one flat object of resolved parameters, which is what
// identifies a run in reports, comparisons and sweeps.
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/configuration.h"
#include "analysis/json_cursor.h"

namespace lanescope {

nlohmann::ordered_json configuration_json(const Configuration& configuration);

/// Throws InputError for missing or unknown members and for values of a wrong type or range. Whether
/// the kernel and the scene exist is not checked: a report outlives the program that made it.
Configuration read_configuration(const JsonCursor& cursor);

}  // namespace lanescope
