// SPDX-License-Identifier: MIT
// `lanescope check`: whether kernels agree with the scalar reference, with an exit status for
// scripts.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/narration.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"
#include "analysis/experiment/agreement.h"

namespace lanescope {
namespace {

constexpr int kAgree = 0;
constexpr int kDiffer = 1;
constexpr int kMostPieces = 1 << 20;

struct Given {
  ExperimentArguments experiment;
  std::string pieces = "8";
};

/// What was found of a kernel.
struct Finding {
  std::size_t runs = 0;
  std::size_t pieces = 0;  ///< Of the run with the fewest.
  std::string difference;  ///< The first one, and where it is; empty if there is none.
};

/// Where it differs, as its options are typed.
std::string place_of(const Configuration& c) {
  std::string place =
      fmt::format("--scene {} --width {} --mode {}", c.scene, c.width, name_of(kModes, c.mode));
  if (const Parameter* facet = find_parameter(workload_of(c).facet))
    place += fmt::format(" {} {}", facet->words.option, facet_of(c));
  return place;
}

/// The usual widths, and one less than each: all lanes on, and all but one.
std::vector<Configuration> with_odd_widths(const std::vector<Configuration>& configurations) {
  std::vector<Configuration> all;
  for (const Configuration& configuration : configurations) {
    all.push_back(configuration);
    if (configuration.width == 1) continue;
    all.push_back(configuration);
    --all.back().width;
  }
  return all;
}

void require_oracle(const Workload& workload) {
  if (!oracle_of(workload))
    throw InputError("check", "there is no scalar reference for {}", workload.name);
}

class Check {
 public:
  Check(int pieces, Narration& narration) : pieces_(pieces), narration_(narration) {}

  /// Compares a configuration, unless its kernel has been found to differ.
  void take(const Configuration& configuration) {
    Finding& finding = findings_[configuration.kernel];
    if (!finding.difference.empty()) return;
    if (!agreement_ || !agreement_->is_of(configuration))
      agreement_ = std::make_unique<Agreement>(configuration, pieces_, narration_.listener());
    const std::optional<std::string> difference = agreement_->difference(configuration);
    finding.pieces = finding.runs == 0 ? agreement_->piece_count()
                                       : std::min(finding.pieces, agreement_->piece_count());
    ++finding.runs;
    if (difference)
      finding.difference = fmt::format("{}: {}", place_of(configuration), *difference);
  }

  /// A line for each kernel, in the order of the program's.
  std::string text() const {
    std::string lines;
    for (const Kernel* kernel : kernels()) {
      const auto found = findings_.find(kernel->name);
      if (found == findings_.end()) continue;
      const Finding& finding = found->second;
      const std::string_view oracle = oracle_of(*kernel->workload)->name;
      if (finding.difference.empty())
        lines += fmt::format("{} agrees with {} in {} runs of at least {} pieces\n", kernel->name,
                             oracle, finding.runs, finding.pieces);
      else
        lines += fmt::format("{} differs from {}: {}\n", kernel->name, oracle, finding.difference);
    }
    return lines;
  }

  bool all_agree() const {
    return std::all_of(findings_.begin(), findings_.end(),
                       [](const auto& entry) { return entry.second.difference.empty(); });
  }

 private:
  int pieces_;
  Narration& narration_;
  std::unique_ptr<Agreement> agreement_;
  std::map<std::string, Finding, std::less<>> findings_;
};

int run(const CommandOptions& command, const Given& given) {
  std::vector<Configuration> configurations = resolve_configurations(given.experiment);
  require_oracle(workload_of(configurations.front()));
  const std::string width(find_parameter(kWidth)->words.option);
  if (!command.is_given(width)) configurations = with_odd_widths(configurations);
  const int pieces = parse_integer({"--pieces", given.pieces}, 0, kMostPieces);
  std::string text;
  bool all_agree;
  {
    Narration narration(command.name());
    Check check(pieces, narration);
    for (std::size_t i = 0; i < configurations.size(); ++i) {
      narration.update(static_cast<double>(i) / static_cast<double>(configurations.size()),
                       configurations[i].kernel);
      check.take(configurations[i]);
    }
    text = check.text();
    all_agree = check.all_agree();
  }
  print(text);
  return all_agree ? kAgree : kDiffer;
}

/// Every value of the parameters that tables show side by side, and every mode.
void add_defaults(ExperimentArguments& arguments) {
  arguments.defaults["scene"] = {std::string("all")};
  std::vector<std::string_view> names{"mode"};
  for (const Workload* workload : workloads())
    if (!workload->facet.empty()) names.push_back(workload->facet);
  for (const std::string_view name : names) {
    std::vector<Value>& values = arguments.defaults[std::string(name)];
    for (const std::string_view choice : find_parameter(name)->choices)
      values.push_back(std::string(choice));
  }
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  add_defaults(given->experiment);
  given->experiment.left_out = {"observe_every"};
  add_experiment_options(options, given->experiment);
  options.add(
      "Check",
      {"--pieces", "N", "Pieces of work of each scene, at least, spread over it; 0 for all"},
      given->pieces);
  return [&options, given] { return run(options, *given); };
}

}  // namespace

extern const Command c_check{
    "check",
    "Compares kernels with the scalar reference, piece by piece; exit status 0 if they agree, 1 if "
    "one does not, 2 if they cannot be compared",
    "  lanescope check --kernel {kernel} --scene {scene}\n"
    "  lanescope check --kernel {kernel} --scene {scene} --width 1:16 --mode checked --pieces 2",
    declare};

}  // namespace lanescope
