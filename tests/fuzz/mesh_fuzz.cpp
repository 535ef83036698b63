// SPDX-License-Identifier: MIT
// Feeds the reader of meshes with whatever libFuzzer thinks of (docs/workloads.md).
#include <cstddef>
#include <cstdint>

#include "tests/workloads/geometry/mesh_probe.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lanescope::test::probe_mesh({reinterpret_cast<const char*>(data), size});
  return 0;
}
