// SPDX-License-Identifier: MIT
#include "analysis/sweep/sweep.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "analysis/base/files.h"
#include "analysis/base/json_cursor.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/report/report_json.h"
#include "tests/analysis/configured.h"
#include "tests/analysis/test_kind.h"
#include "tests/scratch_directory.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

/// Cells of `groups` sources with `members` each.
std::vector<Configuration> cells(unsigned groups, unsigned members) {
  std::vector<Configuration> all;
  for (unsigned member = 0; member < members; ++member)
    for (unsigned group = 0; group < groups; ++group)
      all.push_back(testing::configured({{"kernel", "lockstep"},
                                         {"width_lanes", 8u},
                                         {"width_px", 48u},
                                         {"height_px", 30u},
                                         {"grid_limit", group + 1},
                                         {"seed", member}}));
  return all;
}

Configuration numbers(const char* kernel, unsigned piece_size = 10) {
  return testing::configured({{"kernel", kernel}, {"piece_size", piece_size}});
}

std::vector<std::string> ids(const std::vector<Configuration>& all) {
  std::vector<std::string> texts;
  for (const Configuration& c : all) texts.push_back(cell_id(c));
  return texts;
}

TEST(Shards, AreDisjointAndTogetherAllCells) {
  for (const auto& [groups, members] : {std::pair(1u, 7u), {3, 4}, {5, 2}, {4, 1}}) {
    const std::vector<Configuration> all = cells(groups, members);
    for (int count = 1; count <= 9; ++count) {
      std::multiset<std::string> united;
      for (int index = 1; index <= count; ++index)
        for (const std::string& id : ids(shard_of(all, index, count))) united.insert(id);
      const std::vector<std::string> expected = ids(all);
      EXPECT_EQ(united, std::multiset<std::string>(expected.begin(), expected.end()))
          << groups << " groups of " << members << " in " << count;
    }
  }
}

TEST(Shards, KeepGroupsTogether) {
  const std::vector<Configuration> all = cells(4, 3);
  for (int index = 1; index <= 2; ++index) {
    const std::vector<Configuration> shard = shard_of(all, index, 2);
    EXPECT_EQ(shard.size(), 6u);
    EXPECT_EQ(group_by_source(shard, {}).size(), 2u);
  }
}

TEST(Shards, CutGroupsThatAreTooFew) {
  const std::vector<Configuration> all = cells(1, 7);
  EXPECT_EQ(shard_of(all, 1, 3).size(), 2u);
  EXPECT_EQ(shard_of(all, 2, 3).size(), 2u);
  EXPECT_EQ(shard_of(all, 3, 3).size(), 3u);
}

TEST(Groups, StayWithinTheirLimits) {
  const std::vector<Configuration> all = cells(2, 5);
  EXPECT_EQ(group_by_source(all, {}),
            (std::vector<std::vector<std::size_t>>{{0, 2, 4, 6, 8}, {1, 3, 5, 7, 9}}));
  GroupLimits limits;
  limits.members = 2;
  EXPECT_EQ(group_by_source(all, limits).size(), 6u);
  limits = {};
  limits.output_bytes = std::uint64_t{48} * 30 * 4 * 8 * 3;  // Three frames of 4 samples a pixel.
  EXPECT_EQ(group_by_source(all, limits),
            (std::vector<std::vector<std::size_t>>{{0, 2, 4}, {1, 3, 5}, {6, 8}, {7, 9}}));
  limits.output_bytes = 1;
  EXPECT_EQ(group_by_source(all, limits).size(), 10u);
}

TEST(Groups, AreOfOneSource) {
  const std::vector<Configuration> all{numbers("sum"), numbers("running_sum"), numbers("sum", 9),
                                       cells(1, 1).front(), numbers("running_sum", 9)};
  EXPECT_EQ(group_by_source(all, {}), (std::vector<std::vector<std::size_t>>{{0, 1}, {2, 4}, {3}}));
  for (const Configuration& a : all)
    for (const Configuration& b : all)
      EXPECT_EQ(group_by_source({a, b}, {}).size(), same_source(a, b) ? 1u : 2u);
}

/// An output of 12 numbers of 8 bytes; what is observed of a sequential kernel needs a second one.
TEST(Groups, HaveRoomForOutputsOfWhatIsObserved) {
  GroupLimits limits;
  limits.output_bytes = 3 * 12 * 8;
  Configuration unobserved = numbers("running_sum");
  unobserved.observe_every = 0;
  EXPECT_EQ(group_by_source({numbers("sum"), numbers("running_sum")}, limits).size(), 1u);
  EXPECT_EQ(group_by_source({numbers("running_sum"), numbers("running_sum")}, limits).size(), 2u);
  EXPECT_EQ(group_by_source({numbers("running_sum"), unobserved}, limits).size(), 1u);
}

TEST(Groups, MakeTheirPiecesForEachSequentialWorker) {
  const Configuration any = numbers("sum");
  const Configuration sequential = numbers("running_sum");
  EXPECT_EQ(source_passes({any, any}, 4), 1);
  EXPECT_EQ(source_passes({sequential}, 4), 1);
  EXPECT_EQ(source_passes({any, sequential, sequential}, 4), 3);
  EXPECT_EQ(source_passes({any, sequential, sequential}, 1), 2);
}

TEST(CellId, TellsParametersApart) {
  const std::vector<std::string> all = ids(cells(5, 5));
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
  EXPECT_EQ(all.front().find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(all.front().size(), 16u);
}

TEST(CellId, IsOfTheContentOfAFile) {
  const testing::ScratchDirectory scratch;
  const std::string path = scratch / "cell.numbers";
  const Configuration cell = testing::configured({{"kernel", "sum"}, {"scene", path}});
  const std::string absent = cell_id(cell);
  write_file(path, "1 2 3");
  const std::string first = cell_id(cell);
  EXPECT_NE(first, absent);
  EXPECT_EQ(cell_id(cell), first);
  write_file(path, "1 2 3 4");
  EXPECT_NE(cell_id(cell), first);
  write_file(path, "1 2 3");
  EXPECT_EQ(cell_id(cell), first);
  fs::remove(path);
  EXPECT_EQ(cell_id(cell), absent);
}

class SweepInDirectory : public ::testing::Test {
 protected:
  SweepInDirectory() : path_(scratch_.path()), directory_(path_) { directory_.open(); }

  const testing::ScratchDirectory scratch_;
  const fs::path path_;
  SweepDirectory directory_;
};

TEST_F(SweepInDirectory, SharesSourcesOnlyAsFarAsAllowed) {
  const std::vector<Configuration> all = cells(2, 3);
  SweepOptions options;
  const SweepSummary shared = run_sweep(all, directory_, options);
  EXPECT_EQ(shared.done, 6u);
  EXPECT_EQ(shared.groups, 2u);
  EXPECT_NEAR(shared.source_unshared_ms, 3.0 * shared.source_ms, 1e-9 * shared.source_ms);
  fs::remove_all(directory_.cells_path());
  directory_.open();
  options.group_limits.members = 1;
  const SweepSummary alone = run_sweep(all, directory_, options);
  EXPECT_EQ(alone.groups, 6u);
  EXPECT_DOUBLE_EQ(alone.source_unshared_ms, alone.source_ms);
}

TEST_F(SweepInDirectory, TellsItsProgress) {
  std::vector<SweepProgress> told;
  SweepOptions options;
  options.group_limits.members = 2;
  options.progress = [&](const SweepProgress& p) { told.push_back(p); };
  run_sweep(cells(2, 3), directory_, options);
  ASSERT_GE(told.size(), 4u);
  for (std::size_t i = 1; i < told.size(); ++i) EXPECT_GE(told[i].fraction, told[i - 1].fraction);
  for (const SweepProgress& p : told) EXPECT_EQ(p.done + p.failed + p.left, 6u);
  EXPECT_EQ(told.back().done, 6u);
  EXPECT_DOUBLE_EQ(told.back().fraction, 1.0);
}

TEST_F(SweepInDirectory, RedoesCellsThatDoNotReadAsTheirReport) {
  const std::vector<Configuration> all = cells(1, 4);
  run_sweep(all, directory_, {});
  const auto path = [&](int cell) {
    return fmt::format("{}/{}.json", directory_.cells_path(),
                       cell_id(all[static_cast<std::size_t>(cell)]));
  };
  const std::string whole = read_file(path(0));
  write_file(path(0), whole.substr(0, whole.size() / 2));
  write_file(path(1), whole);  // The report of another cell.
  fs::remove(path(2));
  const SweepSummary again = run_sweep(all, directory_, {});
  EXPECT_EQ(again.done, 3u);
  EXPECT_EQ(again.skipped, 1u);
  for (const Configuration& cell : all) EXPECT_TRUE(directory_.find(cell).has_value());
}

TEST_F(SweepInDirectory, KeepsFailuresAndTriesThemAgain) {
  const std::string mesh = path_ / "later.obj";
  std::vector<Configuration> all = cells(1, 4);
  for (std::size_t i = 2; i < 4; ++i)
    all[i] = testing::configured({{"kernel", "lockstep"},
                                  {"width_lanes", 8u},
                                  {"width_px", 48u},
                                  {"height_px", 30u},
                                  {"scene", mesh},
                                  {"mesh_patches", "linear"},
                                  {"seed", static_cast<unsigned>(i)}});
  const SweepSummary first = run_sweep(all, directory_, {});
  EXPECT_EQ(first.done, 2u);
  EXPECT_EQ(first.failed, 2u);
  EXPECT_EQ(directory_.failure_count(), 2u);
  EXPECT_TRUE(directory_.has_failed(all[2]));
  const std::string file = fmt::format("{}/{}.json", directory_.failed_path(), cell_id(all[3]));
  const auto failure = parse_json(read_file(file), file);
  EXPECT_EQ(failure["parameters"], configuration_json(all[3]));
  EXPECT_EQ(failure["error"], mesh + ": cannot be opened: No such file or directory");
  write_file(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const SweepSummary second = run_sweep(all, directory_, {});
  EXPECT_EQ(second.done, 2u);
  EXPECT_EQ(second.skipped, 2u);
  EXPECT_EQ(directory_.failure_count(), 0u);
}

/// A cell of a file that has changed is another cell.
TEST_F(SweepInDirectory, RedoesCellsWhoseSceneHasChanged) {
  const std::string path = path_ / "scene.numbers";
  const std::vector<Configuration> all{testing::configured({{"kernel", "sum"}, {"scene", path}}),
                                       numbers("sum")};
  write_file(path, "1 2 3");
  EXPECT_EQ(run_sweep(all, directory_, {}).done, 2u);
  EXPECT_EQ(run_sweep(all, directory_, {}).skipped, 2u);
  write_file(path, "1 2 3 4");
  const SweepSummary again = run_sweep(all, directory_, {});
  EXPECT_EQ(again.done, 1u);
  EXPECT_EQ(again.skipped, 1u);
  const auto report = directory_.find(all.front());
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->runs.front().counter("numbers"), 4u);
}

/// A kernel that rejects one member must not take the others of its group with it.
TEST_F(SweepInDirectory, OnlyTheGuiltyCellOfAGroupFails) {
  std::vector<Configuration> all;
  for (const unsigned refused : {1u, 0u, 3u})  // All numbers are even, and 0 is among them.
    all.push_back(
        testing::configured({{"kernel", "sum"}, {"scene", "rising"}, {"refused", refused}}));
  const SweepSummary summary = run_sweep(all, directory_, {});
  EXPECT_EQ(summary.done, 2u);
  EXPECT_EQ(summary.failed, 1u);
  EXPECT_TRUE(directory_.has_failed(all[1]));
  EXPECT_EQ(summary.groups, 2u);
}

TEST_F(SweepInDirectory, EstimatesFromFinishedCellsOrABriefRun) {
  std::vector<Configuration> left = cells(2, 1);
  const auto brief = estimate_sweep({}, left, {});
  ASSERT_TRUE(brief.has_value());
  EXPECT_FALSE(brief->from_finished_cells);
  EXPECT_GT(brief->seconds, 0.0);
  Report done;
  done.runs.resize(2);
  done.runs[0].configuration = done.runs[1].configuration = left[0];
  done.timing.wall_ms = 3000.0;  // For two cells on four threads.
  done.timing.threads = 4;
  SweepOptions options;
  options.threads = 2;
  set_value(left[1], "samples_per_pixel", std::uint64_t{16});  // Four times the work.
  const auto known = estimate_sweep({done}, left, options);
  ASSERT_TRUE(known.has_value());
  EXPECT_TRUE(known->from_finished_cells);
  EXPECT_DOUBLE_EQ(known->seconds, 3.0 * 4 / 2 * 5 / 2);
}

}  // namespace
}  // namespace lanescope
