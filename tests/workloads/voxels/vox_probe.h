// SPDX-License-Identifier: MIT
// What must hold of any world that could be read, whatever the bytes.
#pragma once

#include <string_view>

namespace lanescope::test {

/// Reads bytes as a MagicaVoxel file. Returns false if they are refused with an InputError; throws
/// std::logic_error if what comes out is not as vox_reader.h promises.
bool probe_vox(std::string_view bytes);

}  // namespace lanescope::test
