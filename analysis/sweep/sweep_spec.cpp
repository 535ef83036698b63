// SPDX-License-Identifier: MIT
#include "analysis/sweep/sweep_spec.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "analysis/configuration/configuration_json.h"
#include "analysis/sweep/sweep_axis.h"

namespace lanescope {
namespace {

/// More cells than this are a mistake, not a plan.
constexpr std::size_t kMaxCells = 100'000;

using Axes = std::vector<Axis>;

/// The axes of each object of an optional list.
std::vector<Axes> read_entries(const JsonCursor& document, const std::string& name) {
  if (!document.has_member(name)) return {};
  std::vector<Axes> entries;
  for (const JsonCursor& entry : document.member(name).items()) {
    entries.push_back(read_axes(entry));
    if (entries.back().empty())
      throw InputError(entry.where(), "names no parameter; {} at least one", name);
  }
  return entries;
}

/// One value for each parameter that is named.
using Assignment = std::map<std::string, const AxisValue*>;

/// The cross product; the last axis varies fastest. The axes must outlive it.
std::vector<Assignment> cross(const Axes& axes, const Assignment& fixed) {
  std::vector<Assignment> all{fixed};
  for (const Axis& axis : axes) {
    if (all.size() * axis.values.size() > kMaxCells)
      throw InputError(axis.where, "gives more than {} cells", kMaxCells);
    std::vector<Assignment> longer;
    for (const Assignment& assignment : all)
      for (const AxisValue& value : axis.values) {
        longer.push_back(assignment);
        longer.back().insert_or_assign(axis.parameter, &value);
      }
    all = std::move(longer);
  }
  return all;
}

Arguments given_by(const Assignment& assignment) {
  Arguments given;
  for (const auto& [name, value] : assignment) given.set(name, value->value);
  return given;
}

/// The values of a cell that cannot be: what is given, else the defaults of its kernel and scene.
Arguments values_of_impossible(const Arguments& given) {
  Arguments decisive;
  for (const char* name : {"kernel", "scene"})
    if (given.contains(name)) decisive.set(name, given[name]);
  Arguments values;
  try {
    values = all_values(resolved(decisive));
  } catch (const ParameterError&) {
    // The scene is of another kind of work: there are no defaults.
  }
  for (const auto& [name, value] : given.all()) values.set(name, value);
  return values;
}

/// Whether there is one of the values of each axis among these.
bool matches(const Arguments& values, const Axes& axes) {
  return std::all_of(axes.begin(), axes.end(), [&](const Axis& axis) {
    return std::any_of(axis.values.begin(), axis.values.end(), [&](const AxisValue& value) {
      return value.value == values[axis.parameter];
    });
  });
}

/// A member of the spec that gives cells.
struct Part {
  std::string where;
  std::vector<Axes> excluded;
  std::string_view advice;  ///< Against cells that cannot be.

  bool excludes(const Arguments& values) const {
    return std::any_of(excluded.begin(), excluded.end(),
                       [&](const Axes& entry) { return matches(values, entry); });
  }
};

[[noreturn]] void refuse(const ParameterError& error, const Assignment& assignment,
                         const Part& part) {
  const auto named = assignment.find(error.parameter());
  if (named != assignment.end())
    throw InputError(named->second->where, "{}{}", error.message(), part.advice);
  throw InputError(part.where, "{} is left out, and {}{}", error.parameter(), error.message(),
                   part.advice);
}

/// None if the cell is excluded; it need not be possible then.
std::optional<Configuration> cell_of(const Assignment& assignment, const Part& part) {
  const Arguments given = given_by(assignment);
  try {
    Configuration cell = resolved(given);
    if (part.excludes(all_values(cell))) return std::nullopt;
    return cell;
  } catch (const ParameterError& error) {
    if (part.excludes(values_of_impossible(given))) return std::nullopt;
    refuse(error, assignment, part);
  }
}

std::vector<Configuration> cells_of(const std::vector<Assignment>& assignments, const Part& part) {
  std::vector<Configuration> cells;
  for (const Assignment& assignment : assignments)
    if (auto cell = cell_of(assignment, part)) cells.push_back(std::move(*cell));
  return cells;
}

bool is_nothing(const Value& value) { return std::holds_alternative<std::monostate>(value); }

/// A parameter that no cell takes would have no effect, which nobody means.
void require_taken(const Axes& axes, const std::vector<Configuration>& cells) {
  for (const Axis& axis : axes) {
    const bool asks = std::any_of(axis.values.begin(), axis.values.end(),
                                  [](const AxisValue& value) { return !is_nothing(value.value); });
    const bool is_taken = std::any_of(cells.begin(), cells.end(), [&](const Configuration& cell) {
      return !is_nothing(value_of(cell, axis.parameter));
    });
    if (!asks || is_taken) continue;
    const bool is_known = std::any_of(cells.begin(), cells.end(), [&](const Configuration& cell) {
      return cell.arguments.contains(axis.parameter);
    });
    if (is_known)
      throw InputError(axis.where, "no cell takes it; it does not apply to their scenes");
    throw InputError(axis.where, "no cell takes it; it is a parameter of {}",
                     takers_of(axis.parameter));
  }
}

/// Cells in their order, each once.
std::vector<Configuration> distinct(const std::vector<Configuration>& cells) {
  std::vector<Configuration> all;
  std::set<std::string> known;
  for (const Configuration& cell : cells)
    if (known.insert(configuration_json(cell).dump()).second) all.push_back(cell);
  return all;
}

void check_schema(const JsonCursor& document) {
  document.allow_members({"schema", "parameters", "include", "exclude"});
  const JsonCursor schema = document.member("schema");
  schema.require_members({"name", "version"});
  if (schema.member("name").string() != kSweepSpecSchema)
    schema.member("name").fail(fmt::format("\"{}\"", kSweepSpecSchema));
  if (schema.member("version").integer(1) != kSweepSpecVersion)
    schema.member("version").fail(
        fmt::format("{}, the version that this program reads", kSweepSpecVersion));
}

}  // namespace

std::vector<Configuration> parse_sweep_spec(std::string_view text, const std::string& where) {
  const nlohmann::ordered_json json = parse_json(text, where);
  const JsonCursor document(json, where);
  check_schema(document);
  const JsonCursor parameters = document.member("parameters");
  const Axes axes = read_axes(parameters);
  const Part crossed{parameters.where(), read_entries(document, "exclude"), " (or exclude it)"};
  const std::vector<Axes> included = read_entries(document, "include");
  std::vector<Configuration> cells = cells_of(cross(axes, {}), crossed);
  Assignment single;
  for (const Axis& axis : axes)
    if (axis.values.size() == 1) single.emplace(axis.parameter, &axis.values.front());
  for (const Axes& entry : included) {
    const Part part{document.member("include").where(), {}, ""};
    const std::vector<Configuration> more = cells_of(cross(entry, single), part);
    require_taken(entry, more);
    cells.insert(cells.end(), more.begin(), more.end());
  }
  if (cells.empty()) throw InputError(document.where(), "no cell is left; everything is excluded");
  require_taken(axes, cells);
  return distinct(cells);
}

std::vector<std::string> varying_parameters(const std::vector<Configuration>& configurations) {
  std::vector<std::string> names;
  for (const Parameter& parameter : all_parameters()) {
    std::set<Value> values;
    for (const Configuration& c : configurations)
      if (const Value value = value_of(c, parameter.name()); !is_nothing(value))
        values.insert(value);
    if (values.size() > 1) names.emplace_back(parameter.name());
  }
  return names;
}

}  // namespace lanescope
