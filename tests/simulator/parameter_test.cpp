// SPDX-License-Identifier: MIT
#include "simulator/base/parameter.h"

#include <gtest/gtest.h>

#include <array>

namespace lanescope {
namespace {

enum class Colour { kRed, kGreen };
constexpr std::array<Choice<Colour>, 2> kColours{
    {{"red", Colour::kRed}, {"green", Colour::kGreen}}};
constexpr std::array<int, 3> kCounts{1, 4, 9};

struct Options {
  bool on = true;
  int size = 7;
  std::uint64_t seed = 1;
  int count = 4;
  float share = 0.5f;
  Colour colour = Colour::kGreen;
  std::string word = "some";
  std::optional<int> frame;
};

const Parameters<Options>& parameters() {
  static const Parameters<Options> all{
      {&Options::on, {"on", "--on", kNoUnit, "A switch"}},
      {&Options::size, {"size", "--size", "px", "An integer"}, 1, 10},
      {&Options::seed,
       {"seed", "--seed", kNoUnit, "Any integer"},
       std::uint64_t{0},
       ~std::uint64_t{0}},
      {&Options::count,
       {"count", "--count", kNoUnit, "One of a few"},
       std::span<const int>(kCounts)},
      {&Options::share, {"share", "--share", kNoUnit, "A number"}, 0.0f, 1.0f},
      {&Options::colour, {"colour", "--colour", kNoUnit, "A choice"}, kColours},
      {&Options::word, {"word", "--word", kNoUnit, "A word"}},
      {&Options::frame, {"frame", "--frame", kNoUnit, "As the scene has it"}, 0, 99},
  };
  return all;
}

const Parameter& parameter(std::string_view name) {
  for (const auto& binding : parameters())
    if (binding.parameter().name() == name) return binding.parameter();
  throw std::out_of_range(std::string(name));
}

TEST(Parameter, HasTheDefaultOfItsMember) {
  EXPECT_EQ(parameter("on").fallback, Value(true));
  EXPECT_EQ(parameter("size").fallback, Value(std::uint64_t{7}));
  EXPECT_EQ(parameter("share").fallback, Value(0.5f));
  EXPECT_EQ(parameter("colour").fallback, Value(std::string("green")));
  EXPECT_EQ(parameter("frame").fallback, Value());
}

TEST(Parameter, AllowsItsRangeAndNothingElse) {
  const auto integer = [](std::uint64_t value) { return Value(value); };
  EXPECT_TRUE(parameter("size").allows(integer(1)));
  EXPECT_TRUE(parameter("size").allows(integer(10)));
  EXPECT_FALSE(parameter("size").allows(integer(0)));
  EXPECT_FALSE(parameter("size").allows(integer(11)));
  EXPECT_FALSE(parameter("size").allows(Value(5.0f)));
  EXPECT_TRUE(parameter("seed").allows(integer(~std::uint64_t{0})));
  EXPECT_TRUE(parameter("count").allows(integer(9)));
  EXPECT_FALSE(parameter("count").allows(integer(5)));
  EXPECT_FALSE(parameter("share").allows(Value(1.5f)));
  EXPECT_FALSE(parameter("share").allows(Value(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_FALSE(parameter("colour").allows(Value(std::string("blue"))));
  EXPECT_FALSE(parameter("on").allows(Value(std::string("on"))));
}

TEST(Parameter, MayHaveNoValueOnlyWhereItHasNoDefault) {
  EXPECT_TRUE(parameter("frame").allows(Value()));
  EXPECT_FALSE(parameter("size").allows(Value()));
}

TEST(Parameter, SaysWhatItAllows) {
  EXPECT_EQ(parameter("on").allowed_values(), "on or off");
  EXPECT_EQ(parameter("size").allowed_values(), "an integer from 1 to 10");
  EXPECT_EQ(parameter("count").allowed_values(), "1, 4 or 9");
  EXPECT_EQ(parameter("share").allowed_values(), "a number from 0 to 1");
  EXPECT_EQ(parameter("colour").allowed_values(), "red or green");
}

TEST(Parameters, AreDecodedIntoTheMembers) {
  Arguments arguments;
  arguments.set("on", false);
  arguments.set("size", std::uint64_t{3});
  arguments.set("colour", std::string("red"));
  arguments.set("frame", std::uint64_t{12});
  arguments.set("of another table", 1.0f);
  const Options options = decoded(parameters(), arguments);
  EXPECT_FALSE(options.on);
  EXPECT_EQ(options.size, 3);
  EXPECT_EQ(options.share, 0.5f);
  EXPECT_EQ(options.colour, Colour::kRed);
  EXPECT_EQ(options.frame, 12);
}

TEST(Parameters, ComeBackAsTheyWereEncoded) {
  Options options;
  options.seed = ~std::uint64_t{0};
  options.word = "other";
  options.frame = 0;
  const Options again = decoded(parameters(), encoded(parameters(), options));
  EXPECT_EQ(again.seed, options.seed);
  EXPECT_EQ(again.word, options.word);
  EXPECT_EQ(again.frame, options.frame);
}

TEST(Arguments, KeepTheirOrderAndAreChangedInPlace) {
  Arguments arguments;
  arguments.set("b", true);
  arguments.set("a", 1.0f);
  arguments.set("b", false);
  ASSERT_EQ(arguments.all().size(), 2u);
  EXPECT_EQ(arguments.all()[0].name, "b");
  EXPECT_EQ(arguments["b"], Value(false));
  EXPECT_EQ(arguments["c"], Value());
  EXPECT_FALSE(arguments.contains("c"));
}

TEST(ParameterError, NamesTheOptionAndTheParameter) {
  const ParameterError error(parameter("size").words, "12 is too large");
  EXPECT_STREQ(error.what(), "--size: 12 is too large");
  EXPECT_EQ(error.parameter(), "size");
  EXPECT_EQ(error.message(), "12 is too large");
}

}  // namespace
}  // namespace lanescope
