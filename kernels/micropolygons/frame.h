// SPDX-License-Identifier: MIT
// The frame that the rasterizers write: one depth and colour a sample.
#pragma once

#include <atomic>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "kernels/output.h"
#include "simulator/base/random.h"
#include "simulator/host.h"
#include "workloads/micropolygons/sample_grid.h"

namespace lanescope {

/// One 64-bit word a sample: depth in the upper half (the bits of a non-negative float order as
/// integers do), colour in the lower half as 0xAABBGGRR. The nearest fragment has the smallest
/// word, so depth test and write are one minimum, and the frame does not depend on the order of
/// hits: any kernel, width and number of threads gives the same bits, even where depths tie.
class Frame final : public Output {
 public:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};

  /// `background` is shown where nothing covers a sample.
  explicit Frame(const SampleGrid& grid, Colour background = {})
      : grid_(grid),
        background_(background),
        samples_(static_cast<std::size_t>(grid.sample_count()), kEmpty) {}

  const SampleGrid& grid() const { return grid_; }
  const std::vector<std::uint64_t>& samples() const { return samples_; }

  /// Merges a fragment into a sample; safe from any number of threads. A depth that is negative or
  /// not a number is dropped. Requires a valid sample index.
  void merge(std::uint32_t sample, float depth, std::uint32_t colour) {
    if (!(depth >= 0.0f)) return;
    const std::uint64_t fragment =
        (std::uint64_t{std::bit_cast<std::uint32_t>(depth + 0.0f)} << 32) | colour;
    std::atomic_ref<std::uint64_t> word(samples_[sample]);
    std::uint64_t seen = word.load(std::memory_order_relaxed);
    while (fragment < seen &&
           !word.compare_exchange_weak(seen, fragment, std::memory_order_relaxed)) {
    }
  }

  /// A hash of every sample.
  std::uint64_t hash() const override;

  /// Samples that some fragment covers.
  std::uint64_t covered() const;

  /// In the order of kFrameCounters.
  std::vector<std::uint64_t> counters() const override { return {covered()}; }

  /// Averages the samples of each pixel (a box filter). Colours are averaged as light, which is the
  /// square of the displayed value.
  std::optional<Raster> picture() const override;

  /// In the same memory if the frame has as many samples.
  bool reopen(const Arguments& arguments, const Source& source) override;

 private:
  SampleGrid grid_;
  Colour background_;
  std::vector<std::uint64_t> samples_;
};

inline constexpr std::array<CounterInfo, 1> kFrameCounters{
    {{"samples_covered", "samples of the frame that some fragment covers", "samples"}}};

/// Opens a frame: Kernel::open of the rasterizers. The source is a SceneSource.
std::unique_ptr<Output> open_frame(const Arguments& arguments, const Source& source);
/// Samples of the frame that is asked for.
std::uint64_t frame_samples(const Arguments& arguments);
/// Kernel::output_bytes of the rasterizers.
std::uint64_t frame_bytes(const Arguments& arguments);

/// The contribution of one hit to KernelResult::results_hash.
inline std::uint64_t hit_hash(std::uint64_t micropolygon_id, std::uint32_t sample) {
  return mix64(micropolygon_id * 0xd6e8feb86659fd93u ^ sample);
}

/// A colour channel in [0, 1] as 0 ... 255, clamped and rounded; not-a-number is 0. For a scalar or
/// a chunk of lanes.
template <host::Floats V>
LANESCOPE_INLINE auto quantize_channel(V channel) {
  const V clamped =
      host::min(host::max(channel, host::broadcast<V>(0.0f)), host::broadcast<V>(1.0f));
  return host::to_int(clamped * 255.0f + 0.5f);
}

/// Packs a colour as 0xAABBGGRR. For scalars or chunks of lanes.
template <host::Floats V>
LANESCOPE_INLINE auto pack_channels(V red, V green, V blue, V alpha) {
  const auto high = host::wrapping(quantize_channel(alpha)) << 24;
  return host::wrapped<host::Rebind<V, std::int32_t>>(
      high | host::wrapping(quantize_channel(blue)) << 16 |
      host::wrapping(quantize_channel(green)) << 8 | host::wrapping(quantize_channel(red)));
}

}  // namespace lanescope
