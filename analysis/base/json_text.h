// SPDX-License-Identifier: MIT
// JSON as people can read and compare it: indented, but a list or object of plain values on one
// line.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace lanescope {

/// The number with the shortest decimal that reads back as the same float: 0.1f is written as 0.1
/// and not as 0.10000000149.
double json_number(float value);

/// A time, to the microsecond.
double json_ms(double ms);

/// The number, or null.
nlohmann::ordered_json number_or_null(const std::optional<double>& value);

/// A hash as reports have it: `0x` and 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

/// The document, with a newline at the end. Values that are not finite are written as null.
std::string json_text(const nlohmann::ordered_json& value);

}  // namespace lanescope
