// SPDX-License-Identifier: MIT
#include "simulator/mask_sums.h"

#include <algorithm>
#include <cstring>

#include "simulator/host_mask.h"

namespace lanescope {
namespace {

#if defined(LANESCOPE_AVX512) && defined(__AVX512VBMI__) && defined(__AVX512BITALG__) && \
    defined(__AVX512VPOPCNTDQ__) && defined(__GFNI__)

// Masks are taken 64 bytes at a time: eight words of a group at a time, transposed to one byte for
// each lane, of which the number of bits is how many of the eight have the lane on.

template <class Word>
__m512i numbers_of_bits(__m512i words) {
  if constexpr (sizeof(Word) == 2) return _mm512_popcnt_epi16(words);
  if constexpr (sizeof(Word) == 4) return _mm512_popcnt_epi32(words);
  if constexpr (sizeof(Word) == 8) return _mm512_popcnt_epi64(words);
}

/// Words in which bit k is set, for numbers k; none where k is the number of bits.
template <class Word>
__m512i words_of_bit(__m512i numbers) {
  if constexpr (sizeof(Word) == 2) return _mm512_sllv_epi16(_mm512_set1_epi16(1), numbers);
  if constexpr (sizeof(Word) == 4) return _mm512_sllv_epi32(_mm512_set1_epi32(1), numbers);
  if constexpr (sizeof(Word) == 8) return _mm512_sllv_epi64(_mm512_set1_epi64(1), numbers);
}

/// For each bit of a word how many of the eight words of a group have it, as bytes; the groups side
/// by side.
template <class Word>
__m512i count_columns(__m512i words) {
  // Byte j of word i of a group goes to byte i of its j-th run of eight.
  alignas(64) static constexpr auto kFrom = [] {
    std::array<std::uint8_t, 64> from{};
    for (std::size_t to = 0; to < 64; ++to) {
      const std::size_t group = to / 8 / sizeof(Word), j = to / 8 % sizeof(Word), i = to % 8;
      from[to] = static_cast<std::uint8_t>((8 * group + i) * sizeof(Word) + j);
    }
    return from;
  }();
  const __m512i bytes = _mm512_permutexvar_epi8(_mm512_load_si512(kFrom.data()), words);
  const __m512i columns = _mm512_gf2p8affine_epi64_epi8(
      _mm512_set1_epi64(static_cast<long long>(0x8040201008040201u)), bytes, 0);
  return _mm512_popcnt_epi8(columns);
}

/// Adds the groups' counts.
template <class Word>
void add_groups(std::uint64_t* sums, __m512i bytes) {
  constexpr std::size_t kBits = 8 * sizeof(Word);
  std::uint8_t counts[64];
  _mm512_storeu_si512(counts, bytes);
  for (std::size_t group = 0; group < 64; group += kBits)
    for (std::size_t bit = 0; bit < kBits; ++bit) sums[bit] += counts[group + bit];
}

template <class Word>
void add_masks(MaskSums& sums, const Word* begin, const Word* end) {
  constexpr std::size_t kBits = 8 * sizeof(Word);
  __m512i lanes = _mm512_setzero_si512(), histogram = _mm512_setzero_si512();
  for (auto left = static_cast<std::size_t>(end - begin) * sizeof(Word); left != 0;) {
    const std::size_t taken = std::min<std::size_t>(left, 64);
    const __mmask64 present = ~std::uint64_t{0} >> (64 - taken);
    const __m512i words = _mm512_maskz_loadu_epi8(present, begin);
    const __m512i numbers =
        _mm512_maskz_mov_epi8(present, words_of_bit<Word>(numbers_of_bits<Word>(words)));
    lanes = _mm512_add_epi8(lanes, count_columns<Word>(words));
    histogram = _mm512_add_epi8(histogram, count_columns<Word>(numbers));
    begin += taken / sizeof(Word);
    left -= taken;
    sums.histogram[kBits] += taken / sizeof(Word);  // less those that are found below
  }
  sums.histogram[kBits] -= static_cast<std::uint64_t>(
      _mm512_reduce_add_epi64(_mm512_sad_epu8(histogram, _mm512_setzero_si512())));
  add_groups<Word>(sums.lanes.data(), lanes);
  add_groups<Word>(sums.histogram.data(), histogram);
}

#else

/// Transposes 64 words of 64 bits: exchanges blocks of 32, 16 ... 1 bits.
void transpose(std::uint64_t (&words)[64]) {
  std::uint64_t low = 0x00000000ffffffffu;
  for (std::size_t size = 32; size != 0; size /= 2, low ^= low << size) {
    for (std::size_t block = 0; block < 64; block += 2 * size) {
      for (std::size_t i = block; i < block + size; ++i) {
        const std::uint64_t exchanged = (words[i] >> size ^ words[i + size]) & low;
        words[i] ^= exchanged << size;
        words[i + size] ^= exchanged;
      }
    }
  }
}

template <class Word>
void add_masks(MaskSums& sums, const Word* begin, const Word* end) {
  constexpr std::ptrdiff_t kInWord = 8 / sizeof(Word);
  for (const Word* mask = begin; mask != end; ++mask)
    ++sums.histogram[static_cast<std::size_t>(host::count_bits(*mask))];
  while (begin != end) {
    std::uint64_t words[64] = {};
    const std::ptrdiff_t taken = std::min<std::ptrdiff_t>(end - begin, 64 * kInWord);
    std::memcpy(words, begin, static_cast<std::size_t>(taken) * sizeof(Word));
    transpose(words);
    for (std::size_t i = 0; i < 64; ++i)
      sums.lanes[i % (8 * sizeof(Word))] += static_cast<std::uint64_t>(host::count_bits(words[i]));
    begin += taken;
  }
}

#endif

}  // namespace

template <class Word>
void MaskSums::add(const Word* begin, const Word* end) {
  add_masks(*this, begin, end);
}
template void MaskSums::add(const std::uint16_t*, const std::uint16_t*);
template void MaskSums::add(const std::uint32_t*, const std::uint32_t*);
template void MaskSums::add(const std::uint64_t*, const std::uint64_t*);

}  // namespace lanescope
