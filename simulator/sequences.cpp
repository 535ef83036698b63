// SPDX-License-Identifier: MIT
#include "simulator/sequences.h"

#include <algorithm>
#include <vector>

namespace lanescope {
namespace {

/// A machine that tells an observer what it issues, and operands for sequences.
struct Trial {
  using Vm = SlowMachine<64>;
  using Ints = Vec<std::int32_t, 64>;
  using Uints = Vec<std::uint32_t, 64>;
  using Floats = Vec<float, 64>;

  Trial(int width, std::uint64_t active, Observer& observer)
      : vm(width, 1, Mode::kTracing, &observer), on(Mask<64>::from_bits(active) & vm.all()) {}

  Memory<std::int32_t> memory() { return {words.data(), words.size(), "memory"}; }
  Memory<std::int32_t> other_memory() { return {others.data(), others.size(), "memory"}; }

  Vm vm;
  Vm::Site site = vm.site(0);
  Mask<64> on;
  Mask<64> selected = vm.all();
  Ints ints = sequence::constant<Vm>([](int i) { return i; });
  Uints uints{};
  Floats floats{};
  std::vector<std::int32_t> words = std::vector<std::int32_t>(256);
  std::vector<std::int32_t> others = std::vector<std::int32_t>(256);
};

using Run = void (*)(Trial&);

template <Run run>
void execute(int width, std::uint64_t active, Observer& observer) {
  Trial trial(width, active, observer);
  run(trial);
}

/// Of a reduction or scan of integers.
#define LANESCOPE_OF_INTS(name) \
  execute<[](Trial& t) { sequence::name##_by_shuffles(t.vm, t.site, t.on, t.ints); }>
/// Of an instruction on the bits of integers.
#define LANESCOPE_OF_BITS(name) \
  execute<[](Trial& t) { sequence::name(t.vm, t.site, t.on, t.uints); }>
/// Of a scatter that combines what it stores with what is there.
#define LANESCOPE_OF_UPDATE(combine)                                                    \
  execute<[](Trial& t) {                                                                \
    sequence::update_by_lanes(t.vm, t.site, t.on, t.memory(), t.ints, t.ints, combine); \
  }>

constexpr SequenceInfo kSequences[] = {
    {"clz_by_popcount", "clz", "sets all bits below the highest, and counts the others", false,
     LANESCOPE_OF_BITS(clz_by_popcount)},
    {"compress_by_scatter", "compress", "scatters each survivor to its rank, and loads", false,
     execute<[](Trial& t) {
       sequence::compress_by_scatter(t.vm, t.site, t.on, t.selected, t.ints, t.memory());
     }>},
    {"compress_by_table", "compress", "permutes eight lanes at a time as a table says", false,
     execute<[](Trial& t) {
       static constexpr auto kTable = sequence::compaction_table();
       sequence::compress_by_table(t.vm, t.site, t.on, t.selected, t.ints,
                                   read_only(kTable.data(), kTable.size(), "table"), t.memory(),
                                   t.other_memory());
     }>},
    {"conflict_by_shuffles", "conflict", "compares with each earlier lane, by distance", false,
     LANESCOPE_OF_INTS(conflict)},
    {"ctz_by_popcount", "ctz", "counts the bits that a subtraction of 1 sets", false,
     LANESCOPE_OF_BITS(ctz_by_popcount)},
    {"exclusive_scan_by_shuffles", "exclusive_scan", "log2 W steps of a shift and an add", false,
     LANESCOPE_OF_INTS(exclusive_scan)},
    {"expand_by_permute", "expand", "permutes by rank", false, execute<[](Trial& t) {
       sequence::expand_by_permute(t.vm, t.site, t.on, t.selected, t.ints);
     }>},
    {"fma_by_mul_add", "fma", "a product and a sum, each rounded", false, execute<[](Trial& t) {
       sequence::fma_by_mul_add(t.vm, t.site, t.on, t.floats, t.floats, t.floats);
     }>},
    {"gather_by_lanes", "gather", "an index and a load for each lane", true,
     execute<[](Trial& t) { sequence::gather_by_lanes(t.vm, t.site, t.on, t.memory(), t.ints); }>},
    {"gather_pair_by_gathers", "gather_pair", "a gather for each word", false,
     execute<[](Trial& t) {
       sequence::gather_pair_by_gathers(t.vm, t.site, t.on, t.memory(), t.ints);
     }>},
    {"hadd_by_shuffles", "hadd", "log2 W steps of a shuffle and an add", false,
     LANESCOPE_OF_INTS(hadd)},
    {"hand_by_shuffles", "hand", "log2 W steps of a shuffle and an and", false,
     LANESCOPE_OF_INTS(hand)},
    {"hmax_by_shuffles", "hmax", "log2 W steps of a shuffle and a maximum", false,
     LANESCOPE_OF_INTS(hmax)},
    {"hmin_by_shuffles", "hmin", "log2 W steps of a shuffle and a minimum", false,
     LANESCOPE_OF_INTS(hmin)},
    {"hor_by_shuffles", "hor", "log2 W steps of a shuffle and an or", false,
     LANESCOPE_OF_INTS(hor)},
    {"inclusive_scan_by_shuffles", "inclusive_scan", "log2 W steps of a shift and an add", false,
     LANESCOPE_OF_INTS(inclusive_scan)},
    {"load_pair_by_permutes", "load_pair", "two loads, each permuted twice, and two selects", false,
     execute<[](Trial& t) { sequence::load_pair_by_permutes(t.vm, t.site, t.on, t.memory(), 0); }>},
    {"popcount_by_bits", "popcount", "sums of 2, 4 and 8 bits, and a product", false,
     LANESCOPE_OF_BITS(popcount_by_bits)},
    {"prefix_sum_by_popcount", "prefix_sum", "counts the bits of the mask up to each lane", false,
     execute<[](Trial& t) { sequence::prefix_sum_by_popcount(t.vm, t.site, t.on, t.selected); }>},
    {"prefix_sum_by_shuffles", "prefix_sum", "log2 W steps of a shift and an add", false,
     execute<[](Trial& t) { sequence::prefix_sum_by_shuffles(t.vm, t.site, t.on, t.selected); }>},
    {"rcp_by_div", "rcp", "a division", false,
     execute<[](Trial& t) { sequence::rcp_by_div(t.vm, t.site, t.on, t.floats); }>},
    {"rotl_by_shifts", "rotl", "two shifts and an or", false,
     execute<[](Trial& t) { sequence::rotl_by_shifts(t.vm, t.site, t.on, t.uints, t.uints); }>},
    {"scatter_add_by_lanes", "scatter_add", "an index, a load, a sum and a store for each lane",
     true, LANESCOPE_OF_UPDATE(isa::add)},
    {"scatter_by_lanes", "scatter", "an index and a store for each lane", true,
     execute<[](Trial& t) {
       sequence::scatter_by_lanes(t.vm, t.site, t.on, t.memory(), t.ints, t.ints);
     }>},
    {"scatter_max_by_lanes", "scatter_max", "an index, a load, a maximum and a store for each lane",
     true, LANESCOPE_OF_UPDATE(isa::max)},
    {"scatter_min_by_lanes", "scatter_min", "an index, a load, a minimum and a store for each lane",
     true, LANESCOPE_OF_UPDATE(isa::min)},
    {"scatter_or_by_lanes", "scatter_or", "an index, a load, an or and a store for each lane", true,
     LANESCOPE_OF_UPDATE(isa::bit_or)},
    {"scatter_pair_by_scatters", "scatter_pair", "a scatter for each word", false,
     execute<[](Trial& t) {
       sequence::scatter_pair_by_scatters(t.vm, t.site, t.on, t.memory(), t.ints, t.ints, t.ints);
     }>},
    {"update_by_lanes", "", "an index, a load, a minimum and a store for each lane", true,
     LANESCOPE_OF_UPDATE(isa::min)},
};

}  // namespace

std::span<const SequenceInfo> sequences() { return kSequences; }

std::span<const InstructionInfo* const> sequence_instructions() {
  static constexpr const InstructionInfo* kInfos[] = {&isa::ExtractLane::kInfo,
                                                      &isa::MaskBits::kInfo, &isa::ShiftUp::kInfo};
  return kInfos;
}

}  // namespace lanescope
