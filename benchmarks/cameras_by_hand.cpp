// SPDX-License-Identifier: MIT
#include <immintrin.h>

#include <bit>

#include "benchmarks/probe_renderers.h"
#include "kernels/voxels/vector_kernel.h"

namespace lanescope::benchmarks {
namespace {

using V [[gnu::vector_size(4 * kHostLanes)]] = std::int32_t;

V all(std::int32_t value) { return V{} + value; }

V gather(const std::int32_t* base, V index) {
#ifdef __AVX512F__
  return (V)_mm512_i32gather_epi32((__m512i)index, base, 4);
#elif defined(__AVX2__)
  return (V)_mm256_i32gather_epi32(base, (__m256i)index, 4);
#else
  V values;
  for (int i = 0; i < kHostLanes; ++i) values[i] = base[index[i]];
  return values;
#endif
}

std::int32_t or_of(V v) {
  std::int32_t bits = 0;
  for (int i = 0; i < kHostLanes; ++i) bits |= v[i];
  return bits;
}

V popcounts(V v) {
  v -= (v >> 1) & 0x55555555;
  v = (v & 0x33333333) + ((v >> 2) & 0x33333333);
  v = (v + (v >> 4)) & 0x0f0f0f0f;
  return (v * 0x01010101 >> 24) & 0xff;
}

/// W corners at a time; masks are vectors of 0 and -1.
template <int W>
class Cameras {
 public:
  static constexpr int kVectors = W / kHostLanes;

  Cameras(const Brick& brick, SkyProjection projection)
      : brick_(brick),
        memory_(brick),
        level_(memory_.levels[0]),
        rows_(memory_.rows().data),
        samples_(sky_samples(projection)),
        cubes_(cube_images(projection)) {}

  std::uint64_t render(std::vector<Harmonics>& harmonics) {
    for (int first = 0; first < memory_.size(); first += W) render_corners(first, harmonics);
    return sink_.hash();
  }

 private:
  void render_corners(int first, std::vector<Harmonics>& harmonics) {
    V sums[kHarmonics][kVectors] = {};
    load(first);
    for (int octant = 0; octant < kOctants; ++octant) {
      if (!begin(octant)) continue;
      merge_octant(octant);
      take(first, octant);
      samples_.by_counting ? count(octant, sums) : select(octant, sums);
    }
    for (int i = 0; i < W && first + i < memory_.size(); ++i)
      for (std::size_t h = 0; h < kHarmonics; ++h)
        harmonics[brick_.first_probe + static_cast<std::uint64_t>(first + i)][h] =
            static_cast<float>(sums[h][i / kHostLanes][i % kHostLanes]) *
            static_cast<float>(samples_.scale[h]);
  }

  void load(int first) {
    for (int i = 0; i < W; ++i) {
      const bool is_there = first + i < memory_.size();
      const auto at = static_cast<std::size_t>(is_there ? first + i : first);
      valid_[i / kHostLanes][i % kHostLanes] = is_there ? -1 : 0;
      probe_row_[i / kHostLanes][i % kHostLanes] = level_.row[at];
      probe_bit_[i / kHostLanes][i % kHostLanes] = level_.bit[at];
    }
  }

  /// Whether the octant is open for some corner.
  bool begin(int octant) {
    V any = {};
    for (int v = 0; v < kVectors; ++v) {
      row_[v] = probe_row_[v] + level_.start[static_cast<std::size_t>(octant)];
      bit_[v] = octant & 1 ? kReach - probe_bit_[v] : probe_bit_[v];
      open_[v] = valid_[v] & ((gather(rows_, row_[v]) >> bit_[v] & 1) - 1);
      seeing_[v] = open_[v];
      any |= open_[v];
    }
    for (int w = 0; w < samples_.words; ++w)
      for (int v = 0; v < kVectors; ++v) image_[w][v] = V{};
    return or_of(any) != 0;
  }

  void merge_octant(int octant) {
    const std::int32_t* const steps = level_.steps->data() + octant * kOctantRows;
    for (int r = 0; r < kOctantRows; ++r) {
      V cubes[kVectors], anywhere = {};
      for (int v = 0; v < kVectors; ++v) {
        cubes[v] = (gather(rows_, row_[v] + steps[r]) >> bit_[v]) & 0xffff & seeing_[v];
        anywhere |= cubes[v];
      }
      for (auto bits = static_cast<std::uint32_t>(or_of(anywhere)); bits != 0; bits &= bits - 1)
        merge_cubes(cubes, std::countr_zero(bits), r);
      if (std::has_single_bit(static_cast<unsigned>(r + 1)) && r >= 3 && drop_full()) return;
    }
  }

  void merge_cubes(const V* cubes, int i, int row) {
    V filled[kVectors];
    for (int v = 0; v < kVectors; ++v) filled[v] = -(cubes[v] >> i & 1);
    for (const CubeImages::Part& part : cubes_.parts_of(kReach * row + i))
      for (int v = 0; v < kVectors; ++v)
        image_[part.word][v] |= filled[v] & all(static_cast<std::int32_t>(part.bits));
  }

  /// Whether every image is full.
  bool drop_full() {
    V left = {};
    for (int v = 0; v < kVectors; ++v) {
      V common = image_[0][v];
      for (int w = 1; w < samples_.words; ++w) common &= image_[w][v];
      seeing_[v] &= common != all(-1);
      left |= seeing_[v];
    }
    return or_of(left) == 0;
  }

  void take(int first, int octant) {
    for (int i = 0; i < W; ++i)
      if (open_[i / kHostLanes][i % kHostLanes])
        sink_.take(brick_.first_probe + static_cast<std::uint64_t>(first + i), octant,
                   reinterpret_cast<const std::int32_t*>(&image_[0][0]) + i, samples_.words, W);
  }

  void add(int h, int octant, const V* seen, V (&sums)[kHarmonics][kVectors]) const {
    for (int v = 0; v < kVectors; ++v)
      sums[h][v] += is_negative(h, octant) ? -(seen[v] & open_[v]) : seen[v] & open_[v];
  }

  void count(int octant, V (&sums)[kHarmonics][kVectors]) const {
    for (int h = 0; h < kHarmonics; ++h) {
      V seen[kVectors];
      for (int v = 0; v < kVectors; ++v)
        seen[v] = kCountedWords * kWordBits - popcounts(image_[2 * h][v]) -
                  popcounts(image_[2 * h + 1][v]);
      add(h, octant, seen, sums);
    }
  }

  void select(int octant, V (&sums)[kHarmonics][kVectors]) const {
    V seen[kHarmonics][kVectors] = {};
    for (int w = 0; w < samples_.words; ++w)
      for (int b = 0; b < kWordBits; ++b)
        for (int v = 0; v < kVectors; ++v) {
          const V sky = (image_[w][v] >> b & 1) - 1;
          for (std::size_t h = 0; h < kHarmonics; ++h)
            seen[h][v] += sky & samples_.worth[h][static_cast<std::size_t>(w * kWordBits + b)];
        }
    for (int h = 0; h < kHarmonics; ++h) add(h, octant, seen[h], sums);
  }

  const Brick& brick_;
  BrickMemory memory_;
  const Level& level_;
  const std::int32_t* rows_;
  const SkySamples& samples_;
  const CubeImages& cubes_;
  ImageSink<false> sink_;
  V valid_[kVectors], probe_row_[kVectors], probe_bit_[kVectors];
  V row_[kVectors], bit_[kVectors], open_[kVectors], seeing_[kVectors];
  V image_[kMostWords][kVectors];
};

}  // namespace

template <int W>
std::uint64_t cameras_by_hand(const Brick& brick, SkyProjection projection,
                              std::vector<Harmonics>& harmonics) {
  return Cameras<W>(brick, projection).render(harmonics);
}

template std::uint64_t cameras_by_hand<16>(const Brick&, SkyProjection, std::vector<Harmonics>&);
template std::uint64_t cameras_by_hand<32>(const Brick&, SkyProjection, std::vector<Harmonics>&);
template std::uint64_t cameras_by_hand<64>(const Brick&, SkyProjection, std::vector<Harmonics>&);

}  // namespace lanescope::benchmarks
