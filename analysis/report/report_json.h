// SPDX-License-Identifier: MIT
// The JSON form of a report, and back. Keys are in a fixed order, counts are integers, hashes are
// hexadecimal strings, and a ratio is {numerator, denominator, value}, with null where undefined.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "analysis/report/report.h"

namespace lanescope {

/// Types of the elements of a vector, by their names in reports.
inline constexpr std::array<std::string_view, 3> kElementTypes{"float32", "int32", "uint32"};

nlohmann::ordered_json to_json(const Report& report);
/// One element of the member `runs`.
nlohmann::ordered_json to_json(const RunRecord& run);

/// to_json as a document: one line for each list of numbers. Byte-identical for equal reports; all
/// that depends on the clock or the host is in the last member, `timing`.
std::string report_text(const Report& report);

/// Reads a report. `where` names it in messages (the file). Throws InputError, beginning with
/// `where:/json/pointer`, for all that the schema refuses, and for what it cannot see: names that
/// are there twice or refer to nothing, lists of a wrong length, counts that do not fit together,
/// and derived values that do not follow from their counts.
Report parse_report(std::string_view text, const std::string& where);

/// Reads a report from a file. Throws InputError as parse_report does, or if it cannot be read.
Report read_report(const std::string& path);

/// The JSON Schema (2020-12) of the form, as a document, with the parameters of every kernel of the
/// program.
std::string report_json_schema();

}  // namespace lanescope
