// SPDX-License-Identifier: MIT
// Words of the program's own in examples: `--kernel {kernel}` becomes the name of one of its
// kernels, so that the examples of any program work.
#pragma once

#include <string>
#include <string_view>

namespace lanescope {

/// The lines with each word in braces replaced, without the lines for which the program has no
/// word:
///   {kernel}  a kernel that issues instructions, of the kind of work that runs if none is named
///   {scene}   a scene of that kind
///   {group}   a word for several of its scenes
///   {facet}   its facet with all values, as an option
///   {file}    a file that is a scene of it
///   {view}    something to see beside the output
///   {study}   a study
std::string with_words(std::string_view lines);

}  // namespace lanescope
