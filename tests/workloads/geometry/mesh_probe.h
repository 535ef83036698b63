// SPDX-License-Identifier: MIT
// What must hold of any mesh that could be read, whatever the bytes.
#pragma once

#include <string_view>

namespace lanescope::test {

/// Reads a text as an OBJ file and makes patches of it in every way. Returns false if it is refused
/// with an InputError; throws std::logic_error if what comes out is not as mesh.h promises.
bool probe_mesh(std::string_view text);

}  // namespace lanescope::test
