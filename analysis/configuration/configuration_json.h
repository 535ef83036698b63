// SPDX-License-Identifier: MIT
// The JSON form of a configuration, and back: one flat object of resolved parameters, which is what
// identifies a run in reports, comparisons and sweeps.
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/base/json_cursor.h"
#include "analysis/configuration/configuration.h"

namespace lanescope {

/// A switch as a boolean, a word as a string, nothing as null.
nlohmann::ordered_json value_json(const Value& value);

nlohmann::ordered_json configuration_json(const Configuration& configuration);

/// Throws InputError for missing or unknown members and for values of a wrong type or out of range.
/// A kernel that this program does not have may have any parameters of its own beside those of
/// every run, and scenes are not looked for: a report outlives the program that made it.
Configuration read_configuration(const JsonCursor& cursor);

/// Reads a value of a parameter. Throws InputError, saying where, what was found and what would be
/// right.
Value read_value(const Parameter& parameter, const JsonCursor& value);

/// Reads a value of a parameter of the command line. `option` names it in messages.
Value parse_value(const Parameter& parameter, std::string_view text, std::string_view option);

/// The JSON Schema of `parameters` of a run: for each kernel of the program its own parameters.
nlohmann::ordered_json configuration_schema();

}  // namespace lanescope
