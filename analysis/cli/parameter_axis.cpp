// SPDX-License-Identifier: MIT
#include "analysis/cli/parameter_axis.h"

#include <algorithm>
#include <cctype>

#include "analysis/configuration/configuration_json.h"

namespace lanescope {
namespace {

/// `width_px` in px is the WIDTH.
std::string capitals(const Parameter& parameter) {
  std::string_view name = parameter.name();
  const std::string unit = fmt::format("_{}", parameter.words.unit);
  if (name.ends_with(unit)) name.remove_suffix(unit.size());
  std::string text(name);
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// What stands between commas, for parameters that share an option: a value for each.
std::vector<Value> parse_together(const Argument& argument,
                                  const std::vector<const Parameter*>& parameters) {
  std::vector<Value> row;
  std::string_view rest = argument.text;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool last = i + 1 == parameters.size();
    const std::size_t cross = last ? rest.size() : rest.find('x');
    if (cross == rest.npos) {
      std::vector<std::string> usual;
      for (const Parameter* p : parameters) usual.push_back(value_text(p->fallback));
      argument.fail(
          fmt::format("of the form {}, as {}", form_of(parameters), fmt::join(usual, "x")));
    }
    row.push_back(parse_value(*parameters[i], rest.substr(0, cross), argument.option));
    if (!last) rest.remove_prefix(cross + 1);
  }
  return row;
}

bool may_be_range(const Parameter& parameter) {
  return parameter.kind == Parameter::Kind::kInteger && parameter.allowed.empty();
}

/// `1:64`: every integer from the one to the other.
void add_range(ParameterAxis& axis, const Argument& argument, const Parameter& parameter) {
  const std::size_t colon = argument.text.find(':');
  const auto end = [&](std::string_view text) {
    return std::get<std::uint64_t>(parse_value(parameter, text, argument.option));
  };
  const std::uint64_t first = end(argument.text.substr(0, colon));
  const std::uint64_t last = end(argument.text.substr(colon + 1));
  if (first > last)
    throw InputError(argument.option, "{} holds nothing; M:N is from M to N", argument.text);
  if (last - first >= kMostCombinations)
    throw InputError(argument.option, "{} holds more than {} values", argument.text,
                     kMostCombinations);
  for (std::uint64_t value = first;; ++value) {
    axis.rows.push_back({value});
    if (value == last) break;
  }
}

}  // namespace

void require_few(std::size_t combinations) {
  if (combinations > kMostCombinations)
    throw InputError("parameters", "have more than {} combinations; shorten their lists",
                     kMostCombinations);
}

ParameterAxis single_axis(std::string_view parameter, const std::vector<Value>& values) {
  ParameterAxis axis{{std::string(parameter)}, {}};
  for (const Value& value : values) axis.rows.push_back({value});
  return axis;
}

std::vector<const Parameter*> pointers(const std::vector<Parameter>& parameters) {
  std::vector<const Parameter*> all;
  for (const Parameter& parameter : parameters) all.push_back(&parameter);
  return all;
}

std::vector<const Parameter*> of_option(const std::vector<const Parameter*>& parameters,
                                        std::string_view option) {
  std::vector<const Parameter*> found;
  for (const Parameter* parameter : parameters)
    if (parameter->words.option == option) found.push_back(parameter);
  return found;
}

std::string form_of(const std::vector<const Parameter*>& parameters) {
  if (parameters.size() > 1) {
    std::string form;
    for (const Parameter* parameter : parameters)
      form += (form.empty() ? "" : "x") + capitals(*parameter);
    return form;
  }
  switch (parameters.front()->kind) {
    case Parameter::Kind::kSwitch:
      return "on|off";
    case Parameter::Kind::kInteger:
      return "N";
    case Parameter::Kind::kNumber:
      return "X";
    case Parameter::Kind::kChoice:
      return fmt::format("{}", fmt::join(parameters.front()->choices, "|"));
    case Parameter::Kind::kText:
      return "NAME";
  }
  return {};
}

ParameterAxis parse_axis(const Argument& argument,
                         const std::vector<const Parameter*>& parameters) {
  ParameterAxis axis;
  for (const Parameter* parameter : parameters) axis.parameters.emplace_back(parameter->name());
  for (const Argument& element : parse_list(argument)) {
    if (parameters.size() == 1 && may_be_range(*parameters.front()) &&
        element.text.find(':') != element.text.npos)
      add_range(axis, element, *parameters.front());
    else
      axis.rows.push_back(parse_together(element, parameters));
  }
  return axis;
}

std::vector<Arguments> cross(const std::vector<ParameterAxis>& axes, const Arguments& fixed) {
  std::vector<Arguments> all{fixed};
  for (const ParameterAxis& axis : axes) {
    require_few(all.size() * axis.rows.size());
    std::vector<Arguments> longer;
    for (const Arguments& arguments : all)
      for (const std::vector<Value>& row : axis.rows) {
        Arguments& more = longer.emplace_back(arguments);
        for (std::size_t i = 0; i < row.size(); ++i) more.set(axis.parameters[i], row[i]);
      }
    all = std::move(longer);
  }
  return all;
}

}  // namespace lanescope
