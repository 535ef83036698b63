// SPDX-License-Identifier: MIT
#include "analysis/sweep/sweep_spec.h"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/base/json_cursor.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/configuration/configuration_limits.h"
#include "kernels/kernel.h"
#include "workloads/micropolygons/scene.h"

namespace lanescope {
namespace {

/// Scenes of this ending are mesh files.
constexpr std::string_view kMeshEnding = ".obj";

/// More cells than this are a mistake, not a plan.
constexpr std::size_t kMaxCells = 100'000;

bool is_mesh_file(std::string_view scene) { return scene.ends_with(kMeshEnding); }

void require_limits(const std::string& name, const JsonCursor& value) {
  const Limits* const limits = find_limits(name);
  if (!limits) return;
  const double number = value.number();
  const bool whole = parameter_json(name, Configuration{}).is_number_integer();
  if (number < limits->low || number > limits->high)
    value.fail(fmt::format("{} from {} to {}", whole ? "an integer" : "a number", limits->low,
                           limits->high));
}

void require_name(const JsonCursor& value, std::string_view kind,
                  const std::vector<std::string>& names, std::string_view otherwise = "") {
  const std::string name = value.string();
  if (std::find(names.begin(), names.end(), name) == names.end())
    value.fail(
        fmt::format("{}; use {}{}{}", kind, list_or(names), otherwise, did_you_mean(name, names)));
}

void require_sample_count(const JsonCursor& value) {
  std::vector<std::string> counts;
  for (const int count : kSampleCounts) counts.push_back(std::to_string(count));
  if (std::find(kSampleCounts.begin(), kSampleCounts.end(), value.integer(1)) ==
      kSampleCounts.end())
    value.fail(fmt::format("a number of samples a pixel; use {}", list_or(counts)));
}

/// Throws InputError unless some run could have the value, whatever its other parameters are.
void require_sound(const std::string& name, const JsonCursor& value) {
  require_limits(name, value);
  if (name == "kernel") require_name(value, "a kernel", names_of(kernels()));
  if (name == "scene" && !is_mesh_file(value.string()))
    require_name(value, "a scene", names_of(scenes()), ", or name a file that ends in .obj");
  if (name == "samples_per_pixel") require_sample_count(value);
  Configuration scratch;
  read_parameter(name, value, scratch);
}

/// A parameter and the values given for it.
struct Axis {
  std::string name;
  std::string where;
  std::vector<JsonCursor> values;
};

/// Reads an object of parameters, each with one value or a list of them.
std::vector<Axis> read_axes(const JsonCursor& object) {
  object.allow_members(parameter_names());
  std::vector<Axis> axes;
  for (const std::string& name : object.member_names()) {
    const JsonCursor member = object.member(name);
    Axis axis{name, member.where(), member.is_array() ? member.items() : std::vector{member}};
    if (axis.values.empty()) member.fail("a value or a list of at least one");
    for (const JsonCursor& value : axis.values) require_sound(name, value);
    axes.push_back(std::move(axis));
  }
  return axes;
}

/// The lists of axes of an optional list of objects.
std::vector<std::vector<Axis>> read_entries(const JsonCursor& document, const std::string& name) {
  if (!document.has_member(name)) return {};
  std::vector<std::vector<Axis>> entries;
  for (const JsonCursor& entry : document.member(name).items()) {
    entries.push_back(read_axes(entry));
    if (entries.back().empty())
      throw InputError(entry.where(), "names no parameter; {} at least one", name);
  }
  return entries;
}

/// One value for each parameter that is named.
using Assignment = std::map<std::string, JsonCursor>;

/// The cross product; the last axis varies fastest.
std::vector<Assignment> cross(const std::vector<Axis>& axes, const Assignment& fixed) {
  std::vector<Assignment> all{fixed};
  for (const Axis& axis : axes) {
    if (all.size() * axis.values.size() > kMaxCells)
      throw InputError(axis.where, "gives more than {} cells", kMaxCells);
    std::vector<Assignment> longer;
    for (const Assignment& assignment : all)
      for (const JsonCursor& value : axis.values) {
        longer.push_back(assignment);
        longer.back().insert_or_assign(axis.name, value);
      }
    all = std::move(longer);
  }
  return all;
}

/// Fills in what the assignment does not name, as the command line does.
Configuration resolve(const Assignment& assignment) {
  Configuration c;
  c.scene = scenes().front()->name;
  for (const auto& [name, value] : assignment) read_parameter(name, value, c);
  if (is_mesh_file(c.scene)) {
    if (!c.is_mesh()) c.mesh_patches = MeshPatches::kPn;
    return c;
  }
  c.mesh_patches.reset();
  if (!assignment.contains("frame")) c.frame = find_scene(c.scene).default_frame;
  return c;
}

/// Checks what the parameters of one cell must be together.
class CellCheck {
 public:
  CellCheck(const JsonCursor& parent, const Assignment& assignment, const Configuration& c)
      : parent_(parent), assignment_(assignment), c_(c) {}

  void run() const {
    check_width();
    check_frame();
    check_size();
  }

 private:
  /// The place of the first of these parameters that the spec names.
  std::string where(std::initializer_list<std::string> names) const {
    for (const std::string& name : names)
      if (const auto found = assignment_.find(name); found != assignment_.end())
        return found->second.where();
    return parent_.where();
  }

  void check_width() const {
    const std::span<const int> widths = find_kernel(c_.kernel).widths;
    if (std::find(widths.begin(), widths.end(), c_.width) != widths.end()) return;
    std::vector<std::string> names;
    for (const int width : widths) names.push_back(std::to_string(width));
    throw InputError(where({"width_lanes", "kernel"}),
                     "{} is not a width of {}; use {}, or exclude it", c_.width, c_.kernel,
                     list_or(names));
  }

  void check_frame() const {
    if (c_.is_mesh()) {
      if (c_.frame != 0)
        throw InputError(where({"frame"}), "a mesh has no frames; leave it out for {}", c_.scene);
      return;
    }
    const SceneDescriptor& scene = find_scene(c_.scene);
    if (c_.frame >= scene.frame_count)
      throw InputError(where({"frame"}), "{} is not a frame of {}; use 0 to {}, or exclude it",
                       c_.frame, scene.name, scene.frame_count - 1);
  }

  /// The grid knows how large a frame may be; here only the place is added.
  void check_size() const {
    try {
      c_.sample_grid();
    } catch (const InputError& error) {
      const std::string text = error.what();
      throw InputError(where({"width_px", "height_px", "samples_per_pixel"}), "{}",
                       text.substr(text.find(": ") + 2));
    }
  }

  const JsonCursor& parent_;
  const Assignment& assignment_;
  const Configuration& c_;
};

/// Whether the configuration has one of the values of each axis.
bool matches(const Configuration& c, const std::vector<Axis>& axes) {
  return std::all_of(axes.begin(), axes.end(), [&](const Axis& axis) {
    return std::any_of(axis.values.begin(), axis.values.end(), [&](const JsonCursor& value) {
      Configuration other = c;
      read_parameter(axis.name, value, other);
      return parameter_json(axis.name, other) == parameter_json(axis.name, c);
    });
  });
}

/// Cells in their order, each once.
class Cells {
 public:
  void add(const JsonCursor& parent, const std::vector<Assignment>& assignments,
           const std::vector<std::vector<Axis>>& excluded) {
    for (const Assignment& assignment : assignments) {
      const Configuration c = resolve(assignment);
      if (std::any_of(excluded.begin(), excluded.end(),
                      [&](const auto& entry) { return matches(c, entry); }))
        continue;
      CellCheck(parent, assignment, c).run();
      if (known_.insert(configuration_json(c).dump()).second) cells_.push_back(c);
    }
  }
  std::vector<Configuration> take() { return std::move(cells_); }

 private:
  std::vector<Configuration> cells_;
  std::set<std::string> known_;
};

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
  const std::vector<Axis> axes = read_axes(parameters);
  const auto excluded = read_entries(document, "exclude");
  const auto included = read_entries(document, "include");
  Cells cells;
  cells.add(parameters, cross(axes, {}), excluded);
  Assignment single;
  for (const Axis& axis : axes)
    if (axis.values.size() == 1) single.emplace(axis.name, axis.values.front());
  for (const std::vector<Axis>& entry : included)
    cells.add(document.member("include"), cross(entry, single), {});
  std::vector<Configuration> all = cells.take();
  if (all.empty()) throw InputError(document.where(), "no cell is left; everything is excluded");
  return all;
}

std::vector<std::string> varying_parameters(const std::vector<Configuration>& configurations) {
  std::vector<std::string> names = parameter_names();
  std::erase_if(names, [&](const std::string& name) {
    return std::all_of(configurations.begin(), configurations.end(), [&](const Configuration& c) {
      return parameter_json(name, c) == parameter_json(name, configurations.front());
    });
  });
  return names;
}

}  // namespace lanescope
