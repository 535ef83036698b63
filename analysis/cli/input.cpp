// SPDX-License-Identifier: MIT
#include "analysis/cli/input.h"

#include "analysis/base/printable.h"
#include "analysis/report/report_json.h"

namespace lanescope {

std::vector<NamedReport> read_reports(const std::vector<std::string>& files) {
  std::vector<NamedReport> reports;
  for (const std::string& file : files) reports.push_back({printable(file), read_report(file)});
  return reports;
}

}  // namespace lanescope
