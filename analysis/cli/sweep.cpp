// SPDX-License-Identifier: MIT
// `lanescope sweep`: many configurations, each kept as a report of its own.
#include "analysis/sweep/sweep.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "analysis/base/files.h"
#include "analysis/cli/command.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/output.h"
#include "analysis/cli/progress.h"
#include "analysis/cli/values.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/sweep/sweep_json.h"
#include "analysis/sweep/sweep_spec.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

constexpr int kMaxShards = 4096;
constexpr int kMaxMemory_mb = 1 << 20;
constexpr int kMaxGroup = 4096;

struct Arguments {
  std::string spec;
  std::string out;
  std::string shard;
  std::string threads;
  std::string memory_limit;
  std::string group = "16";
  bool dry_run = false;
  bool no_share = false;

  Arguments() : memory_limit(std::to_string(GroupLimits{}.frame_bytes >> 20)) {}
};

struct Shard {
  int index = 1;
  int count = 1;
};

Shard parse_shard(const std::string& text) {
  if (text.empty()) return {};
  const Argument argument{"--shard", text};
  const std::size_t slash = text.find('/');
  if (slash == text.npos) argument.fail("of the form I/N, as 1/4");
  const std::string_view all = text;
  const int count = parse_integer({argument.option, all.substr(slash + 1)}, 1, kMaxShards);
  return {parse_integer({argument.option, all.substr(0, slash)}, 1, count), count};
}

/// What is asked for, checked before any work.
struct Request {
  std::vector<Configuration> cells;
  Shard shard;
  SweepOptions options;
};

Request resolve(const CLI::App& app, const Arguments& arguments) {
  if (arguments.spec.empty()) throw InputError("sweep", "name a spec, a JSON document");
  if (arguments.out.empty()) throw InputError("--out", "is missing; name a directory");
  Request request;
  request.shard = parse_shard(arguments.shard);
  SweepOptions& options = request.options;
  options.threads = resolve_threads(arguments.threads);
  options.command = command_of(app);
  GroupLimits& limits = options.group_limits;
  limits.frame_bytes =
      std::int64_t{parse_integer({"--memory-limit", arguments.memory_limit}, 1, kMaxMemory_mb)}
      << 20;
  limits.members =
      static_cast<std::size_t>(parse_integer({"--group", arguments.group}, 1, kMaxGroup));
  if (arguments.no_share) limits.members = 1;
  request.cells = shard_of(parse_sweep_spec(read_file(arguments.spec), arguments.spec),
                           request.shard.index, request.shard.count);
  return request;
}

/// A value as the listing shows it: a name without quotes.
std::string plain(const nlohmann::ordered_json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string values_of(const Configuration& cell, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += fmt::format("  {}={}", name, plain(parameter_json(name, cell)));
  return text;
}

std::string estimate_text(const std::vector<Report>& done, const std::vector<Configuration>& left,
                          const SweepOptions& options) {
  const auto estimate = estimate_sweep(done, left, options);
  if (!estimate) return "the time that they take is not known\n";
  return fmt::format(
      "an estimate of the time: {} on {} threads, from {}\n",
      duration_text(std::max(1.0, estimate->seconds)), options.threads,
      estimate->from_finished_cells ? "the cells that are done" : "a brief run on a small frame");
}

/// Lists the cells and what is known of them.
void list(const Request& request, const SweepDirectory& directory) {
  const std::vector<std::string> names = varying_parameters(request.cells);
  std::vector<Report> done;
  std::vector<Configuration> left;
  std::size_t failed = 0;
  std::string text;
  for (const Configuration& cell : request.cells) {
    const auto report = directory.find(cell);
    const bool has_failed = !report && directory.has_failed(cell);
    if (report) done.push_back(*report);
    if (!report) left.push_back(cell);
    if (has_failed) ++failed;
    text += fmt::format("{}  {:6}{}\n", cell_id(cell),
                        report       ? "done"
                        : has_failed ? "failed"
                                     : "left",
                        values_of(cell, names));
  }
  text += fmt::format("{} cells: {} done, {} failed, {} left in {} groups\n", request.cells.size(),
                      done.size(), failed, left.size() - failed,
                      group_by_tessellation(left, request.options.group_limits).size());
  if (!left.empty()) text += estimate_text(done, left, request.options);
  print(text);
}

std::string summary_path(const SweepDirectory& directory, const Shard& shard) {
  if (shard.count == 1) return directory.path() + "/summary.json";
  return fmt::format("{}/summary-{}-of-{}.json", directory.path(), shard.index, shard.count);
}

double percent(double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : 0.0; }

void tell_end(const SweepSummary& s) {
  std::string text = fmt::format(
      "lanescope: {} cells: {} done, {} failed, {} finished before; {:.1f} s on {} threads",
      s.cells, s.done, s.failed, s.skipped, s.wall_ms / 1000.0, s.threads);
  if (s.done > 0)
    text += fmt::format(
        "\nlanescope: dicing took {:.1f} s, {:.0f}% of the work; not shared it would be {:.1f} s, "
        "and all work {:.2f} times as much; peak memory {} MB",
        s.dicing_ms / 1000.0, percent(s.dicing_ms, s.work_ms()), s.dicing_unshared_ms / 1000.0,
        s.work_unshared_ms() / s.work_ms(), s.peak_memory_bytes >> 20);
  std::fputs((text + '\n').c_str(), stderr);
}

SweepSummary run_shown(const Request& request, const SweepDirectory& directory,
                       const std::string& title) {
  SweepOptions options = request.options;
  Progress progress(title);
  options.progress = [&](const SweepProgress& p) {
    const double per_minute =
        60.0 * static_cast<double>(p.done + p.failed) / std::max(1e-3, progress.elapsed_s());
    progress.update(p.fraction, fmt::format("{} done, {} failed, {} left, {:.1f} cells/min", p.done,
                                            p.failed, p.left, per_minute));
  };
  return run_sweep(request.cells, directory, options);
}

/// Exit status 1: every cell was tried, and some failed.
int sweep(const CLI::App& app, const Arguments& arguments) {
  const Request request = resolve(app, arguments);
  const SweepDirectory directory(arguments.out);
  if (arguments.dry_run) {
    list(request, directory);
    return 0;
  }
  directory.open();
  AtomicFile summary_file(summary_path(directory, request.shard));
  const SweepSummary summary = run_shown(request, directory, app.get_name());
  if (summary.done + summary.failed > 0) summary_file.commit(summary_text(summary));
  tell_end(summary);
  if (summary.failed == 0) return 0;
  std::fputs(fmt::format("lanescope: {}: {} of {} cells failed; their errors are in {}/\n",
                         arguments.out, summary.failed, summary.cells, directory.failed_path())
                 .c_str(),
             stderr);
  return 1;
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  const auto add = [&](const char* option, std::string& text, const char* form,
                       const char* meaning) {
    CLI::Option* added = app.add_option(option, text, meaning)->type_name(form)->group("Output");
    if (!text.empty()) added->default_str(text);
  };
  app.add_option("spec", arguments->spec, "The cells, a JSON document (docs/sweeps.md)")
      ->type_name("SPEC");
  add("--out", arguments->out, "DIR",
      "Keeps a report of each cell there; goes on with what is left");
  add("--shard", arguments->shard, "I/N", "Only the I-th of N parts of the cells");
  add("--threads", arguments->threads, "N", "Threads; all of the host if left out");
  add("--memory-limit", arguments->memory_limit, "MB", "Frames of cells that run together");
  add("--group", arguments->group, "N", "At most N cells run together; a kill loses no more");
  app.add_flag("--no-share", arguments->no_share, "Dices each cell by itself, to measure")
      ->group("Output");
  app.add_flag("--dry-run", arguments->dry_run, "Lists the cells and an estimate of the time")
      ->group("Output");
  return [&app, arguments] { return sweep(app, *arguments); };
}

}  // namespace

extern const Command c_sweep{
    "sweep", "Runs many configurations and keeps each one's report",
    "  lanescope sweep examples/thesis-sweep.json --out cells --dry-run\n"
    "  lanescope sweep examples/thesis-sweep.json --out cells\n"
    "  lanescope sweep examples/thesis-sweep.json --out cells --shard 1/4\n"
    "  lanescope merge cells -o report.json",
    declare};

}  // namespace lanescope
