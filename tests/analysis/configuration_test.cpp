// SPDX-License-Identifier: MIT
// What holds of every declared parameter, whoever declares it.
#include "analysis/configuration/configuration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "analysis/configuration/configuration_json.h"

namespace lanescope {
namespace {

Arguments arguments(std::initializer_list<std::pair<const char*, Value>> values) {
  Arguments given;
  for (const auto& [name, value] : values) given.set(name, value);
  return given;
}

/// Values just outside the range of a parameter.
std::vector<Value> outside(const Parameter& p) {
  std::vector<Value> values;
  if (p.kind == Parameter::Kind::kInteger && p.allowed.empty()) {
    if (p.low > 0) values.emplace_back(p.low - 1);
    if (p.high < ~std::uint64_t{0}) values.emplace_back(p.high + 1);
  }
  if (p.kind == Parameter::Kind::kNumber) {
    values.emplace_back(std::nextafter(p.least, -INFINITY));
    values.emplace_back(std::nextafter(p.most, INFINITY));
  }
  if (p.kind == Parameter::Kind::kChoice) values.emplace_back(std::string("no such word"));
  return values;
}

TEST(DeclaredParameters, HaveDefaultsThatTheyAllow) {
  for (const Kernel* kernel : kernels())
    for (const Parameter& p : parameters_of(*kernel))
      EXPECT_TRUE(p.allows(p.fallback)) << kernel->name << ": " << p.name();
}

TEST(DeclaredParameters, AreNamedOnceForAKernelAndItsKind) {
  for (const Kernel* kernel : kernels()) {
    std::set<std::string_view> names;
    for (const Parameter& p : parameters_of(*kernel))
      EXPECT_TRUE(names.insert(p.name()).second) << kernel->name << ": " << p.name();
  }
}

TEST(DeclaredParameters, OfOneNameAreOneEverywhere) {
  for (const Kernel* kernel : kernels())
    for (const Parameter& p : parameters_of(*kernel)) {
      const Parameter& known = *find_parameter(p.name());
      EXPECT_EQ(p.words.option, known.words.option) << p.name();
      EXPECT_EQ(p.words.help, known.words.help) << p.name();
      EXPECT_EQ(p.allowed_values(), known.allowed_values()) << p.name();
    }
}

TEST(DeclaredParameters, AreExplained) {
  for (const Parameter& p : all_parameters()) {
    EXPECT_TRUE(p.words.option.starts_with("--")) << p.name();
    ASSERT_FALSE(p.words.help.empty()) << p.name();
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(p.words.help.front())) ||
                std::isdigit(static_cast<unsigned char>(p.words.help.front())))
        << p.words.help;
    EXPECT_NE(p.words.help.back(), '.') << p.words.help;
  }
}

TEST(DeclaredParameters, RefuseTheFirstValueOutsideTheirRangeAndSayTheRange) {
  std::size_t refused = 0;
  for (const Kernel* kernel : kernels())
    for (const Parameter& p : parameters_of(*kernel))
      for (const Value& value : outside(p)) {
        Arguments given = arguments({{"kernel", std::string(kernel->name)}});
        given.set(p.name(), value);
        try {
          resolved(given);
          ADD_FAILURE() << p.name() << " took " << value_text(value);
        } catch (const ParameterError& error) {
          ++refused;
          EXPECT_EQ(error.parameter(), p.name());
          EXPECT_NE(error.message().find(p.allowed_values()), std::string::npos) << error.what();
        }
      }
  EXPECT_GT(refused, 10u);
}

TEST(Resolved, HasEveryParameterOfItsKernelAndNoOther) {
  for (const Kernel* kernel : kernels()) {
    const Configuration c = resolved(arguments({{"kernel", std::string(kernel->name)},
                                                {"width_lanes", std::uint64_t{1}},
                                                {"not a parameter of any", true}}));
    std::vector<std::string> names, expected;
    for (const auto& argument : all_values(c).all()) names.push_back(argument.name);
    for (const Parameter& p : parameters_of(*kernel)) expected.emplace_back(p.name());
    EXPECT_EQ(names, expected) << kernel->name;
  }
}

TEST(Resolved, ComesBackFromItsJsonForm) {
  for (const Kernel* kernel : kernels()) {
    const Configuration c = resolved(
        arguments({{"kernel", std::string(kernel->name)}, {"width_lanes", std::uint64_t{1}}}));
    const auto json = configuration_json(c);
    EXPECT_EQ(read_configuration(JsonCursor(json, "test")), c) << kernel->name;
  }
}

TEST(Resolved, RefusesKernelsWidthsAndScenesThatThereAreNot) {
  const auto message = [](const Arguments& given) -> std::string {
    try {
      resolved(given);
    } catch (const ParameterError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message(arguments({{"kernel", std::string("repak")}})).substr(0, 36),
            "--kernel: 'repak' is not a kernel; u");
  EXPECT_NE(message(arguments({{"kernel", std::string("repak")}})).find("did you mean 'repack'?"),
            std::string::npos);
  EXPECT_EQ(
      message(arguments({{"kernel", std::string("rastmp")}, {"width_lanes", std::uint64_t{8}}})),
      "--width: 8 is not a width of rastmp; it is scalar, use 1");
  EXPECT_NE(message(arguments({{"scene", std::string("teapt")}})).find("did you mean 'teapot'?"),
            std::string::npos);
}

TEST(TakersOf, NamesThoseWhoTakeAParameter) {
  EXPECT_EQ(takers_of("kernel"), "every kernel");
  EXPECT_EQ(takers_of("stream_load_threshold"), "repack");
}

TEST(SameSource, IgnoresWhatOnlyTheKernelTakes) {
  const Configuration one = resolved(arguments({{"kernel", std::string("lockstep")}}));
  const Configuration other = resolved(arguments({{"kernel", std::string("repack")},
                                                  {"width_lanes", std::uint64_t{5}},
                                                  {"stream_load_threshold", 0.5f},
                                                  {"cull_backfaces", false}}));
  EXPECT_TRUE(same_source(one, other));
  const Configuration smaller =
      resolved(arguments({{"kernel", std::string("repack")}, {"width_px", std::uint64_t{100}}}));
  EXPECT_FALSE(same_source(one, smaller));
}

}  // namespace
}  // namespace lanescope
