// SPDX-License-Identifier: MIT
#include "analysis/report/run_order.h"

#include <algorithm>

namespace lanescope {
namespace {

/// The place of a name in a list, at its end if it is not there.
template <class Names>
Rank place_among(const Names& names, std::string_view name) {
  return static_cast<long double>(std::find(names.begin(), names.end(), name) - names.begin());
}

Rank rank_of(const Value& value) {
  return std::visit(
      [](const auto& one) -> Rank {
        if constexpr (std::is_same_v<decltype(one), const std::uint64_t&> ||
                      std::is_same_v<decltype(one), const float&>)
          return static_cast<long double>(one);
        else
          return one;
      },
      value);
}

const Workload* known_workload(std::string_view name) {
  const auto found = std::find_if(workloads().begin(), workloads().end(),
                                  [&](const Workload* workload) { return workload->name == name; });
  return found == workloads().end() ? nullptr : *found;
}

std::vector<std::string> parameter_names(const Workload& workload) {
  std::vector<std::string> names;
  for (const Parameter& parameter : workload.parameters) names.emplace_back(parameter.name());
  return names;
}

/// What this program knows of the parameters of a run.
std::vector<Parameter> known_parameters(const Configuration& configuration,
                                        const Workload* workload) {
  if (const Kernel* kernel = known_kernel(configuration.kernel)) return parameters_of(*kernel);
  std::vector<Parameter> all = joined(run_parameters());
  if (workload) all.insert(all.end(), workload->parameters.begin(), workload->parameters.end());
  return all;
}

/// Collects the parts of the place of a run.
class Place {
 public:
  Place(const Configuration& configuration, const Workload* workload)
      : configuration_(configuration), parameters_(known_parameters(configuration, workload)) {}

  void add_name(const std::string& name, const std::vector<std::string>& list) {
    ranks_.push_back(place_among(list, name));
    ranks_.emplace_back(name);
  }

  /// Adds the value of a parameter; words of a known one are in the order of its choices.
  void add_value(std::string_view name) {
    const Value value = value_of(configuration_, name);
    const auto known = std::find_if(parameters_.begin(), parameters_.end(),
                                    [&](const Parameter& p) { return p.name() == name; });
    const auto* const word = std::get_if<std::string>(&value);
    const bool is_choice =
        word && known != parameters_.end() && known->kind == Parameter::Kind::kChoice;
    ranks_.push_back(is_choice ? place_among(known->choices, *word) : rank_of(value));
  }

  std::vector<Rank> take() { return std::move(ranks_); }

 private:
  const Configuration& configuration_;
  std::vector<Parameter> parameters_;
  std::vector<Rank> ranks_;
};

}  // namespace

std::vector<Rank> place_of(const RunRecord& run) {
  const Configuration& c = run.configuration;
  const Workload* const workload = known_workload(run.workload);
  const auto of_work = workload ? parameter_names(*workload) : std::vector<std::string>();
  const std::string facet(workload ? workload->facet : "");
  const auto is_of_work = [&](const std::string& name) {
    return std::find(of_work.begin(), of_work.end(), name) != of_work.end();
  };

  Place place(c, workload);
  place.add_name(run.workload, names_of(workloads()));
  place.add_name(c.scene, workload ? names_of(workload->scenes) : std::vector<std::string>());
  for (const std::string& name : of_work)
    if (name != facet) place.add_value(name);
  place.add_value("mode");
  place.add_value("observe_every");
  place.add_value(facet);
  place.add_name(c.kernel, names_of(kernels()));
  for (const auto& [name, value] : c.arguments.all())
    if (!is_of_work(name)) place.add_value(name);
  place.add_value("width_lanes");
  return place.take();
}

}  // namespace lanescope
