// SPDX-License-Identifier: MIT
// `lanescope schema`: the JSON Schemas of what the program reads, for validators.
#include <array>
#include <memory>

#include "analysis/cli/options.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"
#include "analysis/machines/description.h"
#include "analysis/report/report_json.h"

namespace lanescope {
namespace {

using Schema = std::string (*)();

constexpr std::array<Choice<Schema>, 2> kSchemas{
    {{"report", report_json_schema}, {"machine", machine_json_schema}}};

Action declare(CommandOptions& options) {
  const auto of = std::make_shared<std::string>("report");
  options.add_argument({"of", "OF", list_or(names_of(kSchemas))}, *of);
  return [of] { print(parse_choice({"schema", *of}, kSchemas)()); };
}

}  // namespace

extern const Command c_schema{"schema", "Prints the JSON Schema of reports, or of machines",
                              "  lanescope schema\n"
                              "  lanescope schema machine > machine.schema.json",
                              declare};

}  // namespace lanescope
