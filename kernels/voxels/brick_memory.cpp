// SPDX-License-Identifier: MIT
#include "kernels/voxels/vector_kernel.h"

namespace lanescope {
namespace {

/// How rows lie in memory: words from one to the next along y and z, and cubes to a place.
struct RowLayout {
  std::int32_t y_words, z_words;
  int scale;
};
constexpr RowLayout kCubes{Brick::row(1, 0), Brick::row(0, 1), 1};
constexpr RowLayout kMegacubes{Brick::mega_row(0, 1, 0) - Brick::mega_row(0, 0, 0),
                               Brick::mega_row(0, 0, 1) - Brick::mega_row(0, 0, 0), kMegaCube};

std::array<std::int32_t, kOctants> octant_starts(const RowLayout& layout) {
  std::array<std::int32_t, kOctants> starts{};
  for (int octant = 0; octant < kOctants; ++octant)
    starts[static_cast<std::size_t>(octant)] =
        (octant & 1 ? Brick::kBackward : Brick::kForward) -
        layout.scale * ((octant & 2 ? layout.y_words : 0) + (octant & 4 ? layout.z_words : 0));
  return starts;
}

std::vector<std::int32_t> row_steps(const RowLayout& layout) {
  std::vector<std::int32_t> steps;
  for (int octant = 0; octant < kOctants; ++octant)
    for (const OctantRow& row : octant_rows())
      steps.push_back(layout.scale * ((octant & 2 ? -row.y : row.y) * layout.y_words +
                                      (octant & 4 ? -row.z : row.z) * layout.z_words));
  return steps;
}

constexpr std::int32_t kRowBits = (1 << kReach) - 1;

std::vector<std::int32_t> bits_beyond_reach() {
  constexpr std::int32_t kSkipped = (1 << kMegaSkipped) - 1;
  std::vector<std::int32_t> bits;
  for (const OctantRow& row : octant_rows())
    bits.push_back(std::max(row.y, row.z) < kMegaSkipped ? kRowBits & ~kSkipped : kRowBits);
  return bits;
}

Level cubes_of(const Brick& brick) {
  static const std::vector<std::int32_t> steps = row_steps(kCubes);
  static const std::vector<std::int32_t> row_bits(kOctantRows, kRowBits);
  Level level{{}, {}, kReach, octant_starts(kCubes), &steps, &row_bits};
  for (const Probe& probe : brick.probes) {
    level.row.push_back(Brick::row(kReach + probe.y, kReach + probe.z));
    level.bit.push_back(probe.x);
  }
  return level;
}

Level megacubes_of(const Brick& brick) {
  static const std::vector<std::int32_t> steps = row_steps(kMegacubes);
  static const std::vector<std::int32_t> row_bits = bits_beyond_reach();
  Level level{{}, {}, kMegaCube - 1, octant_starts(kMegacubes), &steps, &row_bits};
  for (const Probe& probe : brick.probes) {
    level.row.push_back(Brick::mega_row(probe.x % kMegaCube, probe.y, probe.z));
    level.bit.push_back(probe.x / kMegaCube);
  }
  return level;
}

}  // namespace

BrickMemory::BrickMemory(const Brick& b) : brick(&b) {
  levels.push_back(cubes_of(b));
  if (b.has_megacubes()) levels.push_back(megacubes_of(b));
}

Memory<float> harmonics_of(ProbeField& field, const Brick& brick) {
  return {field.data() + kHarmonics * brick.first_probe, kHarmonics * brick.probes.size(),
          "harmonics of probes", nullptr};
}

}  // namespace lanescope
