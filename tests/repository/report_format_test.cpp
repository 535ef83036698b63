// SPDX-License-Identifier: MIT
// docs/report-format.md explains every key of the report but the parameters of single kernels,
// which are declared with the kernels and are explained where those are listed.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "analysis/report/report_json.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// Adds the names of the properties of all objects that a schema describes.
void collect_properties(const Json& schema, std::set<std::string>& names) {
  if (!schema.is_structured()) return;
  if (schema.is_object() && schema.contains("properties"))
    for (const auto& [name, property] : schema["properties"].items()) names.insert(name);
  for (const auto& [key, value] : schema.items()) collect_properties(value, names);
}

TEST(Documents, TheReportFormatExplainsEveryKey) {
  std::ifstream in(LANESCOPE_SOURCE_DIR "/docs/report-format.md");
  std::ostringstream text;
  text << in.rdbuf();
  std::set<std::string> names;
  Json schema = Json::parse(report_json_schema());
  schema["$defs"]["parameters"].erase("allOf");
  collect_properties(schema, names);
  EXPECT_GT(names.size(), 60u);
  for (const std::string& name : names)
    EXPECT_NE(text.str().find(fmt::format("| `{}` | ", name)), std::string::npos) << name;
}

}  // namespace
}  // namespace lanescope
