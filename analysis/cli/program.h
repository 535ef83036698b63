// SPDX-License-Identifier: MIT
#pragma once

namespace lanescope {

/// The whole program: finds the command, runs it, and turns what goes wrong into one line on
/// standard error and an exit status. What there is to run comes from the program's registries.
int run_program(int argc, char** argv);

}  // namespace lanescope
