// SPDX-License-Identifier: MIT
// Descriptions of machines: what is read, and what is refused with which words.
#include "analysis/machines/description.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/base/files.h"
#include "analysis/machines/cost_tables.h"
#include "analysis/machines/price.h"
#include "simulator/base/error.h"
#include "tests/analysis/machines/sample_machine.h"
#include "tests/scratch_directory.h"

namespace lanescope {
namespace {

using testing::four_lanes;
using testing::machine_from;

std::string refusal(const std::string& text) {
  try {
    machine_from(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// A description that differs from a machine of the program in these members.
std::string heir(const std::string& members) {
  return R"({"name": "mine", "summary": "mine", "inherits": "avx2")" + members + "}";
}

TEST(ShippedMachines, HaveAPriceForEveryInstructionAtEveryWidth) {
  EXPECT_GE(shipped_machines().size(), 12u);
  for (const MachineDescription& machine : shipped_machines()) {
    SequenceTrials trials;
    for (const int width : {1, 8, 24, 64}) {
      Prices prices(machine, width, trials);
      for (const InstructionInfo* info : priced_instructions()) {
        const Price& price = prices.of(info->mnemonic, to_string(info->instruction_class));
        EXPECT_TRUE(price.missing.empty()) << machine.name << ": " << info->mnemonic;
      }
    }
  }
}

TEST(ShippedMachines, SayWhereEachFigureIsFrom) {
  for (const MachineDescription& machine : shipped_machines())
    for (const SlotFigures* figures : {&machine.classes, &machine.instructions, &machine.own})
      for (const auto& [name, figure] : *figures) {
        EXPECT_TRUE(figure.known) << machine.name << ": " << name;
        EXPECT_TRUE(figure.sequence || !figure.source.empty()) << machine.name << ": " << name;
        EXPECT_TRUE(figure.source.empty() || figure.source == "assumed" ||
                    figure.source.size() > 20)
            << machine.name << ": " << figure.source;
      }
}

TEST(ShippedMachines, TakeASlotForAnAdditionOfFloats) {
  for (const MachineDescription& machine : shipped_machines()) {
    SequenceTrials trials;
    Prices prices(machine, 8, trials);
    const int lanes = machine.lanes.value_or(8);
    EXPECT_EQ(slots_of(prices.of("add", "arithmetic"),
                       counted_once(machine, low_bits(std::min(lanes, 8)), 0)),
              1.0)
        << machine.name;
  }
}

TEST(Descriptions, InheritAndReplace) {
  const MachineDescription mine = machine_from(heir(R"(, "sources": {"guess": "a guess"},
             "instructions": {"add": {"slots": {"every_group": 2}, "source": "guess"}},
             "own": {"cross": {"slots": {"lane": 3}, "source": "assumed"}})"));
  EXPECT_EQ(mine.lanes, 8);
  EXPECT_EQ(at(mine.find("add", "arithmetic")->slots, SlotBasis::kEveryGroup), 2.0);
  EXPECT_EQ(mine.find("add", "arithmetic")->source, "a guess");
  EXPECT_EQ(at(mine.find("mul", "arithmetic")->slots, SlotBasis::kEveryGroup), 1.0);
  EXPECT_EQ(at(mine.find("cross", "arithmetic")->slots, SlotBasis::kLane), 3.0);
  EXPECT_EQ(mine.find("fancy", "memory"), nullptr);
}

TEST(Descriptions, AreKnownByTheirContent) {
  const auto hash = [](const std::string& members) { return machine_from(heir(members)).hash; };
  EXPECT_EQ(hash(""), hash(""));
  EXPECT_NE(hash(""), hash(R"(, "lanes": 4)"));
  EXPECT_NE(machine_from(heir("")).hash, machine_of("", "avx2").hash);
}

TEST(Descriptions, TellUnknownFromAbsent) {
  const MachineDescription mine = machine_from(heir(R"(, "instructions": {"add": "unknown"})"));
  EXPECT_FALSE(mine.find("add", "arithmetic")->known);
  SequenceTrials trials;
  Prices prices(mine, 8, trials);
  EXPECT_EQ(prices.of("add", "arithmetic").missing, std::set<std::string>{"add"});
  EXPECT_EQ(prices.of("prefix_sum", "scan").missing, std::set<std::string>{"add"})
      << "a sequence that issues it";
  EXPECT_TRUE(prices.of("mul", "arithmetic").missing.empty());
}

TEST(Descriptions, AreRefusedWithTheInstructionsThatTheyLack) {
  const std::string message = refusal(
      R"({"name": "m", "summary": "m", "lanes": 4, "classes": {
            "arithmetic": {"slots": {"every_group": 1}, "source": "assumed"},
            "integer": {"slots": {"every_group": 1}, "source": "assumed"},
            "compare": {"slots": {"every_group": 1}, "source": "assumed"},
            "convert": {"slots": {"every_group": 1}, "source": "assumed"},
            "move": {"slots": {"every_group": 1}, "source": "assumed"},
            "mask": {"slots": {"every_group": 1}, "source": "assumed"},
            "memory": {"slots": {"every_group": 1}, "source": "assumed"},
            "scan": {"slots": {"every_group": 1}, "source": "assumed"}}})");
  EXPECT_EQ(message,
            "m.json: has no figure for hmax, hmin, hadd, hand and hor; give each one, or one for "
            "its class");
}

struct Refused {
  std::string members;
  std::string message;
};

TEST(Descriptions, AreRefusedWhereTheyAreWrong) {
  const std::vector<Refused> all{
      {R"(, "lane": 4)", "m.json:/: unknown member 'lane'; did you mean 'lanes'?"},
      {R"(, "lanes": 12)", "m.json:/lanes: 12 is not 1, 2, 4, 8, 16, 32, 64 or \"width\""},
      {R"(, "instructions": {"prefix_sums": "unknown"})",
       "m.json:/instructions/prefix_sums: 'prefix_sums' is not an instruction of the set; did you "
       "mean 'prefix_sum'?"},
      {R"(, "classes": {"arithmetics": "unknown"})",
       "m.json:/classes/arithmetics: 'arithmetics' is not a class; did you mean 'arithmetic'?"},
      {R"(, "own": {"add": "unknown"})",
       "m.json:/own/add: is of the instruction set: it belongs into instructions"},
      {R"(, "instructions": {"add": {"slots": {"every_grup": 1}, "source": "assumed"}})",
       "m.json:/instructions/add/slots: unknown member 'every_grup'; did you mean 'every_group'?"},
      {R"(, "instructions": {"add": {"slots": {"lane": -1}, "source": "assumed"}})",
       "m.json:/instructions/add/slots/lane: -1 is not a number of at least 0"},
      {R"(, "instructions": {"add": {"slots": {"lane": 1}}})",
       "m.json:/instructions/add: the member 'source' is missing"},
      {R"(, "instructions": {"add": {"slots": {"lane": 1}, "source": "lvm"}})",
       "m.json:/instructions/add/source: 'lvm' is not one of the sources: assumed or llvm; did you "
       "mean 'llvm'?"},
      {R"(, "instructions": {"add": {}})",
       "m.json:/instructions/add: has neither slots nor a sequence"},
      {R"(, "instructions": {"hmax": {"sequence": "hmax_by_shuffle"}})",
       "m.json:/instructions/hmax/sequence: 'hmax_by_shuffle' is not a sequence; did you mean "
       "'hmax_by_shuffles'?"},
      {R"(, "instructions": {"hmax": {"sequence": "hmin_by_shuffles"}})",
       "m.json:/instructions/hmax/sequence: hmin_by_shuffles does not replace hmax, but hmin"},
      {R"(, "sources": {"assumed": "so"})",
       "m.json:/sources/assumed: needs no text: it is what has no source"},
      {R"(, "classes": {"memory": {"sequence": "update_by_lanes"}}, "instructions": {"load": "unknown"})",
       "accepted"},
      {R"(, "name": "again")", "m.json: an object has the member 'name' twice"}};
  for (const Refused& each : all) EXPECT_EQ(refusal(heir(each.members)), each.message);
}

TEST(Descriptions, AreRefusedIfASequenceNeedsItself) {
  EXPECT_EQ(refusal(R"({"name": "m", "summary": "m", "lanes": 4, "classes": {
            "arithmetic": {"slots": {"every_group": 1}, "source": "assumed"},
            "integer": {"slots": {"every_group": 1}, "source": "assumed"},
            "compare": {"slots": {"every_group": 1}, "source": "assumed"},
            "convert": {"slots": {"every_group": 1}, "source": "assumed"},
            "move": {"slots": {"every_group": 1}, "source": "assumed"},
            "mask": {"slots": {"every_group": 1}, "source": "assumed"},
            "memory": {"sequence": "update_by_lanes"},
            "reduce": {"slots": {"every_group": 1}, "source": "assumed"},
            "scan": {"slots": {"every_group": 1}, "source": "assumed"}}})"),
            "m.json: the sequence of load issues load itself");
}

TEST(Descriptions, InheritFromMachinesOfTheProgram) {
  EXPECT_EQ(refusal(R"({"name": "m", "summary": "m", "inherits": "avx3"})").substr(0, 46),
            "m.json:/inherits: 'avx3' is not a machine; use");
  EXPECT_EQ(refusal(R"({"name": "m", "summary": "m"})"), "m.json:/: the member 'lanes' is missing");
}

TEST(MachineOf, TakesANameOrAFile) {
  EXPECT_EQ(machine_of("--machine", "avx2").lanes, 8);
  const testing::ScratchDirectory directory;
  const std::string file = directory / "mine.json";
  write_file(file, heir(""));
  EXPECT_EQ(machine_of("--machine", file).name, "mine");
  EXPECT_THROW(machine_of("--machine", directory / "none.json"), InputError);
  try {
    machine_of("--machine", "avx");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'avx2'?"), std::string::npos)
        << error.what();
  }
}

TEST(MachinePrices, SayWhatAnInstructionTakesOnEveryMachine) {
  const std::string text = machine_prices(isa::Hmax::kInfo);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  for (const MachineDescription& machine : shipped_machines())
    EXPECT_NE(text.find(machine.name), std::string::npos) << machine.name << text;
  EXPECT_NE(text.find("`hmax_by_shuffles` on larrabee, "), std::string::npos) << text;
  EXPECT_EQ(text.find("- On [machines](machines.md): 1 instruction on thesis; "), 0u) << text;
}

}  // namespace
}  // namespace lanescope
