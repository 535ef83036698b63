// SPDX-License-Identifier: MIT
// A table of analysis/tables as an HTML table.
#pragma once

#include <string>

#include "analysis/tables/table.h"

namespace lanescope {

/// A <table> with its title as caption, a paper's numbers and the differences beside ours where
/// there are any, and the notes below it.
std::string table_html(const TableData& data);

}  // namespace lanescope
