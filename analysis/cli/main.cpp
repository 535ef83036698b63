// SPDX-License-Identifier: MIT
#include "analysis/cli/program.h"

int main(int argc, char** argv) { return lanescope::run_program(argc, argv); }
