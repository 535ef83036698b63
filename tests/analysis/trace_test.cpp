// SPDX-License-Identifier: MIT
#include "analysis/trace/trace.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

#include "analysis/experiment/experiment.h"
#include "analysis/pictures/palette.h"
#include "analysis/trace/chrome_trace.h"
#include "analysis/trace/lane_strip_picture.h"
#include "analysis/trace/listing.h"
#include "simulator/base/error.h"
#include "tests/analysis/configured.h"
#include "tests/analysis/test_kind.h"

namespace lanescope {
namespace {

/// A teapot so small that all of it can be traced; packets of three batches.
Configuration small(const std::string& kernel) {
  return testing::configured({{"kernel", kernel},
                              {"scene", "teapot"},
                              {"width_lanes", 8u},
                              {"width_px", 24u},
                              {"height_px", 15u},
                              {"packet_capacity", 20u}});
}

struct Event {
  std::size_t stage;
  std::uint64_t active;
  std::uint64_t charged;
  std::string mnemonic;
  bool operator==(const Event&) const = default;
};

class Recorder final : public TraceSink {
 public:
  void begin(const Configuration&, const Kernel&) override {}
  void batch(std::uint64_t number) override { batches.push_back(number); }
  void issued(const IssueEvent& event) override {
    events.push_back(
        {event.stage, event.active, event.charged(), std::string(event.info.mnemonic)});
  }
  void end() override {}

  std::vector<std::uint64_t> batches;
  std::vector<Event> events;
};

void trace_into(std::vector<TraceSink*> sinks, const Configuration& configuration,
                const TraceWindow& window) {
  trace(configuration, window, sinks, [](double) {});
}

Recorder record(const Configuration& configuration, const TraceWindow& window) {
  Recorder recorder;
  trace_into({&recorder}, configuration, window);
  return recorder;
}

std::vector<std::uint64_t> numbers(std::uint64_t first, std::uint64_t end) {
  std::vector<std::uint64_t> all(end - first);
  std::iota(all.begin(), all.end(), first);
  return all;
}

class Trace : public ::testing::TestWithParam<std::string> {};

TEST_P(Trace, ShowsWhatACountingMachineCounts) {
  const Configuration c = small(GetParam());
  const Recorder all = record(c, {});
  const Report report = run_experiment({c}, {});
  const auto& stages = report.runs.front().stages;
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    InstructionRecord seen;
    std::vector<std::uint64_t> by_lane(8);
    for (const Event& event : all.events) {
      if (event.stage != stage) continue;
      ++seen.issued;
      seen.active += event.charged;
      for (std::size_t lane = 0; lane < 8; ++lane) by_lane[lane] += event.active >> lane & 1;
    }
    EXPECT_EQ(seen.issued, stages[stage].total().issued);
    EXPECT_EQ(seen.active, stages[stage].total().active);
    EXPECT_EQ(by_lane, stages[stage].lane_active);
  }
}

TEST_P(Trace, WindowsFitTogether) {
  for (const bool cull : {true, false}) {
    Configuration c = small(GetParam());
    set_value(c, "cull_backfaces", cull);
    Recorder joined = record(c, {{}, 0, 4});  // Ends within the second packet of three batches.
    const Recorder second = record(c, {{}, 4, 11});
    const Recorder whole = record(c, {{}, 0, 11});
    EXPECT_EQ(joined.batches, numbers(0, 4));
    EXPECT_EQ(second.batches, numbers(4, 11));
    EXPECT_EQ(whole.batches, numbers(0, 11));
    joined.events.insert(joined.events.end(), second.events.begin(), second.events.end());
    EXPECT_EQ(joined.events, whole.events);
  }
}

TEST_P(Trace, ARegionHasItsOwnBatches) {
  const Configuration c = small(GetParam());
  const std::size_t all = record(c, {}).batches.size();
  const Recorder region = record(c, {Region{8, 4, 6, 6}});
  EXPECT_EQ(region.batches, numbers(0, region.batches.size()));
  EXPECT_GT(region.batches.size(), 2u);
  EXPECT_LT(region.batches.size(), all);
  EXPECT_EQ(record(c, {Region{8, 4, 6, 6}, 1, 2}).batches, numbers(1, 2));
}

TEST_P(Trace, WindowsOutsideAreRefused) {
  Configuration c = small(GetParam());
  EXPECT_THROW(record(c, {{}, 0, 1000000}), InputError);
  EXPECT_THROW(record(c, {{}, 1000000, 1000001}), InputError);
  EXPECT_THROW(record(c, {Region{20, 0, 5, 1}}), InputError);
  EXPECT_THROW(record(c, {Region{20, 14, 1, 2}}), InputError);
  c.scene = "tigerjump";  // Has sky in its corner.
  set_value(c, "width_px", std::uint64_t{96});
  set_value(c, "height_px", std::uint64_t{60});
  EXPECT_THROW(record(c, {Region{0, 0, 1, 1}}), InputError);
}

INSTANTIATE_TEST_SUITE_P(Kernels, Trace, ::testing::Values("lockstep", "repack"),
                         [](const auto& info) { return info.param; });

/// Both orders: what comes before the window is run, and not shown.
class TraceOfNumbers : public ::testing::TestWithParam<std::string> {
 protected:
  /// Pieces of 10 numbers: of three batches, the last of which has two.
  Configuration configuration() const {
    return testing::configured({{"kernel", GetParam()}, {"width_lanes", 4u}});
  }
};

TEST_P(TraceOfNumbers, WindowsFitTogether) {
  const Recorder whole = record(configuration(), {});
  EXPECT_EQ(whole.batches, numbers(0, 36));
  Recorder joined = record(configuration(), {{}, 0, 7});
  const Recorder second = record(configuration(), {{}, 7, 36});
  EXPECT_EQ(joined.batches, numbers(0, 7));
  EXPECT_EQ(second.batches, numbers(7, 36));
  EXPECT_GT(second.events.size(), 0u);
  joined.events.insert(joined.events.end(), second.events.begin(), second.events.end());
  EXPECT_EQ(joined.events, whole.events);
}

TEST_P(TraceOfNumbers, AKindWithoutRegionsHasNone) {
  try {
    record(configuration(), {Region{0, 0, 1, 1}});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--region: numbers have no regions; leave it out");
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, TraceOfNumbers, ::testing::Values("sum", "running_sum"),
                         [](const auto& info) { return info.param; });

TEST(Trace, OfTheReferenceIsRefused) {
  EXPECT_THROW(record(testing::configured({{"kernel", "rastmp"}, {"width_lanes", 1u}}), {}),
               InputError);
}

constexpr InstructionInfo kAdd{"add", "a + b", InstructionClass::kArithmetic};

IssueEvent event_of(std::size_t stage, std::uint64_t active) {
  return {kAdd, stage, 8, active, false, std::source_location::current(), {}};
}

TEST(LaneStrip, ColumnsMergeAndSumsStay) {
  const Kernel& kernel = find_kernel("lockstep");
  LaneStrip fine(small("lockstep"), kernel);
  LaneStrip coarse(small("lockstep"), kernel, 4);
  for (std::uint64_t i = 0; i < 19; ++i) {
    fine.issued(event_of(i % 4, i * 11 & 0xff));
    coarse.issued(event_of(i % 4, i * 11 & 0xff));
  }
  EXPECT_EQ(fine.scale(), 0);
  EXPECT_EQ(fine.columns(), 19u);
  EXPECT_EQ(coarse.scale(), 3);  // Columns of 8: 8 + 8 + 3.
  EXPECT_EQ(coarse.columns(), 3u);
  fine.coarsen(3);
  ASSERT_EQ(fine.columns(), 3u);
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t stage = 0; stage < 4; ++stage) {
      std::uint32_t issued = 0;
      std::array<std::uint32_t, 8> active{};
      for (std::uint64_t i = 8 * column; i < std::min<std::uint64_t>(19, 8 * column + 8); ++i) {
        if (i % 4 != stage) continue;
        ++issued;
        for (std::size_t lane = 0; lane < 8; ++lane) active[lane] += i * 11 >> lane & 1;
      }
      EXPECT_EQ(coarse.issued(column, stage), issued);
      EXPECT_EQ(fine.issued(column, stage), issued);
      for (int lane = 0; lane < 8; ++lane) {
        EXPECT_EQ(coarse.active(column, stage, lane), active[static_cast<std::size_t>(lane)]);
        EXPECT_EQ(fine.active(column, stage, lane), active[static_cast<std::size_t>(lane)]);
      }
    }
  EXPECT_EQ(coarse.total().issued, 19u);
  EXPECT_EQ(coarse.total().charged, fine.total().charged);
}

TEST(LaneStrip, ColoursAreThoseOfStagesAndTheirMeans) {
  LaneStrip strip(small("lockstep"), find_kernel("lockstep"));
  strip.issued(event_of(2, 0b001));
  strip.issued(event_of(2, 0b101));
  EXPECT_EQ(lane_colour(strip, 0, 0), stage_colour("Test"));
  EXPECT_EQ(lane_colour(strip, 0, 1), kLaneOff);
  strip.coarsen(1);
  EXPECT_EQ(lane_colour(strip, 0, 0), stage_colour("Test"));
  EXPECT_EQ(lane_colour(strip, 0, 1), kLaneOff);
  EXPECT_EQ(lane_colour(strip, 0, 2), mixed(kLaneOff, stage_colour("Test"), 0.5));
}

std::map<Colour, std::uint64_t> pixels_by_colour(const std::string& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0);
  header.format = PNG_FORMAT_RGB;
  std::vector<Colour> pixels(std::size_t{header.width} * header.height);
  EXPECT_NE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr), 0);
  std::map<Colour, std::uint64_t> count;
  for (const Colour& pixel : pixels) ++count[pixel];
  return count;
}

TEST(LaneStripPicture, HasOnePatchOfColourForEachBusyLane) {
  LaneStrips strips;
  const Kernel& kernel = find_kernel("lockstep");
  strips.begin(small("lockstep"), kernel);
  strips.batch(0);
  for (int i = 0; i < 32; ++i) strips.issued(event_of(2, 0b11));
  for (int i = 0; i < 32; ++i) strips.issued(event_of(3, 0b111));
  const auto count =
      pixels_by_colour(lane_strip_picture(strips.at_one_scale(), PictureFormat::kPng));
  // 64 columns of 32 pixels, lanes of 16; and a square of 14 pixels in the legend.
  constexpr std::uint64_t kPatch = 32 * 16, kLegend = 14 * 14;
  EXPECT_EQ(count.at(stage_colour("Test")), 32 * 2 * kPatch + kLegend);
  EXPECT_EQ(count.at(stage_colour("Process")), 32 * 3 * kPatch + kLegend);
  EXPECT_EQ(count.at(kLaneOff), (64 * 8 - 32 * 5) * kPatch + kLegend);
  EXPECT_EQ(count.at(stage_colour("Bound")), kLegend);
}

/// Whether every element that begins ends, and in the right order.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != xml.npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == xml.npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag.front() == '?' || tag.front() == '!' || tag.back() == '/') continue;
    if (tag.front() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    } else {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

TEST(LaneStripPicture, IsAlsoAnSvg) {
  LaneStrips strips;
  trace_into({&strips}, small("lockstep"), {{}, 4, 8});
  trace_into({&strips}, small("repack"), {{}, 4, 8});
  const std::string svg = lane_strip_picture(strips.at_one_scale(), PictureFormat::kSvg);
  EXPECT_NE(svg.find("<svg "), svg.npos);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_FALSE(is_well_formed(svg.substr(0, svg.size() / 2)));
  EXPECT_TRUE(svg == lane_strip_picture(strips.at_one_scale(), PictureFormat::kSvg));
}

TEST(ChromeTrace, SlicesTileTheTime) {
  std::string text;
  ChromeTrace chrome([&](std::string_view piece) { text += piece; });
  std::vector<Recorder> recorders(2);
  trace_into({&chrome, &recorders[0]}, small("lockstep"), {{}, 4, 8});
  trace_into({&chrome, &recorders[1]}, small("repack"), {{}, 4, 8});
  chrome.finish();
  const auto json = nlohmann::json::parse(text);
  struct Sums {
    std::uint64_t now = 0, active = 0, batches = 0;
  };
  std::map<int, Sums> processes;
  for (const auto& event : json["traceEvents"]) {
    Sums& sums = processes[event["pid"]];
    if (event["ph"] == "i") ++sums.batches;
    if (event["ph"] != "X") continue;
    EXPECT_EQ(event["ts"], sums.now);
    EXPECT_EQ(event["dur"], event["args"]["issued"]);
    sums.now += event["dur"].get<std::uint64_t>();
    sums.active += event["args"]["active"].get<std::uint64_t>();
  }
  ASSERT_EQ(processes.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Sums& sums = processes[static_cast<int>(i) + 1];
    std::uint64_t active = 0;
    for (const Event& event : recorders[i].events) active += event.charged;
    EXPECT_EQ(sums.now, recorders[i].events.size());
    EXPECT_EQ(sums.active, active);
    EXPECT_EQ(sums.batches, 4u);
  }
}

TEST(Listing, HasALineForEachInstruction) {
  std::string text;
  Listing listing([&](std::string_view piece) { text += piece; });
  Recorder recorder;
  trace_into({&listing, &recorder}, small("repack"), {{}, 4, 8});
  std::istringstream lines(text);
  std::size_t number = 0;
  std::vector<std::uint64_t> batches;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# batch ")) batches.push_back(std::stoull(line.substr(8)));
    if (line.front() == '#') continue;
    std::size_t stated = 0;
    std::string lanes;
    std::istringstream(line) >> stated >> lanes;
    ASSERT_LT(number, recorder.events.size());
    const Event& event = recorder.events[number];
    EXPECT_EQ(stated, number++);
    EXPECT_EQ(lanes, lanes_text(event.active, 8));
    EXPECT_NE(line.find(find_kernel("repack").stages[event.stage]), line.npos) << line;
    EXPECT_NE(line.find(" " + event.mnemonic + " "), line.npos) << line;
    EXPECT_NE(line.find(" kernels/"), line.npos) << line;
  }
  EXPECT_EQ(number, recorder.events.size());
  EXPECT_EQ(batches, numbers(4, 8));
}

TEST(Listing, ShowsLane0First) { EXPECT_EQ(lanes_text(0b10011, 8), "**__*___"); }

}  // namespace
}  // namespace lanescope
