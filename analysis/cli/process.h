// SPDX-License-Identifier: MIT
// What surrounds the program: its standard streams, and the signals that end it.
#pragma once

#include <string_view>

namespace lanescope {

/// Called first of all. Gives closed standard streams a descriptor that nothing can be written to,
/// so that no file that is opened later takes their place. From now on SIGINT, SIGTERM, SIGHUP,
/// SIGQUIT and SIGXCPU remove the files that are not finished, say what they interrupted, and then
/// end the program as they would have; those that are ignored stay ignored. A closed pipe and a
/// limit on the size of files become errors of the write.
void set_up_process();

/// What an interruption is said to have interrupted: the name of the command, and a sentence about
/// what becomes of its work, which may be empty. Longer texts are cut.
void say_when_interrupted(std::string_view command, std::string_view consequence = {});

/// Ends the program as a closed pipe does, without a word; returns if the program was started with
/// that signal ignored.
void end_by_closed_pipe();

}  // namespace lanescope
