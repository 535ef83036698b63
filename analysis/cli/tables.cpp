// SPDX-License-Identifier: MIT
// `lanescope tables`: a short name for the first study of the program.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "analysis/cli/study_command.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

Action declare(CommandOptions& options) {
  if (studies().empty()) return [] { throw InputError("tables", "this program has no study"); };
  const Study& study = *studies().front();
  options.app().description(fmt::format("Short for `lanescope study {}`", study.name));
  return declare_study(options, study);
}

}  // namespace

extern const Command c_tables{
    "tables", "Short for the first study",
    "  lanescope tables --out out\n"
    "  lanescope tables --from out/report.json --format latex --per-scene\n"
    "  lanescope tables --from out/report.json --format markdown",
    declare};

}  // namespace lanescope
