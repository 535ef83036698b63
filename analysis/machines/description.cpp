// SPDX-License-Identifier: MIT
#include "analysis/machines/description.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/base/files.h"
#include "analysis/base/json_cursor.h"
#include "analysis/base/printable.h"
#include "analysis/machines/price.h"
#include "analysis/machines/shipped_text.h"
#include "analysis/report/lane_groups.h"
#include "analysis/sweep/content_hash.h"

namespace lanescope {

/// Generated from simulator/machines/machine.schema.json.
extern const char* const kMachineJsonSchema;

namespace {

constexpr std::string_view kUnknown = "unknown";
constexpr std::string_view kAsWideAsTheRun = "width";

std::vector<std::string> all_mnemonics() {
  std::vector<std::string> names;
  for (const InstructionInfo* info : priced_instructions()) names.emplace_back(info->mnemonic);
  return names;
}

std::vector<std::string> all_classes() {
  std::vector<std::string> names;
  for (const InstructionClass each : kInstructionClasses) names.emplace_back(to_string(each));
  return names;
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Reads the members of one description over those that it inherits.
class DescriptionReader {
 public:
  DescriptionReader(const JsonCursor& cursor, MachineDescription inherited)
      : cursor_(cursor), machine_(std::move(inherited)) {}

  MachineDescription read() {
    machine_.name = read_words(cursor_.member("name"));
    machine_.summary = read_words(cursor_.member("summary"));
    if (cursor_.has_member("lanes")) read_lanes(cursor_.member("lanes"));
    if (cursor_.has_member("sources")) read_sources(cursor_.member("sources"));
    read_figures("classes", machine_.classes,
                 [this](const JsonCursor& at, const std::string& name) {
                   if (!contains(all_classes(), name))
                     fail_name(at, "a class", name, all_classes());
                 });
    read_figures("instructions", machine_.instructions,
                 [this](const JsonCursor& at, const std::string& name) {
                   if (!contains(all_mnemonics(), name))
                     fail_name(at, "an instruction of the set", name, all_mnemonics());
                 });
    read_figures("own", machine_.own, [](const JsonCursor& at, const std::string& name) {
      if (contains(all_mnemonics(), name))
        throw InputError(at.where(), "is of the instruction set: it belongs into instructions");
    });
    return std::move(machine_);
  }

 private:
  [[noreturn]] static void fail_name(const JsonCursor& at, std::string_view kind,
                                     const std::string& name,
                                     const std::vector<std::string>& names) {
    throw InputError(at.where(), "'{}' is not {}{}", name, kind, did_you_mean(name, names));
  }

  static std::string read_words(const JsonCursor& at) {
    std::string text = at.string();
    if (text.empty() || !is_printable(text)) at.fail("words without control characters");
    return text;
  }

  void read_lanes(const JsonCursor& at) {
    machine_.lanes.reset();
    if (at.value() == kAsWideAsTheRun) return;
    const bool is_one = at.value().is_number_unsigned() &&
                        std::find(kGroupLanes.begin(), kGroupLanes.end(), at.value().get<int>()) !=
                            kGroupLanes.end();
    if (!is_one)
      at.fail(fmt::format("{} or \"{}\"", fmt::join(kGroupLanes, ", "), kAsWideAsTheRun));
    machine_.lanes = at.value().get<int>();
  }

  void read_sources(const JsonCursor& at) {
    for (const std::string& name : at.member_names()) {
      if (name == kAssumed)
        throw InputError(at.member(name).where(), "needs no text: it is what has no source");
      machine_.sources[name] = at.member(name).string();
    }
  }

  template <class CheckName>
  void read_figures(std::string_view member, SlotFigures& figures, const CheckName& check) {
    if (!cursor_.has_member(member)) return;
    const JsonCursor all = cursor_.member(member);
    for (const std::string& name : all.member_names()) {
      const JsonCursor at = all.member(name);
      check(at, name);
      figures[name] = read_figure(at, name, member == "own");
    }
  }

  SlotFigure read_figure(const JsonCursor& at, const std::string& name, bool is_own) const {
    SlotFigure figure;
    figure.known = at.value() != kUnknown;
    if (!figure.known) return figure;
    at.allow_members({"slots", "sequence", "source"});
    if (at.has_member("slots")) figure.slots = read_slots(at.member("slots"));
    if (at.has_member("sequence"))
      figure.sequence = &read_sequence(at.member("sequence"), name, is_own);
    if (!at.has_member("slots") && !at.has_member("sequence"))
      throw InputError(at.where(), "has neither slots nor a sequence");
    if (at.has_member("slots") || at.has_member("source"))
      figure.source = read_source(at.member("source"));
    return figure;
  }

  static ByBasis read_slots(const JsonCursor& at) {
    ByBasis slots{};
    at.allow_members(names_of(kSlotBases));
    for (const std::string& name : at.member_names())
      lanescope::at(slots, *find_choice(kSlotBases, name)) = at.member(name).number_from_0();
    return slots;
  }

  static const SequenceInfo& read_sequence(const JsonCursor& at, const std::string& name,
                                           bool is_own) {
    const std::string wanted = at.string();
    const auto all = sequences();
    const auto found = std::find_if(all.begin(), all.end(), [&](const SequenceInfo& sequence) {
      return sequence.name == wanted;
    });
    if (found == all.end()) fail_name(at, "a sequence", wanted, names_of(all));
    const bool is_class = contains(all_classes(), name);
    if (found->replaces != (is_own || is_class ? std::string_view() : std::string_view(name)))
      throw InputError(
          at.where(), "{} does not replace {}, but {}", wanted, name,
          found->replaces.empty() ? "an instruction from outside the set" : found->replaces);
    return *found;
  }

  std::string read_source(const JsonCursor& at) const {
    const std::string name = at.string();
    if (name == kAssumed) return name;
    const auto found = machine_.sources.find(name);
    if (found != machine_.sources.end()) return found->second;
    std::vector<std::string> names{std::string(kAssumed)};
    for (const auto& [known, text] : machine_.sources) names.push_back(known);
    throw InputError(at.where(), "'{}' is not one of the sources: {}{}", name, list_or(names),
                     did_you_mean(name, names));
  }

  JsonCursor cursor_;
  MachineDescription machine_;
};

void require_all_instructions(const MachineDescription& machine, const std::string& file) {
  std::vector<std::string> missing;
  for (const InstructionInfo* info : priced_instructions())
    if (!machine.find(info->mnemonic, to_string(info->instruction_class)))
      missing.emplace_back(info->mnemonic);
  if (!missing.empty())
    throw InputError(file, "has no figure for {}; give each one, or one for its class",
                     list_and(missing));
}

MachineDescription inherited(const JsonCursor& cursor, const FindMachine& find,
                             const std::vector<std::string>& known) {
  if (!cursor.has_member("inherits")) {
    cursor.member("lanes");
    return {};
  }
  const JsonCursor at = cursor.member("inherits");
  const MachineDescription* const base = find(at.string());
  if (!base)
    throw InputError(at.where(), "'{}' is not a machine; use {}{}", at.string(), list_or(known),
                     did_you_mean(at.string(), known));
  return *base;
}

const MachineDescription* find_among(const std::vector<MachineDescription>& machines,
                                     std::string_view name) {
  const auto found = std::find_if(machines.begin(), machines.end(),
                                  [&](const auto& machine) { return machine.name == name; });
  return found == machines.end() ? nullptr : &*found;
}

std::vector<MachineDescription> read_shipped() {
  std::vector<MachineDescription> machines;
  machines.reserve(shipped_texts().size());
  for (const ShippedText& shipped : shipped_texts())
    machines.push_back(read_machine(
        shipped.text, shipped.file,
        [&](std::string_view name) { return find_among(machines, name); }, names_of(machines)));
  return machines;
}

}  // namespace

std::vector<const InstructionInfo*> priced_instructions() {
  std::vector<const InstructionInfo*> all(instruction_set().begin(), instruction_set().end());
  all.insert(all.end(), sequence_instructions().begin(), sequence_instructions().end());
  return all;
}

const SlotFigure* MachineDescription::find(std::string_view mnemonic,
                                           std::string_view instruction_class) const {
  for (const SlotFigures* figures : {&instructions, &own})
    if (const auto found = figures->find(mnemonic); found != figures->end()) return &found->second;
  const auto found = classes.find(instruction_class);
  return found == classes.end() ? nullptr : &found->second;
}

bool MachineDescription::names(std::string_view mnemonic) const {
  return instructions.contains(mnemonic) || own.contains(mnemonic);
}

MachineDescription read_machine(std::string_view text, const std::string& file,
                                const FindMachine& find, const std::vector<std::string>& known) {
  const auto json = parse_json(text, file);
  const JsonCursor cursor(json, file);
  cursor.allow_members(
      {"name", "summary", "inherits", "lanes", "sources", "classes", "instructions", "own"});
  MachineDescription base = inherited(cursor, find, known);
  const std::uint64_t hash = text_hash(fmt::format("{}\n{}", base.hash, text));
  MachineDescription machine = DescriptionReader(cursor, std::move(base)).read();
  machine.hash = hash;
  require_all_instructions(machine, file);
  if (const std::string cycle = sequence_that_needs_itself(machine); !cycle.empty())
    throw InputError(file, "the sequence of {} issues {} itself", cycle, cycle);
  return machine;
}

const std::vector<MachineDescription>& shipped_machines() {
  static const std::vector<MachineDescription> machines = read_shipped();
  return machines;
}

MachineDescription machine_of(std::string_view where, const std::string& name_or_file) {
  const auto& machines = shipped_machines();
  if (const MachineDescription* machine = find_among(machines, name_or_file)) return *machine;
  const std::vector<std::string> names = names_of(machines);
  if (name_or_file.find_first_of("./") == std::string::npos)
    throw InputError(where, "'{}' is not a machine, nor a file; use {}{}", name_or_file,
                     list_or(names), did_you_mean(name_or_file, names));
  return read_machine(
      read_file(name_or_file), printable(name_or_file),
      [&](std::string_view name) { return find_among(machines, name); }, names);
}

std::string machine_json_schema() { return kMachineJsonSchema; }

}  // namespace lanescope
