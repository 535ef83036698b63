// SPDX-License-Identifier: MIT
// Sweeps as a user runs them: resumed, in shards, with cells that fail, and killed at any moment.
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <random>
#include <thread>

#include "analysis/base/json_text.h"
#include "analysis/report/report_json.h"
#include "analysis/sweep/cell_claims.h"
#include "analysis/sweep/sweep_directory.h"
#include "tests/cli/working_directory.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;
using testing::lanescope_program;
using testing::Outcome;

/// Two scenes, two kinds of micropolygon and the two kernels at W = 8 on small frames.
const std::string kSmallSpec = R"({
  "schema": {"name": "lanescope-sweep", "version": 1},
  "parameters": {
    "scene": ["ballroll", "teapot"],
    "micropolygon": ["triangle", "quad"],
    "kernel": ["lockstep", "repack"],
    "width_lanes": 8, "width_px": 48, "height_px": 30
  }
})";
constexpr std::size_t kSmallCells = 8;

/// What tells two versions of a file apart, and when it was written.
struct Identity {
  ino_t inode;
  std::int64_t written_ns;
  bool operator==(const Identity&) const = default;
};

class Sweep : public testing::InEmptyDirectory {
 protected:
  Sweep() { write("spec.json", kSmallSpec); }

  std::map<std::string, Identity> cells(const std::string& out = "out") const {
    std::map<std::string, Identity> all;
    const fs::path path = directory() / out / "cells";
    if (!fs::exists(path)) return all;
    for (const auto& entry : fs::directory_iterator(path)) {
      struct stat status {};
      EXPECT_EQ(::stat(entry.path().c_str(), &status), 0);
      all[entry.path().filename()] = {
          status.st_ino, status.st_mtim.tv_sec * 1'000'000'000 + status.st_mtim.tv_nsec};
    }
    return all;
  }

  /// The runs of a report and their instructions, which no clock changes.
  std::string runs(const std::string& name) const {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(file(name));
    json.erase("timing");
    json.erase("made_by");
    return json_text(json);
  }

  std::string merged(const std::string& out) const {
    run("merge " + out + " -o merged.json");
    return runs("merged.json");
  }
};

TEST_F(Sweep, MergedIsWhatOneRunGives) {
  const Outcome swept = run("sweep spec.json --out out");
  EXPECT_NE(swept.errors.find("8 cells: 8 done, 0 failed, 0 finished before"), std::string::npos);
  EXPECT_EQ(swept.output, "");
  EXPECT_EQ(entries("out"), (std::set<std::string>{"cells", "claims", "summary.json"}));
  EXPECT_EQ(cells().size(), kSmallCells);
  run("run --scene ballroll,teapot --micropolygon triangle,quad --kernel lockstep,repack --width 8 "
      "--resolution 48x30 --json run.json");
  EXPECT_EQ(merged("out"), runs("run.json"));
  const Report report = read_report(directory() / "merged.json");
  EXPECT_EQ(report.command, "lanescope merge out");
  const auto summary = nlohmann::json::parse(file("out/summary.json"));
  EXPECT_EQ(summary["done"], kSmallCells);
  EXPECT_EQ(summary["groups"], 4);
  EXPECT_GT(summary["source_unshared_ms"], summary["source_ms"]);
}

TEST_F(Sweep, SharingChangesNoCount) {
  run("sweep spec.json --out out");
  run("sweep spec.json --out alone --no-share --threads 1");
  EXPECT_EQ(merged("alone"), merged("out"));
  const auto summary = nlohmann::json::parse(file("alone/summary.json"));
  EXPECT_EQ(summary["groups"], kSmallCells);
}

TEST_F(Sweep, GoesOnWithWhatIsLeft) {
  run("sweep spec.json --out out");
  const std::string whole = merged("out");
  auto before = cells();
  const std::string removed = before.begin()->first;
  fs::remove(directory() / "out/cells" / removed);
  const Outcome again = run("sweep spec.json --out out");
  EXPECT_NE(again.errors.find("8 cells: 1 done, 0 failed, 7 finished before"), std::string::npos);
  auto after = cells();
  EXPECT_EQ(after.erase(removed), 1u);
  before.erase(removed);
  EXPECT_EQ(after, before);
  EXPECT_EQ(merged("out"), whole);
}

TEST_F(Sweep, ShardsTogetherAreTheSweep) {
  run("sweep spec.json --out out");
  for (int shard = 1; shard <= 3; ++shard)
    run(fmt::format("sweep spec.json --out parts --shard {}/3", shard));
  EXPECT_EQ(merged("parts"), merged("out"));
  EXPECT_EQ(entries("parts"),
            (std::set<std::string>{"cells", "claims", "summary-1-of-3.json", "summary-2-of-3.json",
                                   "summary-3-of-3.json"}));
  run("sweep spec.json --out first --shard 1/2");
  run("sweep spec.json --out second --shard 2/2");
  EXPECT_EQ(cells("first").size() + cells("second").size(), kSmallCells);
  run("merge first second -o merged.json");
  EXPECT_EQ(runs("merged.json"), merged("out"));
}

TEST_F(Sweep, ADryRunListsAndRunsNothing) {
  const Outcome dry = run("sweep spec.json --out out --dry-run");
  EXPECT_EQ(entries(), std::set<std::string>{"spec.json"});
  EXPECT_NE(dry.output.find("  left     kernel=repack  scene=teapot  micropolygon=quad"),
            std::string::npos)
      << dry.output;
  EXPECT_NE(dry.output.find("8 cells: 0 done, 0 failed, 8 left in 4 groups\n"), std::string::npos);
  EXPECT_NE(dry.output.find("an estimate of the time: "), std::string::npos);
  run("sweep spec.json --out out --shard 1/2");
  const auto before = cells();
  const Outcome half = run("sweep spec.json --out out --dry-run");
  EXPECT_NE(half.output.find("8 cells: 4 done, 0 failed, 4 left in 2 groups\n"), std::string::npos);
  EXPECT_NE(half.output.find("from the cells that are done"), std::string::npos);
  EXPECT_EQ(cells(), before);
}

TEST_F(Sweep, ACellThatFailsDoesNotStopTheOthers) {
  write("mesh.json", R"({
    "schema": {"name": "lanescope-sweep", "version": 1},
    "parameters": {"scene": ["late.obj", "teapot"], "kernel": ["lockstep", "repack"],
                   "width_lanes": 8, "width_px": 48, "height_px": 30}})");
  const Outcome first = run("sweep mesh.json --out out", 1);
  EXPECT_NE(first.errors.find("lanescope: out: 2 of 4 cells failed; their errors are in "
                              "out/failed/\n"),
            std::string::npos)
      << first.errors;
  EXPECT_NE(first.errors.find("lanescope: 2 cells failed: late.obj: cannot be opened: No such file "
                              "or directory\n"),
            std::string::npos)
      << first.errors;
  EXPECT_EQ(cells().size(), 2u);
  EXPECT_EQ(entries("out/failed").size(), 2u);
  EXPECT_NE(file("out/failed/" + *entries("out/failed").begin())
                .find("late.obj: cannot be opened: No such file or directory"),
            std::string::npos);
  EXPECT_NE(run("sweep mesh.json --out out --dry-run").output.find("2 done, 2 failed, 0 left"),
            std::string::npos);
  EXPECT_EQ(run("merge out -o merged.json").errors,
            "lanescope: out: 2 cells failed and are not in the report; see out/failed/\n");
  write("late.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  run("sweep mesh.json --out out");
  EXPECT_EQ(cells().size(), 4u);
  EXPECT_EQ(entries("out/failed").size(), 0u);
  EXPECT_EQ(run("merge out -o merged.json").errors, "");
}

TEST_F(Sweep, MistakesAreFoundBeforeAnyWork) {
  write("bad.json", R"({"schema": {"name": "lanescope-sweep", "version": 1},
                        "parameters": {"kernel": "repak"}})");
  EXPECT_EQ(run("sweep bad.json --out out", 2).errors,
            "lanescope: bad.json:/parameters/kernel: \"repak\" is not a kernel; use " +
                list_or(testing::listed("kernels")) + "; did you mean 'repack'?\n");
  const std::vector<std::pair<std::string, std::string>> lines{
      {"sweep --out out", "sweep: name a spec, a JSON document"},
      {"sweep spec.json", "--out: is missing; name a directory"},
      {"sweep none.json --out out", "none.json: cannot be read: No such file or directory"},
      {"sweep spec.json --out spec.json",
       "spec.json/cells: cannot be created as a directory: Not a directory"},
      {"sweep spec.json --out out --shard 2", "--shard: '2' is not of the form I/N, as 1/4"},
      {"sweep spec.json --out out --shard 0/2", "--shard: '0' is not an integer from 1 to 2"},
      {"sweep spec.json --out out --shard 3/2", "--shard: '3' is not an integer from 1 to 2"},
      {"sweep spec.json --out out --memory-limit 0",
       "--memory-limit: '0' is not an integer from 1 to 1048576"},
      {"sweep spec.json --out out --group 0", "--group: '0' is not an integer from 1 to 4096"},
      {"sweep spec.json --out out --threads 0", "--threads: '0' is not an integer from 1 to 256"},
      {"merge -o r.json", "merge: name reports, or directories of sweeps"},
      {"merge r.json", "--output: is missing; name a file"},
      {"merge r.json -o s.json", "r.json: cannot be read: No such file or directory"},
      {"merge . -o r.json", ".: has no reports in ./cells; name the directory of a sweep"}};
  for (const auto& [arguments, complaint] : lines)
    EXPECT_EQ(run(arguments, 2).errors, "lanescope: " + complaint + "\n");
  EXPECT_EQ(entries(), (std::set<std::string>{"bad.json", "spec.json"}));
}

/// 24 cells in 12 groups.
const std::string kKillSpec = R"({
  "schema": {"name": "lanescope-sweep", "version": 1},
  "parameters": {
    "scene": ["ballroll", "teapot"],
    "grid_limit": [4, 8, 16],
    "micropolygon": ["triangle", "quad"],
    "kernel": ["lockstep", "repack"],
    "width_lanes": 8, "width_px": 48, "height_px": 30
  }
})";
constexpr std::size_t kKillCells = 24;

class KilledSweep : public Sweep {
 protected:
  KilledSweep() { write("spec.json", kKillSpec); }

  /// Starts a sweep, in groups of one cell, and does not wait for it.
  pid_t start(const char* shard) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (::chdir(directory().c_str()) != 0 || !std::freopen("errors", "a", stderr)) ::_exit(1);
    ::execl(LANESCOPE_BINARY, "lanescope", "sweep", "spec.json", "--out", "out", "--group", "1",
            "--shard", shard, nullptr);
    ::_exit(1);
  }

  /// Waits for the end of a sweep. Returns whether it was killed.
  bool was_killed(pid_t child) const {
    int ended = 0;
    EXPECT_EQ(::waitpid(child, &ended, 0), child);
    if (WIFEXITED(ended)) {
      EXPECT_EQ(WEXITSTATUS(ended), 0) << file("errors");
    }
    return WIFSIGNALED(ended);
  }

  /// Starts the sweep and kills it after the delay. Returns whether that came before its end.
  bool killed_after(std::chrono::duration<double, std::milli> delay) const {
    const pid_t child = start("1/1");
    std::this_thread::sleep_for(delay);
    ::kill(child, SIGKILL);
    return was_killed(child);
  }

  /// Every file of a cell is the whole report of one run of that name.
  void check_cells() const {
    for (const auto& [name, identity] : cells()) {
      if (name.find(".tmp-") != name.npos) continue;
      const Report report = read_report(directory() / "out/cells" / name);
      ASSERT_EQ(report.runs.size(), 1u);
      EXPECT_EQ(cell_id(report.runs.front().configuration) + ".json", name);
    }
  }

  std::map<std::string, Identity> finished() const {
    auto all = cells();
    std::erase_if(all,
                  [](const auto& cell) { return cell.first.find(".tmp-") != std::string::npos; });
    return all;
  }
};

TEST_F(KilledSweep, LosesNothingThatWasFinished) {
  constexpr int kKills = 50;
  run("sweep spec.json --out undisturbed --group 1");
  const std::string expected = merged("undisturbed");
  const double wall_ms = nlohmann::json::parse(file("undisturbed/summary.json"))["wall_ms"];
  std::mt19937 random(20100610);
  std::uniform_real_distribution<double> delay_ms(5.0, std::max(60.0, wall_ms / 4));
  int kills = 0;  // Those that came when some cells were there, and others were not.
  for (int starts = 0; kills < kKills; ++starts) {
    ASSERT_LT(starts, 20 * kKills) << "sweeps end before they can be killed";
    const auto before = finished();
    const bool killed = killed_after(std::chrono::duration<double, std::milli>(delay_ms(random)));
    check_cells();
    const auto after = finished();
    for (const auto& [name, identity] : before) {
      ASSERT_TRUE(after.contains(name)) << name;
      EXPECT_EQ(after.at(name), identity) << name << " was done again";
    }
    if (killed && !after.empty() && after.size() < kKillCells) ++kills;
    if (after.size() < kKillCells) continue;
    run("sweep spec.json --out out");  // Removes what the last kill may have left.
    EXPECT_EQ(cells().size(), kKillCells);
    EXPECT_EQ(merged("out"), expected);
    fs::remove_all(directory() / "out");
  }
  run("sweep spec.json --out out");
  EXPECT_EQ(cells().size(), kKillCells) << "with leftovers of killed writes";
  EXPECT_EQ(merged("out"), expected);
}

TEST_F(KilledSweep, ProcessesMayWorkOnOneDirectoryAtATime) {
  run("sweep spec.json --out alone");
  for (const auto& [first, second] : {std::pair("1/2", "2/2"), {"1/1", "1/1"}}) {
    fs::remove_all(directory() / "out");
    const pid_t one = start(first);
    const pid_t other = start(second);
    EXPECT_FALSE(was_killed(one));
    EXPECT_FALSE(was_killed(other));
    EXPECT_EQ(cells().size(), kKillCells);
    EXPECT_EQ(merged("out"), merged("alone"));
  }
}

TEST_F(KilledSweep, ProcessesOfOneDirectoryShareTheWork) {
  std::vector<pid_t> all;
  for (int i = 0; i < 3; ++i) all.push_back(start("1/1"));
  for (const pid_t one : all) EXPECT_FALSE(was_killed(one));
  const std::string told = file("errors");
  std::size_t done = 0;
  for (std::size_t at = 0; (at = told.find(" cells: ", at)) != told.npos; ++at)
    done += std::stoull(told.substr(at + std::string(" cells: ").size()));
  EXPECT_EQ(done, kKillCells) << told;
}

TEST_F(KilledSweep, ClaimsOfTheDeadExpireAndThoseOfOthersHold) {
  run("sweep spec.json --out out");
  const std::string name = cells().begin()->first;
  const std::string id = name.substr(0, name.find('.'));
  fs::remove(directory() / "out/cells" / name);
  const pid_t holder = ::fork();
  if (holder == 0) {
    const CellClaims claims(directory() / "out");
    const bool is_ours = claims.take(id);
    write("claimed", "");
    ::pause();
    ::_exit(is_ours);
  }
  while (!fs::exists(directory() / "claimed")) std::this_thread::yield();
  EXPECT_TRUE(is_claimed(directory() / "out", id));
  EXPECT_NE(run("sweep spec.json --out out --dry-run").output.find(id + "  running"),
            std::string::npos);
  const pid_t waiting = start("1/1");
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  EXPECT_EQ(cells().size(), kKillCells - 1) << "was run twice";
  ::kill(holder, SIGKILL);
  EXPECT_TRUE(was_killed(holder));
  EXPECT_FALSE(was_killed(waiting));
  EXPECT_EQ(cells().size(), kKillCells);
  EXPECT_FALSE(is_claimed(directory() / "out", id));
}

TEST_F(KilledSweep, LeftoversOfDeadProcessesGoAndThoseOfOthersStay) {
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ::waitpid(dead, nullptr, 0);
  fs::create_directories(directory() / "out/cells");
  const std::string of_dead = fmt::format("a.json.tmp-{}", dead);
  const std::string of_living = fmt::format("b.json.tmp-{}", ::getpid());
  write("out/cells/" + of_dead, "{");
  write("out/cells/" + of_living, "{");
  write("out/cells/notes.tmp-x", "not ours");
  run("sweep spec.json --out out");
  const std::set<std::string> left = entries("out/cells");
  EXPECT_FALSE(left.contains(of_dead));
  EXPECT_TRUE(left.contains(of_living));
  EXPECT_TRUE(left.contains("notes.tmp-x"));
}

}  // namespace
}  // namespace lanescope
