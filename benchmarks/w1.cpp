// SPDX-License-Identifier: MIT
#include "benchmarks/w1.h"

#include <algorithm>

#include "simulator/base/random.h"

namespace lanescope::w1 {

const float kSampleX[kSamples] = {0.4f, 1.6f, 2.3f, 3.7f, 0.2f, 1.1f, 2.8f, 3.5f,
                                  0.9f, 1.5f, 2.6f, 3.1f, 0.3f, 1.8f, 2.4f, 3.9f};
const float kSampleY[kSamples] = {0.7f, 0.2f, 0.5f, 0.9f, 1.3f, 1.6f, 1.1f, 1.8f,
                                  2.2f, 2.9f, 2.5f, 2.7f, 3.6f, 3.3f, 3.8f, 3.1f};

Triangles make_triangles(int count) {
  Triangles t;
  for (int k = 0; k < 3; ++k) {
    t.x[k].resize(static_cast<std::size_t>(count));
    t.y[k].resize(static_cast<std::size_t>(count));
  }
  t.tests.resize(static_cast<std::size_t>(count));
  t.hits.resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    auto random = [&, salt = std::uint64_t{0}]() mutable {
      return unit_float(mix64(i * 16 + ++salt));
    };
    const float x = 1 + random(), y = 1 + random();
    const float edge = 1.6f + 0.8f * random();
    t.x[0][i] = x - edge / 2;
    t.y[0][i] = y - edge / 2;
    t.x[1][i] = x + edge / 2 + 0.4f * random();
    t.y[1][i] = y - edge / 2 + 0.6f * random();
    t.x[2][i] = x - 0.5f + random();
    t.y[2][i] = y + edge / 2 + 0.4f * random();
    t.tests[i] = 4 + static_cast<std::int32_t>(random() * 9);
  }
  return t;
}

#ifdef LANESCOPE_AVX512
template <int W>
void run_by_hand(Triangles& t) {
  constexpr int N = W / 16;
  const __m512 zero = _mm512_setzero_ps();
  for (int first = 0; first < t.size(); first += W) {
    __m512 x[3][N], y[3][N];
    __m512i tests[N], hits[N], most = _mm512_setzero_si512();
    for (int c = 0; c < N; ++c) {
      for (int k = 0; k < 3; ++k) {
        x[k][c] = _mm512_loadu_ps(&t.x[k][static_cast<std::size_t>(first + 16 * c)]);
        y[k][c] = _mm512_loadu_ps(&t.y[k][static_cast<std::size_t>(first + 16 * c)]);
      }
      tests[c] = _mm512_loadu_si512(&t.tests[static_cast<std::size_t>(first + 16 * c)]);
      hits[c] = _mm512_setzero_si512();
      most = _mm512_max_epi32(most, tests[c]);
    }
    const int iterations = _mm512_reduce_max_epi32(most);
    for (int s = 0; s < iterations; ++s) {
      const __m512 px = _mm512_set1_ps(kSampleX[s]), py = _mm512_set1_ps(kSampleY[s]);
      const __m512i bit = _mm512_set1_epi32(1 << s), index = _mm512_set1_epi32(s);
      for (int c = 0; c < N; ++c) {
        const __mmask16 active = _mm512_cmpgt_epi32_mask(tests[c], index);
        const __m512 ax = _mm512_sub_ps(x[0][c], px), ay = _mm512_sub_ps(y[0][c], py);
        const __m512 bx = _mm512_sub_ps(x[1][c], px), by = _mm512_sub_ps(y[1][c], py);
        const __m512 cx = _mm512_sub_ps(x[2][c], px), cy = _mm512_sub_ps(y[2][c], py);
        const __m512 e0 = _mm512_sub_ps(_mm512_mul_ps(ax, by), _mm512_mul_ps(ay, bx));
        const __m512 e1 = _mm512_sub_ps(_mm512_mul_ps(bx, cy), _mm512_mul_ps(by, cx));
        const __m512 e2 = _mm512_sub_ps(_mm512_mul_ps(cx, ay), _mm512_mul_ps(cy, ax));
        const __m512 least = _mm512_min_ps(_mm512_min_ps(e0, e1), e2);
        const __mmask16 inside = _mm512_mask_cmp_ps_mask(active, least, zero, _CMP_GT_OQ);
        hits[c] = _mm512_mask_or_epi32(hits[c], inside, hits[c], bit);
      }
    }
    for (int c = 0; c < N; ++c)
      _mm512_storeu_si512(&t.hits[static_cast<std::size_t>(first + 16 * c)], hits[c]);
  }
}
template void run_by_hand<16>(Triangles&);
template void run_by_hand<32>(Triangles&);
template void run_by_hand<64>(Triangles&);
#endif

template <int W, Mode M>
Counts run_on_machine(Triangles& t) {
  using namespace isa;
  using Vm = Machine<W, M>;
  const auto size = static_cast<std::size_t>(t.size());
  const auto floats = [&](const std::vector<float>& v) {
    return read_only(v.data(), size, "corners");
  };
  const Memory<const float> xs[3] = {floats(t.x[0]), floats(t.x[1]), floats(t.x[2])};
  const Memory<const float> ys[3] = {floats(t.y[0]), floats(t.y[1]), floats(t.y[2])};
  const auto tests = read_only(t.tests.data(), size, "tests");
  const Memory<std::uint32_t> output{t.hits.data(), size, "hits", nullptr};
  Vm vm(W, 1);
  {
    auto loading = vm.site(0);
    auto testing = vm.site(0);
    auto storing = vm.site(0);
    for (int first = 0; first < t.size(); first += W) {
      typename Vm::Float x[3], y[3];
      typename Vm::Int left;
      typename Vm::Uint hits;
      int iterations;
      Mask<W> active = Mask<W>::all();
      {
        auto on = loading.on(active);
        host::unroll<3>([&](auto k) LANESCOPE_INLINE_LAMBDA {
          x[k] = load(on, xs[k], first);
          y[k] = load(on, ys[k], first);
        });
        left = load(on, tests, first);
        hits = broadcast(on, 0u);
        iterations = hmax(on, left);
      }
      for (int s = 0; s < iterations; ++s) {
        auto on = testing.on(active);
        typename Vm::Float rx[3], ry[3];
        host::unroll<3>([&](auto k) LANESCOPE_INLINE_LAMBDA {
          rx[k] = sub(on, x[k], kSampleX[s]);
          ry[k] = sub(on, y[k], kSampleY[s]);
        });
        const auto edge = [&](int a, int b) LANESCOPE_INLINE_LAMBDA {
          return sub(on, mul(on, rx[a], ry[b]), mul(on, ry[a], rx[b]));
        };
        const auto least = min(on, min(on, edge(0, 1), edge(1, 2)), edge(2, 0));
        const auto inside = cmp_gt(on, least, 0.0f);
        hits = select(on, inside, bit_or(on, hits, std::uint32_t{1} << s), hits);
        active = cmp_gt(on, left, s + 1);
      }
      auto on = storing.on(Mask<W>::all());
      store(on, output, first, hits);
    }
  }
  return vm.counts();
}
template Counts run_on_machine<16, Mode::kCounting>(Triangles&);
template Counts run_on_machine<32, Mode::kCounting>(Triangles&);
template Counts run_on_machine<64, Mode::kCounting>(Triangles&);
template Counts run_on_machine<16, Mode::kUncounted>(Triangles&);
template Counts run_on_machine<32, Mode::kUncounted>(Triangles&);
template Counts run_on_machine<64, Mode::kUncounted>(Triangles&);

}  // namespace lanescope::w1
