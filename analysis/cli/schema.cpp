// SPDX-License-Identifier: MIT
// `lanescope schema`: the JSON Schema of reports, for validators.
#include "analysis/cli/options.h"
#include "analysis/cli/output.h"
#include "analysis/report/report_json.h"

namespace lanescope {
namespace {

Action declare(CommandOptions&) {
  return [] { print(report_json_schema()); };
}

}  // namespace

extern const Command c_schema{"schema", "Prints the JSON Schema of reports, for validators",
                              "  lanescope schema\n"
                              "  lanescope schema > report.schema.json",
                              declare};

}  // namespace lanescope
