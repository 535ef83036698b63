// SPDX-License-Identifier: MIT
// What this program is and where it runs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lanescope {

/// `0.1.0`.
std::string_view program_version();
/// The commit of its sources, with `+` if they had changes; empty if they were not in a repository.
std::string_view program_commit();
/// The compiler that built the program.
std::string_view compiler();
/// The model of the processor, or `unknown`.
std::string processor_model();
/// Largest resident set that the process has had.
std::uint64_t peak_memory_bytes();

}  // namespace lanescope
