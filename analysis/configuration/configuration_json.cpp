// SPDX-License-Identifier: MIT
#include "analysis/configuration/configuration_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "analysis/base/json_text.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// The value in the type of the parameter; nothing if it is of another type.
Value typed(const Parameter& parameter, const Json& json) {
  switch (parameter.kind) {
    case Parameter::Kind::kSwitch:
      if (json.is_boolean()) return json.get<bool>();
      break;
    case Parameter::Kind::kInteger:
      if (json.is_number_unsigned()) return json.get<std::uint64_t>();
      break;
    case Parameter::Kind::kNumber:
      if (json.is_number()) return static_cast<float>(json.get<double>());
      break;
    case Parameter::Kind::kChoice:
    case Parameter::Kind::kText:
      if (json.is_string()) return json.get<std::string>();
      break;
  }
  return {};
}

/// The value of a parameter that this program does not know.
Value untyped(const JsonCursor& cursor, const Json& json) {
  if (json.is_null()) return {};
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_unsigned()) return json.get<std::uint64_t>();
  if (json.is_string()) return json.get<std::string>();
  if (json.is_number() && std::isfinite(static_cast<float>(json.get<double>())))
    return static_cast<float>(json.get<double>());
  cursor.fail("a value of a parameter");
}

std::string expected(const Parameter& parameter) {
  return parameter.kind == Parameter::Kind::kSwitch ? "true or false" : parameter.allowed_values();
}

/// The whole text as a number; false if that is not what it is.
template <class Number>
bool read_whole(std::string_view text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

Value parsed(const Parameter& parameter, std::string_view text) {
  std::uint64_t integer = 0;
  float number = 0.0f;
  switch (parameter.kind) {
    case Parameter::Kind::kSwitch:
      if (text == "on" || text == "off") return text == "on";
      return {};
    case Parameter::Kind::kInteger:
      return read_whole(text, integer) ? Value(integer) : Value();
    case Parameter::Kind::kNumber:
      return read_whole(text, number) ? Value(number) : Value();
    case Parameter::Kind::kChoice:
    case Parameter::Kind::kText:
      return std::string(text);
  }
  return {};
}

/// What `untyped` reads.
Json untyped_schema() {
  return {{"type", {"boolean", "number", "string", "null"}},
          {"minimum", json_number(std::numeric_limits<float>::lowest())},
          {"maximum", json_number(std::numeric_limits<float>::max())}};
}

std::vector<std::string> member_names(const Kernel& kernel) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters_of(kernel)) names.emplace_back(parameter.name());
  return names;
}

Json parameter_schema(const Parameter& parameter) {
  Json schema = {
      {"description",
       fmt::format("{}{}{}{}", parameter.words.help, parameter.words.unit.empty() ? "" : " (",
                   parameter.words.unit, parameter.words.unit.empty() ? "" : ")")}};
  switch (parameter.kind) {
    case Parameter::Kind::kSwitch:
      schema["type"] = "boolean";
      break;
    case Parameter::Kind::kInteger:
      schema["type"] = "integer";
      if (parameter.allowed.empty()) {
        schema["minimum"] = parameter.low;
        schema["maximum"] = parameter.high;
      } else {
        schema["enum"] = parameter.allowed;
      }
      break;
    case Parameter::Kind::kNumber:
      schema["type"] = "number";
      schema["minimum"] = json_number(parameter.least);
      schema["maximum"] = json_number(parameter.most);
      break;
    case Parameter::Kind::kChoice:
      schema["enum"] = parameter.choices;
      break;
    case Parameter::Kind::kText:
      schema["type"] = "string";
      break;
  }
  if (!std::holds_alternative<std::monostate>(parameter.fallback)) return schema;
  if (schema.contains("enum"))
    schema["enum"].push_back(nullptr);
  else
    schema["type"] = Json::array({schema["type"], "null"});
  return schema;
}

/// The parameters of one kernel, and no others.
Json kernel_schema(const Kernel& kernel) {
  Json properties = Json::object();
  for (const Parameter& parameter : parameters_of(kernel))
    properties[std::string(parameter.name())] = parameter_schema(parameter);
  properties["kernel"]["const"] = kernel.name;
  return {{"required", member_names(kernel)},
          {"properties", std::move(properties)},
          {"additionalProperties", false}};
}

}  // namespace

Json value_json(const Value& value) {
  struct Writer {
    Json operator()(std::monostate) const { return nullptr; }
    Json operator()(bool on) const { return on; }
    Json operator()(std::uint64_t integer) const { return integer; }
    Json operator()(float number) const { return json_number(number); }
    Json operator()(const std::string& word) const { return word; }
  };
  return std::visit(Writer{}, value);
}

Json configuration_json(const Configuration& configuration) {
  Json json = Json::object();
  for (const auto& [name, value] : all_values(configuration).all()) json[name] = value_json(value);
  return json;
}

Value read_value(const Parameter& parameter, const JsonCursor& cursor) {
  if (cursor.is_null() && std::holds_alternative<std::monostate>(parameter.fallback)) return {};
  const Value value = typed(parameter, cursor.value());
  if (!std::holds_alternative<std::monostate>(value) && parameter.allows(value)) return value;
  const std::string near =
      parameter.kind == Parameter::Kind::kChoice && cursor.value().is_string()
          ? did_you_mean(cursor.string(), {parameter.choices.begin(), parameter.choices.end()})
          : "";
  cursor.fail(expected(parameter) + near);
}

Value parse_value(const Parameter& parameter, std::string_view text, std::string_view option) {
  const Value value = parsed(parameter, text);
  if (!std::holds_alternative<std::monostate>(value) && parameter.allows(value)) return value;
  throw InputError(option, "'{}' is not {}{}", text, parameter.allowed_values(),
                   parameter.kind == Parameter::Kind::kChoice
                       ? did_you_mean(text, {parameter.choices.begin(), parameter.choices.end()})
                       : "");
}

Configuration read_configuration(const JsonCursor& cursor) {
  const Kernel* const kernel = known_kernel(cursor.member("kernel").string());
  if (kernel) cursor.require_members(member_names(*kernel));
  Configuration c;
  for (const auto& binding : run_parameters()) {
    const JsonCursor member = cursor.member(binding.parameter().name());
    binding.set(c, read_value(binding.parameter(), member));
  }
  for (const std::string& name : cursor.member_names()) {
    if (all_values(Configuration{}).contains(name)) continue;
    const JsonCursor member = cursor.member(name);
    const Parameter* const parameter = kernel ? find_parameter(name) : nullptr;
    c.arguments.set(name,
                    parameter ? read_value(*parameter, member) : untyped(member, member.value()));
  }
  return c;
}

Json configuration_schema() {
  Json kernels_schema = Json::array();
  for (const Kernel* kernel : kernels()) {
    kernels_schema.push_back({{"if", {{"properties", {{"kernel", {{"const", kernel->name}}}}}}},
                              {"then", kernel_schema(*kernel)}});
  }
  Json common = Json::object();
  Json required = Json::array();
  for (const auto& binding : run_parameters()) {
    const Parameter& parameter = binding.parameter();
    common[std::string(parameter.name())] = parameter_schema(parameter);
    required.push_back(parameter.name());
  }
  return {{"description",
           "Every parameter of the run, resolved: what identifies it. Those of each kernel that "
           "this program has are listed; another program's kernels have others."},
          {"type", "object"},
          {"required", std::move(required)},
          {"properties", std::move(common)},
          {"additionalProperties", untyped_schema()},
          {"allOf", std::move(kernels_schema)}};
}

}  // namespace lanescope
