// SPDX-License-Identifier: MIT
#include "analysis/report/stage_reader.h"

#include <algorithm>
#include <numeric>

#include "analysis/report/figures.h"
#include "analysis/report/report_checks.h"

namespace lanescope {
namespace {

using CountList = std::vector<std::uint64_t>;

std::uint64_t read_count(const JsonCursor& cursor) { return cursor.count(); }

std::uint64_t sum(const CountList& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

/// Sum of k over the things that a histogram counts.
std::uint64_t weighted_sum(const CountList& histogram) {
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < histogram.size(); ++k) sum += k * histogram[k];
  return sum;
}

/// Reads the instructions and the memory of one stage.
class StageReader {
 public:
  StageReader(int width, const Charges& charges) : width_(width), charges_(charges) {}

  StageRecord read(const JsonCursor& cursor) const {
    cursor.allow_members({"name", "utilization", "instructions", "lane_active", "histogram",
                          "memory", "lane_groups"});
    StageRecord stage;
    stage.name = cursor.member("name").string();
    stage.instructions = read_named(cursor.member("instructions"), "mnemonic",
                                    [&](const JsonCursor& c) { return read_instruction(c); });
    stage.lane_active = read_counts(cursor.member("lane_active"), width_);
    stage.histogram = read_counts(cursor.member("histogram"), width_ + 1);
    check_ratio(cursor.member("utilization"), utilization(stage, width_));
    check_lanes(cursor, stage);
    stage.memory = read_named(cursor.member("memory"), "mnemonic",
                              [&](const JsonCursor& c) { return read_memory(c, stage); });
    if (cursor.has_member("lane_groups"))  // Reports of earlier programs lack them.
      stage.lane_groups = read_named(cursor.member("lane_groups"), "mnemonic",
                                     [&](const JsonCursor& c) { return read_groups(c, stage); });
    return stage;
  }

 private:
  std::uint64_t lane_slots(std::uint64_t issued) const {
    return issued * static_cast<std::uint64_t>(width_);
  }

  Charge charge_of(const JsonCursor& mnemonic) const {
    const auto found = charges_.find(mnemonic.string());
    if (found == charges_.end()) mnemonic.fail("the mnemonic of one of /instructions");
    return found->second;
  }

  InstructionRecord read_instruction(const JsonCursor& cursor) const {
    cursor.require_members({"mnemonic", "issued", "active", "overhead_issued", "overhead_active"});
    const InstructionRecord counts{cursor.member("mnemonic").string(),
                                   cursor.member("issued").count(), cursor.member("active").count(),
                                   cursor.member("overhead_issued").count(),
                                   cursor.member("overhead_active").count()};
    require_at_most(cursor.member("overhead_issued"), counts.issued, "which were issued");
    require_at_most(cursor.member("overhead_active"), counts.active, "which were active");
    const Charge charge = charge_of(cursor.member("mnemonic"));
    check_charged(cursor.member("active"), charge, counts.issued);
    check_charged(cursor.member("overhead_active"), charge, counts.overhead_issued);
    return counts;
  }

  /// Checks the lanes charged for so many executions.
  void check_charged(const JsonCursor& active, Charge charge, std::uint64_t issued) const {
    if (charge == Charge::kActiveLanes)
      require_at_most(active, lane_slots(issued), "the lane slots of those issued");
    else
      require_count(active, charged_lanes(charge, issued, 0, width_),
                    fmt::format("as each is charged {}", to_string(charge)));
  }

  CountList read_counts(const JsonCursor& cursor, int length) const {
    CountList counts = read_list(cursor, read_count);
    if (counts.size() != static_cast<std::size_t>(length))
      throw InputError(cursor.where(), "has {} elements; {} are needed", counts.size(), length);
    return counts;
  }

  /// Checks that the lanes and their histogram are of the instructions issued.
  static void check_lanes(const JsonCursor& cursor, const StageRecord& stage) {
    const std::uint64_t issued = stage.total().issued;
    if (sum(stage.histogram) != issued)
      throw InputError(cursor.member("histogram").where(),
                       "adds up to {}; {} instructions were issued", sum(stage.histogram), issued);
    if (sum(stage.lane_active) != weighted_sum(stage.histogram))
      throw InputError(cursor.member("lane_active").where(), "adds up to {}; {} by the histogram",
                       sum(stage.lane_active), weighted_sum(stage.histogram));
  }

  MemoryRecord read_memory(const JsonCursor& cursor, const StageRecord& stage) const {
    cursor.require_members(
        {"mnemonic", "issued", "active", "lines", "lines_histogram", "conflicts"});
    const MemoryRecord memory{cursor.member("mnemonic").string(),
                              cursor.member("issued").count(),
                              cursor.member("active").count(),
                              cursor.member("lines").count(),
                              read_list(cursor.member("lines_histogram"), read_count),
                              cursor.member("conflicts").count()};
    check_lines(cursor, memory);
    check_observed(cursor, memory, stage);
    return memory;
  }

  void check_lines(const JsonCursor& cursor, const MemoryRecord& memory) const {
    const auto places = static_cast<std::size_t>(width_) + 1;
    if (memory.lines_histogram.size() < places)
      throw InputError(cursor.member("lines_histogram").where(),
                       "has {} elements; at least {} are needed", memory.lines_histogram.size(),
                       places);
    require_count(cursor.member("issued"), sum(memory.lines_histogram),
                  "which the histogram gives");
    require_count(cursor.member("lines"), weighted_sum(memory.lines_histogram),
                  "which the histogram gives");
  }

  LaneGroupRecord read_groups(const JsonCursor& cursor, const StageRecord& stage) const {
    cursor.require_members({"mnemonic", "issued", "active_groups", "dense_groups"});
    const LaneGroupRecord record{cursor.member("mnemonic").string(),
                                 cursor.member("issued").count(),
                                 {read_group_counts(cursor.member("active_groups")),
                                  read_group_counts(cursor.member("dense_groups"))}};
    const InstructionRecord& counts = counts_of(cursor.member("mnemonic"), stage);
    require_at_most(cursor.member("issued"), counts.issued, "which were issued");
    check_groups(cursor, record);
    return record;
  }

  GroupCounts read_group_counts(const JsonCursor& cursor) const {
    const CountList list = read_counts(cursor, static_cast<int>(kGroupLanes.size()));
    GroupCounts counts;
    std::copy(list.begin(), list.end(), counts.begin());
    return counts;
  }

  /// Checks that groups are of the lanes of so many executions.
  void check_groups(const JsonCursor& cursor, const LaneGroupRecord& record) const {
    const std::vector<JsonCursor> active = cursor.member("active_groups").items();
    const std::vector<JsonCursor> dense = cursor.member("dense_groups").items();
    require_count(dense.front(), record.groups.active.front(), "the lanes that were on");
    for (std::size_t place = 0; place < kGroupLanes.size(); ++place) {
      const auto size = static_cast<std::uint64_t>(kGroupLanes[place]);
      const auto width = static_cast<std::uint64_t>(width_);
      require_at_most(active[place], record.issued * ((width + size - 1) / size),
                      "the groups of those observed");
      require_at_most(dense[place], record.groups.active[place], "the groups with a lane on");
    }
  }

  /// What was issued in the stage of an instruction observed.
  static const InstructionRecord& counts_of(const JsonCursor& mnemonic, const StageRecord& stage) {
    const std::string name = mnemonic.string();
    const auto counts = std::find_if(stage.instructions.begin(), stage.instructions.end(),
                                     [&](const auto& other) { return other.mnemonic == name; });
    if (counts == stage.instructions.end())
      mnemonic.fail("the mnemonic of an instruction of this stage");
    return *counts;
  }

  /// Checks that executions were observed of what was issued. Lanes observed are those that were
  /// on, whatever the instruction is charged: they are among the lanes charged only if those are
  /// the active ones.
  void check_observed(const JsonCursor& cursor, const MemoryRecord& memory,
                      const StageRecord& stage) const {
    const InstructionRecord& counts = counts_of(cursor.member("mnemonic"), stage);
    require_at_most(cursor.member("issued"), counts.issued, "which were issued");
    const std::uint64_t slots = lane_slots(memory.issued);
    require_at_most(cursor.member("active"), slots, "the lane slots of those observed");
    const bool charges_active = charge_of(cursor.member("mnemonic")) == Charge::kActiveLanes;
    if (charges_active)
      require_at_most(cursor.member("active"), counts.active, "which were active");
    require_at_most(cursor.member("conflicts"), charges_active ? memory.active : slots,
                    charges_active ? "which were active" : "the lane slots of those observed");
  }

  int width_;
  const Charges& charges_;
};

SourcePlace read_place(const JsonCursor& cursor) {
  return {cursor.member("file").string(),
          static_cast<std::uint32_t>(cursor.member("line").integer(1))};
}

/// Where a block was opened; reports of earlier programs do not say.
std::optional<SourcePlace> read_block(const JsonCursor& line) {
  if (!line.has_member("block")) return std::nullopt;
  const JsonCursor block = line.member("block");
  block.require_members({"file", "line"});
  return read_place(block);
}

SourceLineRecord read_source_line(const JsonCursor& cursor) {
  cursor.allow_members({"file", "line", "stage", "issued", "active", "overhead", "block"});
  return {read_place(cursor),
          cursor.member("stage").string(),
          cursor.member("issued").count(),
          cursor.member("active").count(),
          cursor.member("overhead").count(),
          read_block(cursor)};
}

}  // namespace

std::vector<StageRecord> read_stages(const JsonCursor& list, int width, const Charges& charges) {
  const StageReader reader(width, charges);
  return read_named(list, "name", [&](const JsonCursor& stage) { return reader.read(stage); });
}

std::vector<SourceLineRecord> read_source_lines(const JsonCursor& list,
                                                const std::vector<StageRecord>& stages) {
  std::map<std::string, InstructionRecord> left;
  for (const StageRecord& stage : stages) left[stage.name] = stage.total();
  std::vector<SourceLineRecord> lines;
  for (const JsonCursor& cursor : list.items()) {
    const SourceLineRecord& line = lines.emplace_back(read_source_line(cursor));
    const auto stage = left.find(line.stage);
    if (stage == left.end()) cursor.member("stage").fail("the name of a stage of this run");
    require_at_most(cursor.member("issued"), stage->second.issued, "which the stage issued");
    require_at_most(cursor.member("active"), stage->second.active,
                    "which were active in the stage");
    require_at_most(cursor.member("overhead"), line.issued, "which were issued");
    stage->second.issued -= line.issued;
    stage->second.active -= line.active;
  }
  return lines;
}

}  // namespace lanescope
