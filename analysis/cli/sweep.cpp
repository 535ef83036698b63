// SPDX-License-Identifier: MIT
// `lanescope sweep`: many configurations, each kept as a report of its own.
#include "analysis/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "analysis/base/files.h"
#include "analysis/cli/experiment_arguments.h"
#include "analysis/cli/memory_notice.h"
#include "analysis/cli/narration.h"
#include "analysis/cli/output.h"
#include "analysis/cli/process.h"
#include "analysis/cli/values.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/sweep/cell_claims.h"
#include "analysis/sweep/sweep_json.h"
#include "analysis/sweep/sweep_spec.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

constexpr int kMaxShards = 4096;
constexpr int kMaxMemory_mb = 1 << 20;
constexpr int kMaxGroup = 4096;

struct Given {
  std::string spec;
  std::string out;
  std::string shard;
  std::string threads;
  std::string memory_limit;
  std::string group = "16";
  bool dry_run = false;
  bool no_share = false;

  Given() : memory_limit(std::to_string(GroupLimits{}.output_bytes >> 20)) {}
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

Request resolve(const CommandOptions& command, const Given& given) {
  if (given.spec.empty()) throw InputError("sweep", "name a spec, a JSON document");
  if (given.out.empty()) throw InputError("--out", "is missing; name a directory");
  Request request;
  request.shard = parse_shard(given.shard);
  SweepOptions& options = request.options;
  options.threads = parse_threads(given.threads);
  options.command = command.command_line();
  GroupLimits& limits = options.group_limits;
  limits.output_bytes = static_cast<std::uint64_t>(
                            parse_integer({"--memory-limit", given.memory_limit}, 1, kMaxMemory_mb))
                        << 20;
  limits.members = static_cast<std::size_t>(parse_integer({"--group", given.group}, 1, kMaxGroup));
  if (given.no_share) limits.members = 1;
  request.cells = shard_of(parse_sweep_spec(read_file(given.spec), given.spec), request.shard.index,
                           request.shard.count);
  return request;
}

std::string values_of(const Configuration& cell, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += fmt::format("  {}={}", name, value_text(value_of(cell, name)));
  return text;
}

std::string estimate_text(const std::vector<Report>& done, const std::vector<Configuration>& left,
                          const SweepOptions& options) {
  const auto estimate = estimate_sweep(done, left, options);
  if (!estimate) return "the time that they take is not known\n";
  return fmt::format(
      "an estimate of the time: {} on {} threads, from {}\n",
      duration_text(std::max(1.0, estimate->seconds)), options.threads,
      estimate->from_finished_cells ? "the cells that are done" : "a brief run of a part");
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
    const std::string id = cell_id(cell);
    const bool has_failed = !report && directory.has_failed(cell);
    if (report) done.push_back(*report);
    if (!report) left.push_back(cell);
    if (has_failed) ++failed;
    text += fmt::format("{}  {:7}{}\n", id,
                        report                             ? "done"
                        : is_claimed(directory.path(), id) ? "running"
                        : has_failed                       ? "failed"
                                                           : "left",
                        values_of(cell, names));
  }
  text += fmt::format("{} cells: {} done, {} failed, {} left in {} groups\n", request.cells.size(),
                      done.size(), failed, left.size() - failed,
                      group_by_source(left, request.options.group_limits).size());
  if (!left.empty()) text += estimate_text(done, left, request.options);
  print(text);
}

std::string summary_path(const SweepDirectory& directory, const Shard& shard) {
  if (shard.count == 1) return directory.path() + "/summary.json";
  return fmt::format("{}/summary-{}-of-{}.json", directory.path(), shard.index, shard.count);
}

double percent(double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : 0.0; }

void tell_end(const SweepSummary& s) {
  tell(fmt::format("{} cells: {} done, {} failed, {} finished before{}; {:.1f} s on {} threads",
                   s.cells, s.done, s.failed, s.skipped,
                   s.elsewhere > 0 ? fmt::format(", {} by others", s.elsewhere) : "",
                   s.wall_ms / 1000.0, s.threads));
  if (s.done > 0)
    tell(fmt::format(
        "making the work took {:.1f} s, {:.0f}% of the time; not shared it would be "
        "{:.1f} s, and all time {:.2f} times as much; peak memory {} MB",
        s.source_ms / 1000.0, percent(s.source_ms, s.work_ms()), s.source_unshared_ms / 1000.0,
        s.work_unshared_ms() / s.work_ms(), s.peak_memory_bytes >> 20));
}

/// What went wrong, the first few of many kinds.
void tell_failures(const std::string& out, const SweepDirectory& directory, const SweepSummary& s) {
  constexpr std::size_t kShown = 10;
  std::size_t shown = 0;
  for (const auto& [reason, cells] : s.failures) {
    if (++shown > kShown) break;
    tell(fmt::format("{} failed: {}", cells == 1 ? "1 cell" : fmt::format("{} cells", cells),
                     reason));
  }
  if (s.failures.size() > kShown)
    tell(fmt::format("and {} other reasons", s.failures.size() - kShown));
  tell(fmt::format("{}: {} of {} cells failed; their errors are in {}/", out, s.failed, s.cells,
                   directory.failed_path()));
}

SweepSummary run_shown(const Request& request, const SweepDirectory& directory,
                       const std::string& title) {
  SweepOptions options = request.options;
  Narration progress(title);
  options.opening = progress.listener();
  options.progress = [&](const SweepProgress& p) {
    const double per_minute =
        60.0 * static_cast<double>(p.done + p.failed) / std::max(1e-3, progress.elapsed_s());
    progress.update(
        p.fraction,
        fmt::format("{} done, {} failed, {} left{}, {:.1f} cells/min", p.done, p.failed, p.left,
                    p.elsewhere > 0 ? fmt::format(" ({} run by others)", p.elsewhere) : "",
                    per_minute));
  };
  return run_sweep(request.cells, directory, options);
}

/// Exit status 1: every cell was tried, and some failed.
int sweep(const CommandOptions& command, const Given& given) {
  const Request request = resolve(command, given);
  const SweepDirectory directory(given.out);
  if (given.dry_run) {
    list(request, directory);
    return 0;
  }
  directory.open();
  say_when_interrupted(command.name(), "finished cells are kept, the same command goes on");
  tell_memory(request.cells, request.options.group_limits);
  OutputFile summary_file(summary_path(directory, request.shard));
  const SweepSummary summary = run_shown(request, directory, command.name());
  if (summary.done + summary.failed > 0) summary_file.commit(summary_text(summary));
  tell_end(summary);
  if (summary.failed == 0) return 0;
  tell_failures(given.out, directory, summary);
  return 1;
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  options.add_argument({"spec", "SPEC", "The cells, a JSON document (docs/sweeps.md)"},
                       given->spec);
  options.add_output(
      {"--out", "DIR", "Keeps a report of each cell there; goes on with what is left"}, given->out);
  options.add_output({"--shard", "I/N", "Only the I-th of N parts of the cells"}, given->shard);
  add_threads_option(options, given->threads);
  options.add_output({"--memory-limit", "MB", "Outputs of cells that run together"},
                     given->memory_limit);
  options.add_output({"--group", "N", "At most N cells run together; a kill loses no more"},
                     given->group);
  options.add_output_flag("--no-share", "Makes the work of each cell by itself, to measure",
                          given->no_share);
  options.add_output_flag("--dry-run", "Lists the cells and an estimate of the time",
                          given->dry_run);
  return [&options, given] { return sweep(options, *given); };
}

}  // namespace

extern const Command c_sweep{"sweep", "Runs many configurations and keeps each one's report",
                             "  lanescope sweep examples/small-sweep.json --out cells --dry-run\n"
                             "  lanescope sweep examples/small-sweep.json --out cells\n"
                             "  lanescope sweep examples/small-sweep.json --out cells --shard 1/4\n"
                             "  lanescope merge cells -o report.json",
                             declare};

}  // namespace lanescope
