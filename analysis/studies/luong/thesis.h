// SPDX-License-Identifier: MIT
// The numbers of the thesis (Luong 2010, chapter 4), from thesis-tables.json in data/, which is
// built into the program.
#pragma once

#include <array>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace lanescope::luong {

/// The widths of the thesis's tables.
inline constexpr std::array<int, 4> kThesisWidths{8, 16, 32, 64};

/// The stages of its tables, in their order. LOCKSTEP has no Test Stream-load.
inline constexpr std::array<std::string_view, 4> kThesisStages{"Bound", "Test Stream-load", "Test",
                                                               "Process"};

/// The whole document.
const nlohmann::ordered_json& thesis();

/// The number at a path of member names; none if the thesis does not give it.
std::optional<double> thesis_value(std::initializer_list<std::string_view> path);

/// The element for a width of the list at a path; none if the thesis does not give it.
std::optional<double> thesis_value(std::initializer_list<std::string_view> path, int width);

}  // namespace lanescope::luong
