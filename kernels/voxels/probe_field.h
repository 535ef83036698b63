// SPDX-License-Identifier: MIT
// What the programs write: for each probe the sky that it sees, as spherical harmonics.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "kernels/output.h"
#include "workloads/voxels/world.h"

namespace lanescope {

/// Real spherical harmonics of order 0 and 1, in this order: sqrt(1 / 4 pi), and sqrt(3 / 4 pi)
/// times x, y and z.
inline constexpr int kHarmonics = 4;
/// The projection of a function of directions that is 1 where the sky is seen, and 0 elsewhere.
using Harmonics = std::array<float, kHarmonics>;

/// The harmonics of each probe, by its number. Different probes may be written at a time.
class ProbeField : public Output {
 public:
  ProbeField(std::shared_ptr<const World> world, std::uint64_t probe_count)
      : world_(std::move(world)), probes_(probe_count) {}

  void write(std::uint64_t probe, const Harmonics& harmonics) { probes_[probe] = harmonics; }

  /// The harmonics of all probes, one after the other.
  float* data() { return probes_.empty() ? nullptr : probes_.front().data(); }

  const World& world() const { return *world_; }
  const std::vector<Harmonics>& probes() const { return probes_; }

  std::uint64_t hash() const override;
  /// The world in its final light.
  std::optional<Raster> picture() const override;
  bool reopen(const Arguments& arguments, const Source& source) override;

 private:
  std::shared_ptr<const World> world_;
  std::vector<Harmonics> probes_;
};

/// Kernel::open of all that write probes. The source is a VoxelSource.
std::unique_ptr<Output> open_probe_field(const Arguments& arguments, const Source& source);
/// Kernel::output_bytes; of a file, of which the size is not known, that of a large world.
std::uint64_t probe_field_bytes(const Arguments& arguments);

}  // namespace lanescope
