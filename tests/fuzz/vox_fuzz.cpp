// SPDX-License-Identifier: MIT
// Feeds the reader of worlds with whatever libFuzzer thinks of (docs/workloads.md).
#include <cstddef>
#include <cstdint>

#include "tests/workloads/voxels/vox_probe.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lanescope::test::probe_vox({reinterpret_cast<const char*>(data), size});
  return 0;
}
