// SPDX-License-Identifier: MIT
// What this program is and where it runs.
#pragma once

#include <string>
#include <string_view>

namespace lanescope {

/// `0.1.0`.
std::string_view program_version();
/// The compiler that built the program.
std::string_view compiler();
/// The model of the processor, or `unknown`.
std::string processor_model();

}  // namespace lanescope
