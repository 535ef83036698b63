// SPDX-License-Identifier: MIT
#include "tests/workloads/voxels/vox_probe.h"

#include <algorithm>
#include <stdexcept>

#include "simulator/base/error.h"
#include "workloads/voxels/vox_reader.h"

namespace lanescope::test {
namespace {

/// Larger worlds are not looked through, which would take long.
constexpr std::int64_t kLooked = 1 << 20;

void require(bool condition, const char* promise) {
  if (!condition) throw std::logic_error(promise);
}

void check_cropped(const World& world) {
  const Cube size = world.size();
  if (std::int64_t{size.x} * size.y * size.z > kLooked) return;
  Cube low = size, high{-1, -1, -1};
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        if (!world.filled({x, y, z})) continue;
        low = {std::min(low.x, x), std::min(low.y, y), std::min(low.z, z)};
        high = {std::max(high.x, x), std::max(high.y, y), std::max(high.z, z)};
      }
  require(low == Cube{} && high == Cube{size.x - 1, size.y - 1, size.z - 1},
          "a world is as large as its cubes reach");
}

}  // namespace

bool probe_vox(std::string_view bytes) {
  try {
    const World world = parse_vox("w.vox", bytes);
    require(world.margin == 0, "every corner of a file's world is looked from");
    check_cropped(world);
    return true;
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    require(message.starts_with("w.vox:") && message.find('\n') == message.npos,
            "a message is a line that names the file");
    return false;
  }
}

}  // namespace lanescope::test
