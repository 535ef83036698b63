// SPDX-License-Identifier: MIT
#include "analysis/sweep/sweep.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "analysis/base/files.h"
#include "analysis/base/json_cursor.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/report/report_json.h"
#include "workloads/micropolygons/scene.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;

/// Cells of `groups` tessellations (by their seeds of grids) with `members` each.
std::vector<Configuration> cells(int groups, int members) {
  std::vector<Configuration> all;
  for (int member = 0; member < members; ++member)
    for (int group = 0; group < groups; ++group) {
      Configuration& c = all.emplace_back();
      c.scene = scenes().front()->name;
      c.width = 8;
      c.tessellation.width_px = 48;
      c.tessellation.height_px = 30;
      c.tessellation.grid_limit = group + 1;
      c.seed = static_cast<std::uint64_t>(member);
    }
  return all;
}

std::vector<std::string> ids(const std::vector<Configuration>& all) {
  std::vector<std::string> texts;
  for (const Configuration& c : all) texts.push_back(cell_id(c));
  return texts;
}

TEST(Shards, AreDisjointAndTogetherAllCells) {
  for (const auto& [groups, members] : {std::pair(1, 7), {3, 4}, {5, 2}, {4, 1}}) {
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
    EXPECT_EQ(group_by_tessellation(shard, {}).size(), 2u);
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
  EXPECT_EQ(group_by_tessellation(all, {}),
            (std::vector<std::vector<std::size_t>>{{0, 2, 4, 6, 8}, {1, 3, 5, 7, 9}}));
  GroupLimits limits;
  limits.members = 2;
  EXPECT_EQ(group_by_tessellation(all, limits).size(), 6u);
  limits = {};
  limits.frame_bytes = std::int64_t{48} * 30 * 4 * 8 * 3;  // Three frames of 4 samples a pixel.
  EXPECT_EQ(group_by_tessellation(all, limits),
            (std::vector<std::vector<std::size_t>>{{0, 2, 4}, {1, 3, 5}, {6, 8}, {7, 9}}));
  limits.frame_bytes = 1;
  EXPECT_EQ(group_by_tessellation(all, limits).size(), 10u);
}

TEST(CellId, TellsParametersApart) {
  const std::vector<std::string> all = ids(cells(5, 5));
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
  EXPECT_EQ(all.front().find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(all.front().size(), 16u);
}

class SweepInDirectory : public ::testing::Test {
 protected:
  SweepInDirectory()
      : path_(fs::path(::testing::TempDir()) /
              (std::string("lanescope-sweep-") +
               ::testing::UnitTest::GetInstance()->current_test_info()->name())),
        directory_(path_) {
    fs::remove_all(path_);
    directory_.open();
  }
  ~SweepInDirectory() override { fs::remove_all(path_); }

  fs::path path_;
  SweepDirectory directory_;
};

TEST_F(SweepInDirectory, SharesTessellationsOnlyAsFarAsAllowed) {
  const std::vector<Configuration> all = cells(2, 3);
  SweepOptions options;
  const SweepSummary shared = run_sweep(all, directory_, options);
  EXPECT_EQ(shared.done, 6u);
  EXPECT_EQ(shared.groups, 2u);
  EXPECT_NEAR(shared.dicing_unshared_ms, 3.0 * shared.dicing_ms, 1e-9 * shared.dicing_ms);
  fs::remove_all(directory_.cells_path());
  directory_.open();
  options.group_limits.members = 1;
  const SweepSummary alone = run_sweep(all, directory_, options);
  EXPECT_EQ(alone.groups, 6u);
  EXPECT_DOUBLE_EQ(alone.dicing_unshared_ms, alone.dicing_ms);
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
  for (std::size_t i = 2; i < 4; ++i) {
    all[i].scene = mesh;
    all[i].mesh_patches = MeshPatches::kLinear;
    all[i].frame = 0;
  }
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

/// A kernel that rejects one member must not take the others of its group with it.
TEST_F(SweepInDirectory, OnlyTheGuiltyCellOfAGroupFails) {
  std::vector<Configuration> all = cells(1, 3);
  all[1].kernel = "no such kernel";
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
  left[1].samples_per_pixel = 16;  // Four times the work.
  const auto known = estimate_sweep({done}, left, options);
  ASSERT_TRUE(known.has_value());
  EXPECT_TRUE(known->from_finished_cells);
  EXPECT_DOUBLE_EQ(known->seconds, 3.0 * 4 / 2 * 5 / 2);
}

}  // namespace
}  // namespace lanescope
