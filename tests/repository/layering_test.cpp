// SPDX-License-Identifier: MIT
// How the house is divided: which folder may include which, who may name a kind of work or a paper,
// and who may print.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

#include "tests/repository/source_files.h"

namespace lanescope {
namespace {

using test::for_each_source;
using test::includes_of;

/// The part of a path up to and without the n-th slash, or the empty string.
std::string folder_of(const std::string& path, int depth) {
  std::size_t end = 0;
  for (int i = 0; i < depth; ++i) {
    end = path.find('/', i == 0 ? 0 : end + 1);
    if (end == path.npos) return {};
  }
  return path.substr(0, end);
}

bool is_in(const std::string& path, std::string_view folder) { return path.starts_with(folder); }

/// Whether a file may include another (the plan of the house, docs/architecture.md).
bool may_include(const std::string& path, const std::string& other) {
  const std::string room = folder_of(path, 2) + '/';
  const bool in_room = path.find('/', path.find('/') + 1) != path.npos;
  if (is_in(path, "simulator/")) return is_in(other, "simulator/");
  if (is_in(path, "workloads/")) {
    if (is_in(other, "simulator/base/") || other == "workloads/work.h") return true;
    if (is_in(other, "workloads/geometry/")) return in_room;
    return in_room && is_in(other, room);
  }
  if (is_in(path, "kernels/")) {
    if (is_in(other, "simulator/") || other == "workloads/work.h") return true;
    if (folder_of(other, 1) == "kernels" && folder_of(other, 2).empty()) return true;
    const std::string kind = room.substr(std::string("kernels/").size());
    return in_room && (is_in(other, room) || is_in(other, "workloads/" + kind) ||
                       is_in(other, "workloads/geometry/"));
  }
  return true;
}

TEST(Layering, IncludesRunOneWay) {
  for (const char* folder : {"simulator", "workloads", "kernels"}) {
    for_each_source(folder, [](const std::string& path, const std::string& text) {
      for (const std::string& include : includes_of(text)) {
        if (include.find('/') == std::string::npos) continue;  // generated, beside the file
        EXPECT_TRUE(may_include(path, include)) << path << " includes " << include;
      }
    });
  }
}

TEST(Layering, NothingIncludesTheAnalysis) {
  for (const char* folder : {"simulator", "workloads", "kernels"}) {
    for_each_source(folder, [](const std::string& path, const std::string& text) {
      for (const std::string& include : includes_of(text))
        EXPECT_FALSE(include.starts_with("analysis/")) << path << " includes " << include;
    });
  }
}

TEST(Layering, IncludesWithinAnalysisRunOneWay) {
  // Each folder may include itself and those before it.
  const std::vector<std::string> order = {"base",     "configuration", "report",     "tables",
                                          "formats",  "pictures",      "experiment", "sweep",
                                          "machines", "trace",         "annotation", "comparison",
                                          "html",     "studies",       "cli"};
  for_each_source("analysis", [&](const std::string& path, const std::string& text) {
    const auto room_of = [](const std::string& name) {
      const std::size_t begin = std::string("analysis/").size();
      return name.substr(begin, name.find('/', begin) - begin);
    };
    const auto rank = [&](const std::string& room) {
      return std::find(order.begin(), order.end(), room) - order.begin();
    };
    const auto own = rank(room_of(path));
    EXPECT_LT(own, static_cast<std::ptrdiff_t>(order.size())) << path << " is in no known folder";
    for (const std::string& include : includes_of(text))
      if (include.starts_with("analysis/") && include.find('/', 9) != std::string::npos) {
        EXPECT_LE(rank(room_of(include)), own) << path << " includes " << include;
      }
  });
}

/// Kinds of work are known to their two rooms and to studies; the rest finds them by their
/// registries.
TEST(Layering, OnlyTheirRoomsKnowKinds) {
  static const std::regex kNamesAKind(
      R"(workloads/(?!work\.h|geometry/)\w+/|kernels/\w+/|[Mm]icropolygon|[Ll]ockstep|LOCKSTEP|[Rr]epack|REPACK|[Rr]astmp|[Vv]oxel)");
  for (const char* folder : {"simulator", "workloads", "kernels", "analysis"}) {
    for_each_source(folder, [](const std::string& path, const std::string& text) {
      const std::string room = folder_of(path, 2);
      const bool is_kind = is_in(path, "workloads/") || is_in(path, "kernels/");
      if (is_in(path, "analysis/studies/") || (is_kind && !room.empty())) return;
      std::smatch found;
      EXPECT_FALSE(std::regex_search(text, found, kNamesAKind)) << path << " names " << found.str();
    });
  }
}

TEST(Layering, OnlyStudiesKnowPapers) {
  static const std::regex kNamesAPaper("[Tt]hesis|[Ll]uong");
  for_each_source("analysis", [](const std::string& path, const std::string& text) {
    if (is_in(path, "analysis/studies/")) return;
    std::smatch found;
    EXPECT_FALSE(std::regex_search(text, found, kNamesAPaper)) << path << " names " << found.str();
  });
}

/// The types that a header defines at namespace scope, with their namespaces.
std::vector<std::string> types_of(const std::string& text) {
  static const std::regex kNamespace(R"(^(?:inline )?namespace ([\w:]+)(?: LANESCOPE_HOST)? \{)");
  static const std::regex kType(R"(^(?:struct|class|enum class|enum) (\w+)[^;]*\{)");
  std::vector<std::string> types;
  std::string scope, before;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); before = line) {
    std::smatch found;
    if (std::regex_search(line, found, kNamespace)) scope += "::" + found[1].str();
    if (line.starts_with("}  // ")) scope = scope.substr(0, scope.rfind("::"));
    const bool is_template = before.starts_with("template") || before.starts_with("requires");
    if (!is_template && std::regex_search(line, found, kType))
      types.push_back(scope + "::" + found[1].str());
  }
  return types;
}

/// Two types of one name would be taken for each other by the linker, without a word.
TEST(Layering, NoTwoHeadersDefineATypeOfOneName) {
  std::map<std::string, std::string> headers;
  for (const char* folder : {"simulator", "workloads", "kernels", "analysis"})
    for_each_source(folder, [&](const std::string& path, const std::string& text) {
      if (!path.ends_with(".h")) return;
      for (const std::string& type : types_of(text)) {
        const auto [other, is_new] = headers.emplace(type, path);
        EXPECT_TRUE(is_new) << path << " and " << other->second << " define " << type;
      }
    });
  EXPECT_GT(headers.size(), 150u);
}

/// Tests run beside each other, so a file of a fixed name would be shared.
TEST(Layering, TestsWriteIntoDirectoriesOfTheirOwn) {
  static const std::regex kNamesSharedPlace(R"(TempDir\(|temp_directory_path|"/tmp)");
  for_each_source("tests", [](const std::string& path, const std::string& text) {
    if (path == "tests/scratch_directory.h" || path == "tests/repository/layering_test.cpp") return;
    EXPECT_FALSE(std::regex_search(text, kNamesSharedPlace)) << path;
  });
}

TEST(Layering, OnlyTheCommandLinePrintsOrExits) {
  static const std::regex kPrints(
      R"(std::cout|std::cerr|std::exit|[^a-z_]exit\(|fmt::print\(|[^a-z_:]printf\(|std::puts)");
  for (const char* folder : {"simulator", "workloads", "kernels", "analysis"}) {
    for_each_source(folder, [&](const std::string& path, const std::string& text) {
      if (is_in(path, "analysis/cli/")) return;
      EXPECT_FALSE(std::regex_search(text, kPrints)) << path;
    });
  }
}

}  // namespace
}  // namespace lanescope
