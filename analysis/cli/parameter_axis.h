// SPDX-License-Identifier: MIT
// The values that an option of the command line gives to parameters: a list, of which every
// combination with those of other options is run.
#pragma once

#include <string>
#include <vector>

#include "analysis/cli/values.h"
#include "analysis/configuration/configuration.h"

namespace lanescope {

/// More values or combinations than this are a mistake, not a plan.
inline constexpr std::size_t kMostCombinations = 100'000;

/// Throws InputError if there are more combinations than that.
void require_few(std::size_t combinations);

/// Parameters that are varied together, as they share an option, and their values.
struct ParameterAxis {
  std::vector<std::string> parameters;
  std::vector<std::vector<Value>> rows;  ///< [values][parameters]
};

/// An axis of one parameter.
ParameterAxis single_axis(std::string_view parameter, const std::vector<Value>& values);

/// The parameters of a table, in their order.
std::vector<const Parameter*> pointers(const std::vector<Parameter>& parameters);

/// Those of the parameters that are given by an option, in their order.
std::vector<const Parameter*> of_option(const std::vector<const Parameter*>& parameters,
                                        std::string_view option);

/// `WIDTHxHEIGHT`, `on|off`, `N`: what the value of parameters of one option looks like.
std::string form_of(const std::vector<const Parameter*>& parameters);

/// Reads the text of an option of these parameters: values separated by commas; an integer may be a
/// range, `1:64`, with both its ends. Throws InputError for a value that one of them cannot have.
ParameterAxis parse_axis(const Argument& argument, const std::vector<const Parameter*>& parameters);

/// Every combination of values on top of `fixed`, the last axis varying fastest. Throws InputError
/// if there are too many.
std::vector<Arguments> cross(const std::vector<ParameterAxis>& axes, const Arguments& fixed);

}  // namespace lanescope
