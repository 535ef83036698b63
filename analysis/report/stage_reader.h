// SPDX-License-Identifier: MIT
// Reads the stages of a run, and the lines of source that issued them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "analysis/base/json_cursor.h"
#include "analysis/report/report.h"
#include "simulator/instruction.h"

namespace lanescope {

/// What the instructions of a report are charged, by mnemonic.
using Charges = std::map<std::string, Charge, std::less<>>;

/// Reads the stages of a run at that width. Throws InputError if their counts do not fit together
/// or an instruction is not among `charges`.
std::vector<StageRecord> read_stages(const JsonCursor& list, int width, const Charges& charges);

/// Reads what was issued at lines of source. Throws InputError if a stage is not among `stages` or
/// its lines together issued more than it did.
std::vector<SourceLineRecord> read_source_lines(const JsonCursor& list,
                                                const std::vector<StageRecord>& stages);

}  // namespace lanescope
