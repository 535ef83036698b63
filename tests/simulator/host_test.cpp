// SPDX-License-Identifier: MIT
// What has a layout of the host's has the host's name: see simulator/host.h.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <typeinfo>

#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

#define LANESCOPE_TEXT_OF(name) #name
#define LANESCOPE_TEXT(name) LANESCOPE_TEXT_OF(name)

/// The mangled name of T, in which the length of each part stands before it.
template <class T>
bool names_the_host() {
  const std::string_view host = LANESCOPE_TEXT(LANESCOPE_HOST);
  const std::string part = std::to_string(host.size()) + std::string(host);
  return std::string_view(typeid(T).name()).find(part) != std::string_view::npos;
}

TEST(Host, IsPartOfTheNamesOfWhatDependsOnIt) {
  EXPECT_TRUE(names_the_host<Mask<16>>());
  EXPECT_TRUE((names_the_host<Vec<float, 16>>()));
  EXPECT_TRUE((names_the_host<Site<16, Mode::kCounting>>()));
  EXPECT_TRUE((names_the_host<Block<16, Mode::kCounting>>()));
  EXPECT_TRUE((names_the_host<Machine<16, Mode::kUncounted>>()));
  EXPECT_TRUE(names_the_host<SlowMachine<16>>());
  EXPECT_TRUE((names_the_host<CheckedVec<float, 16>>()));
}

TEST(Host, MasksKeepTheirBitsInEveryForm) {
  const auto check = []<int L>() {
    for (int n = 0; n <= L + 1; ++n) {
      const auto first = Mask<L>::first_n(n);
      EXPECT_EQ(first.bits(), low_bits(n < L ? n : L));
      EXPECT_EQ((~first).bits(), low_bits(L) & ~low_bits(n < L ? n : L));
      EXPECT_EQ(first.count(), n < L ? n : L);
      EXPECT_EQ(first.any(), n > 0);
      EXPECT_EQ(Mask<L>::of_chunks([&](auto c) { return first.chunk(c); }).bits(), first.bits());
    }
    const std::uint64_t pattern = 0x9e3779b97f4a7c15u;
    EXPECT_EQ(Mask<L>::from_bits(pattern).bits(), pattern & low_bits(L));
    EXPECT_EQ(Mask<L>::all().bits(), low_bits(L));
    EXPECT_FALSE(Mask<L>::none().any());
  };
  check.template operator()<8>();
  check.template operator()<16>();
  check.template operator()<32>();
  check.template operator()<64>();
}

}  // namespace
}  // namespace lanescope
