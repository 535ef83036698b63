// SPDX-License-Identifier: MIT
// The JSON form of a configuration, and back: one flat object of resolved parameters, which is what
// identifies a run in reports, comparisons and sweeps.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/base/json_cursor.h"
#include "analysis/configuration/configuration.h"

namespace lanescope {

nlohmann::ordered_json configuration_json(const Configuration& configuration);

/// Throws InputError for missing or unknown members and for values of a wrong type or range.
/// Whether the kernel and the scene exist is not checked: a report outlives the program that made
/// it.
Configuration read_configuration(const JsonCursor& cursor);

/// The members of the JSON form, in its order.
std::vector<std::string> parameter_names();

/// One member of the JSON form. Requires the name of a parameter, as read_parameter does.
nlohmann::ordered_json parameter_json(std::string_view name, const Configuration& configuration);

/// Sets one parameter. Throws InputError for a value of a wrong type, as read_configuration does.
void read_parameter(std::string_view name, const JsonCursor& value, Configuration& configuration);

}  // namespace lanescope
