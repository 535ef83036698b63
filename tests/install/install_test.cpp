// SPDX-License-Identifier: MIT
// The installed package from outside: the prefix is moved after the installation, programs are
// built against it and run. Nothing of the build tree is used but by the installation.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/base/files.h"
#include "tests/cli/program.h"
#include "tests/scratch_directory.h"

namespace lanescope::testing {
namespace {

const std::filesystem::path kSources = LANESCOPE_SOURCE_DIR;

/// An installation, in a prefix that has been moved.
class Installation : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = new ScratchDirectory;
    expect_success(shell(fmt::format("cmake --install '{}' --prefix '{}'", LANESCOPE_BUILD_DIR,
                                     *scratch_ / "first")));
    std::filesystem::rename(*scratch_ / "first", *scratch_ / "moved");
  }
  static void TearDownTestSuite() { delete scratch_; }

  static void expect_success(const Outcome& outcome) {
    EXPECT_EQ(outcome.status, 0) << outcome.output << outcome.errors;
  }

  /// Copies a project into the scratch directory and configures it.
  static Outcome configure(const std::filesystem::path& project, const std::string& name) {
    const std::string sources = *scratch_ / name;
    std::filesystem::copy(project, sources);
    return shell(
        fmt::format("cmake -S '{}' -B '{}/build' -G Ninja -DCMAKE_BUILD_TYPE=Release "
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DCMAKE_CXX_COMPILER='{}' "
                    "-DCMAKE_PREFIX_PATH='{}'",
                    sources, sources, LANESCOPE_COMPILER, *scratch_ / "moved"));
  }
  static Outcome build(const std::string& name, const std::string& arguments = "") {
    return shell(fmt::format("cmake --build '{}/build' {}", *scratch_ / name, arguments));
  }

  /// Runs a program of a project.
  static Outcome run(const std::string& program, const std::string& arguments) {
    return shell(fmt::format("'{}' {}", *scratch_ / program, arguments), scratch_->path());
  }
  static void expect_in(const std::string& text, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << words << " is not in\n" << text;
  }

  static inline ScratchDirectory* scratch_ = nullptr;
};

/// The program of examples/own_program built against it; made once.
class OwnProgram : public Installation {
 protected:
  static void SetUpTestSuite() {
    Installation::SetUpTestSuite();
    built_ = configure(kSources / "examples" / "own_program", "own").status == 0 &&
             build("own").status == 0;
  }
  void SetUp() override { ASSERT_TRUE(built_); }

  static std::string own(const std::string& arguments) {
    const Outcome outcome = run("own/build/own_program", arguments);
    EXPECT_EQ(outcome.status, 0) << arguments << "\n" << outcome.errors;
    return outcome.output;
  }

  static inline bool built_ = false;
};

/// A counter of a run of a report.
std::uint64_t counter_of(const nlohmann::json& run, std::string_view name) {
  for (const auto& counter : run["counters"])
    if (counter["name"] == name) return counter["value"];
  return 0;
}

/// What a run of a report has of an instruction, over all stages.
std::uint64_t sum_of(const nlohmann::json& run, std::string_view mnemonic, const char* what) {
  std::uint64_t sum = 0;
  for (const auto& stage : run["stages"])
    for (const auto& instruction : stage["instructions"])
      if (instruction["mnemonic"] == mnemonic) sum += instruction[what].get<std::uint64_t>();
  return sum;
}

constexpr const char* kSmall = "--scene hill --resolution 48x30 --micropolygon triangle ";

TEST_F(OwnProgram, OwnThingsAreListedBesideOurs) {
  const std::string kernels = own("list kernels");
  for (const char* name : {"rastmp", "lockstep", "repack", "across_image", "one_at_a_time"})
    expect_in(kernels, fmt::format("{} ", name));
  expect_in(kernels, "takes micropolygons; W = 1 to 16\n");
  expect_in(own("list scenes"), "hill ");
  expect_in(own("list instructions"), "edge_function ");
  EXPECT_EQ(own("list commands"), lanescope_program("list commands").output);
  expect_in(run("moved/bin/lanescope", "--version").output, "lanescope ");
}

/// At one lane a test of a triangle is three edge functions, no more and no less.
TEST_F(OwnProgram, AnOwnInstructionIsCounted) {
  const auto report = nlohmann::json::parse(
      own(std::string("run --kernel one_at_a_time --width 1,16 --json - ") + kSmall));
  for (const auto& run : report["runs"]) {
    const std::uint64_t tests = counter_of(run, "tests");
    EXPECT_GT(tests, 1000u);
    EXPECT_EQ(sum_of(run, "edge_function", "active"), 3 * tests);
    if (run["parameters"]["width_lanes"] == 1)
      EXPECT_EQ(sum_of(run, "edge_function", "issued"), 3 * tests);
  }
  const auto& dictionary = report["instructions"];
  EXPECT_TRUE(std::any_of(dictionary.begin(), dictionary.end(),
                          [](const auto& entry) { return entry["mnemonic"] == "edge_function"; }));
}

TEST_F(OwnProgram, EveryCommandKnowsAnOwnKernel) {
  const std::string kernel = std::string("--kernel one_at_a_time --width 16 ") + kSmall;
  const std::string lines = own("annotate --source " + kernel);
  expect_in(lines, "one_at_a_time.h");
  expect_in(lines, "values.e[k] = edge_function(on, x[k], y[k], x[kNext], y[kNext]);");
  expect_in(lines, "kernels/micropolygons/stages.h");
  expect_in(own("trace --batches 0:4 --listing - " + kernel), "edge_function");
  own("run --observe-every 1 --json r.json " + kernel);
  expect_in(own("csv r.json --rows instructions"), "edge_function");
  own("report r.json -o r.html");
  EXPECT_TRUE(std::filesystem::file_size(*scratch_ / "r.html") > 100000u);
}

TEST_F(OwnProgram, AnOwnKernelIsCheckedAgainstTheReference) {
  expect_in(own("check --kernel one_at_a_time --pieces 1 --width 1,7,16 --scene hill,teapot "
                "--resolution 96x60"),
            "one_at_a_time agrees with rastmp");
}

TEST_F(Installation, WrongInstructionsAreNamed) {
  expect_success(configure(kSources / "tests" / "install" / "wrong", "wrong"));
  const Outcome compiled = build("wrong", "--target wrong_structs");
  EXPECT_NE(compiled.status, 0);
  for (const char* complaint :
       {"Nameless: needs `static constexpr", "Shouting: needs `static constexpr",
        "Bodiless: needs one body", "Wide: lane() takes what lanes hold",
        "Undecided: holds() takes two"})
    expect_in(compiled.output, complaint);
  EXPECT_EQ(compiled.output.find("Right: "), std::string::npos) << compiled.output;

  expect_success(build("wrong", "--target same_mnemonic"));
  const Outcome started = run("wrong/build/same_mnemonic", "list kernels");
  EXPECT_EQ(started.status, 2);
  EXPECT_EQ(started.errors,
            "lanescope: instructions: 'add' is the mnemonic of one of the instruction set (r[i] = "
            "a[i] + b[i]) and of struct SaturatingAdd (r[i] = min(a[i] + b[i], 1)); give one of "
            "them another\n");
}

TEST_F(Installation, MistakesOfTheProjectAreNamed) {
  const std::pair<std::string, std::string> mistakes[] = {
      {"find_package(lanescope REQUIRED COMPONENTS kernels gpu)",
       "there is no component 'gpu' (one of: simulator, workloads, kernels, analysis, cli)"},
      {"find_package(lanescope REQUIRED)\nlanescope_program(p KERNELS missing.h)",
       "lanescope_program(p KERNELS): there is no file"},
      {"find_package(lanescope REQUIRED)\nlanescope_program(p INSTRUCTIONS CMakeLists.txt)",
       "lanescope_program(p INSTRUCTIONS CMakeLists.txt): no instruction is declared there"},
      {"find_package(lanescope REQUIRED)\nlanescope_program(p SCENES CMakeLists.txt)",
       "lanescope_program(p SCENES CMakeLists.txt): no scene is defined there"},
      {"find_package(lanescope REQUIRED)\nlanescope_program(p LANES 12)",
       "lanescope_program(p LANES 12): use some of 8, 16, 32, 64"},
      {"find_package(lanescope REQUIRED)\nlanescope_program(p my_kernel.h)",
       "lanescope_program(p): 'my_kernel.h' follows none of"},
  };
  int number = 0;
  for (const auto& [text, complaint] : mistakes) {
    const ScratchDirectory project;
    write_file(project / "CMakeLists.txt",
               "cmake_minimum_required(VERSION 3.25)\nproject(p CXX)\n" + text + "\n");
    const Outcome outcome = configure(project.path(), fmt::format("mistake{}", number++));
    EXPECT_NE(outcome.status, 0) << text;
    // CMake breaks lines.
    std::string words = outcome.errors;
    std::replace(words.begin(), words.end(), '\n', ' ');
    words.erase(std::unique(words.begin(), words.end(),
                            [](char a, char b) { return a == ' ' && b == ' '; }),
                words.end());
    expect_in(words, complaint);
  }
}

/// The first of the examples, which replaces a step of REPACK. At one lane each box is a store of
/// four records, and each hit one.
TEST_F(Installation, AnExampleIsBuiltAgainstIt) {
  expect_success(configure(kSources / "examples" / "compress_store", "example"));
  expect_success(build("example"));
  const std::string program = "example/build/compress_store";
  const std::string small = "--kernel repack_compress --scene teapot --resolution 96x60 ";
  const Outcome checked = run(program, "check --pieces 1 --width 1,16,31 " + small);
  expect_success(checked);
  expect_in(checked.output, "repack_compress agrees with rastmp");
  const auto report = nlohmann::json::parse(run(program, "run --width 1 --json - " + small).output);
  const auto& only = report["runs"][0];
  EXPECT_GT(counter_of(only, "hits"), 1000u);
  EXPECT_EQ(sum_of(only, "compress_store", "active"),
            4 * (counter_of(only, "micropolygons_rasterized") -
                 counter_of(only, "micropolygons_off_screen")) +
                counter_of(only, "hits"));
}

TEST_F(Installation, EachHeaderIsComplete) {
  expect_success(configure(kSources / "tests" / "install" / "headers", "headers"));
  expect_success(build("headers"));
}

#if defined(__x86_64__) && defined(__SSE4_2__)
TEST_F(Installation, AProgramForAnotherHostDoesNotLink) {
  const ScratchDirectory project;
  for (const auto& file : {kSources / "tests" / "install" / "hosts" / "CMakeLists.txt",
                           kSources / "examples" / "new_instruction.cpp"})
    std::filesystem::copy(file, project.path());
  expect_success(configure(project.path(), "hosts"));
  expect_success(build("hosts", "--target same_host"));
  expect_in(run("hosts/build/same_host", "").output, "with cross: ");
  const Outcome other = build("hosts", "--target other_host");
  EXPECT_NE(other.status, 0);
  expect_in(other.output, "undefined reference to `lanescope::host::generic::require_same_host()'");
}
#endif

}  // namespace
}  // namespace lanescope::testing
