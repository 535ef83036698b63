// SPDX-License-Identifier: MIT
#include "analysis/trace/lane_strip_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>

#include "analysis/pictures/palette.h"
#include "analysis/pictures/picture_title.h"

namespace lanescope {
namespace {

// In pixels.
constexpr int kMaxPlotWidth = 2048, kMinPlotWidth = 1024;
constexpr int kLeft = 76, kRight = 28, kTop = 44, kBottom = 58;
constexpr int kPanelHead = 66;  ///< Title, legend and batches above a strip.
constexpr int kPanelGap = 30;
constexpr int kStripHeight = 192;  ///< Of wide machines; narrow ones have lanes of kLaneHeight.
constexpr int kLaneHeight = 16;
constexpr int kBatchSpacing = 40;  ///< Marks of batches are not drawn closer than this.
constexpr int kTickSpacing = 150;
constexpr TextStyle kTitle{22.0, kInk, true};
constexpr TextStyle kText{17.0, kInk};
constexpr TextStyle kNote{17.0, kFaintInk};

TextStyle aligned(TextStyle style, Align align) {
  style.align = align;
  return style;
}

/// A count with its thousands set apart.
std::string grouped(std::uint64_t count) {
  std::string text = fmt::format("{}", count);
  for (int place = static_cast<int>(text.size()) - 3; place > 0; place -= 3)
    text.insert(static_cast<std::size_t>(place), ",");
  return text;
}

std::string upper(std::string_view text) {
  std::string result;
  for (const char c : text)
    result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string percent(const LaneSums& sums, int width) {
  if (sums.issued == 0) return "n/a";
  return fmt::format("{:.1f}%", 100.0 * static_cast<double>(sums.charged) /
                                    (static_cast<double>(sums.issued) * width));
}

/// 1, 2 or 5 times a power of ten, no less than `least`.
std::uint64_t round_step(double least) {
  for (std::uint64_t power = 1;; power *= 10)
    for (const std::uint64_t step : {power, 2 * power, 5 * power})
      if (static_cast<double>(step) >= least) return step;
}

class Picture {
 public:
  Picture(const std::vector<LaneStrip>& strips, PictureFormat format) : strips_(strips) {
    for (const LaneStrip& strip : strips) columns_ = std::max(columns_, strip.columns());
    const int columns = std::max(1, static_cast<int>(columns_));
    column_px_ = std::max(1, kMaxPlotWidth / columns);
    plot_width_ = std::max(kMinPlotWidth, columns * column_px_);
    int height = kTop + kBottom - kPanelGap;
    for (const LaneStrip& strip : strips) height += panel_height(strip);
    canvas_ = make_canvas(format, kLeft + plot_width_ + kRight, height);
  }

  std::string draw() {
    heading();
    int y = kTop;
    for (const LaneStrip& strip : strips_) {
      panel(strip, y);
      y += panel_height(strip);
    }
    axis(y - kPanelGap);
    return canvas_->finish();
  }

 private:
  static int lane_height(const LaneStrip& strip) {
    return std::clamp(kStripHeight / strip.width(), 1, kLaneHeight);
  }
  static int strip_height(const LaneStrip& strip) { return lane_height(strip) * strip.width(); }
  static int panel_height(const LaneStrip& strip) {
    return kPanelHead + strip_height(strip) + kPanelGap;
  }

  /// Where an instruction begins.
  double x_of(std::uint64_t instruction) const {
    const auto per_column = static_cast<double>(std::uint64_t{1} << strips_.front().scale());
    return kLeft + static_cast<double>(instruction) / per_column * column_px_;
  }

  void heading() {
    const LaneStrip& strip = strips_.front();
    const std::size_t batches = strip.batch_starts().size();
    canvas_->text(kLeft, 28,
                  fmt::format("{}: batches {} to {} of {} {}; lanes down, instructions across",
                              picture_title(strip.configuration()), strip.first_batch(),
                              strip.first_batch() + (batches == 0 ? 0 : batches - 1), strip.width(),
                              strip.kernel().workload->name),
                  kNote);
  }

  void panel(const LaneStrip& strip, int y) {
    const LaneSums total = strip.total();
    canvas_->text(
        kLeft, y + 24,
        fmt::format("{}, W = {}: {} of the lanes busy, {} instructions", upper(strip.kernel().name),
                    strip.width(), percent(total, strip.width()), grouped(total.issued)),
        kTitle);
    legend(strip, y + 48);
    const int top = y + kPanelHead;
    batches(strip, top);
    lane_numbers(strip, top);
    lanes(strip, top);
  }

  /// Colours and utilizations of the stages.
  void legend(const LaneStrip& strip, int y) {
    double x = kLeft;
    const auto entry = [&](Colour colour, const std::string& words) {
      canvas_->fill(colour, {x, y - 13.0, 14, 14});
      x += 20 + canvas_->text(x + 20, y, words, kText) + 26;
    };
    for (std::size_t stage = 0; stage < strip.stages().size(); ++stage) {
      const std::string_view name = strip.kernel().stages[stage];
      entry(stage_colour(name),
            fmt::format("{} {}", name, percent(strip.stages()[stage], strip.width())));
    }
    entry(kLaneOff, "lane off");
  }

  /// Marks where batches begin, unless they are too many.
  void batches(const LaneStrip& strip, int top) {
    const auto& starts = strip.batch_starts();
    const double length = x_of(strip.total().issued) - kLeft;
    if (starts.empty() || length / static_cast<double>(starts.size()) < kBatchSpacing) return;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const double x = std::floor(x_of(starts[i]));
      canvas_->fill(kFaintInk, {x, top - 8.0, 2, 7});
    }
  }

  void lane_numbers(const LaneStrip& strip, int top) {
    const TextStyle style = aligned(kNote, Align::kRight);
    canvas_->text(kLeft - 8, top + 14, strip.width() > 1 ? "lane 0" : "lane", style);
    if (strip.width() > 1)
      canvas_->text(kLeft - 8, top + strip_height(strip) - 1, fmt::format("{}", strip.width() - 1),
                    style);
  }

  void lanes(const LaneStrip& strip, int top) {
    const int height = lane_height(strip);
    canvas_->fill(kLaneOff, {kLeft, static_cast<double>(top),
                             static_cast<double>(strip.columns()) * column_px_,
                             static_cast<double>(strip_height(strip))});
    // By colour: an SVG then has one path for each.
    std::map<Colour, std::vector<Rectangle>> fills;
    for (int lane = 0; lane < strip.width(); ++lane)
      for (std::size_t first = 0, next = 0; first < strip.columns(); first = next) {
        const Colour colour = lane_colour(strip, first, lane);
        for (next = first + 1; next < strip.columns(); ++next)
          if (lane_colour(strip, next, lane) != colour) break;
        if (colour == kLaneOff) continue;
        fills[colour].push_back({kLeft + static_cast<double>(first) * column_px_,
                                 static_cast<double>(top + lane * height),
                                 static_cast<double>(next - first) * column_px_,
                                 static_cast<double>(height)});
      }
    for (const auto& [colour, rectangles] : fills) canvas_->fill(colour, rectangles);
  }

  void axis(int y) {
    const int scale = strips_.front().scale();
    std::uint64_t last = 0;
    for (const LaneStrip& strip : strips_) last = std::max(last, strip.total().issued);
    canvas_->fill(kInk, {kLeft, y + 8.0, x_of(last) - kLeft, 1});
    const double per_px = static_cast<double>(std::uint64_t{1} << scale) / column_px_;
    const std::uint64_t step = round_step(kTickSpacing * per_px);
    for (std::uint64_t tick = 0; tick <= last; tick += step) {
      const double x = std::floor(x_of(tick));
      canvas_->fill(kInk, {x, y + 8.0, 1, 6});
      canvas_->text(x, y + 32, grouped(tick), aligned(kText, Align::kCentre));
    }
    std::string words = "instructions issued";
    if (scale > 0)
      words += fmt::format("; a column is the mean of {}", grouped(std::uint64_t{1} << scale));
    canvas_->text(kLeft + plot_width_, y + 56, words, aligned(kNote, Align::kRight));
  }

  const std::vector<LaneStrip>& strips_;
  std::size_t columns_ = 0;
  int column_px_;
  int plot_width_;
  std::unique_ptr<Canvas> canvas_;
};

}  // namespace

Colour lane_colour(const LaneStrip& strip, std::size_t column, int lane) {
  double issued = 0.0;
  double on = 0.0;
  std::array<double, 3> sum{};
  for (std::size_t stage = 0; stage < strip.stages().size(); ++stage) {
    issued += strip.issued(column, stage);
    const double active = strip.active(column, stage, lane);
    on += active;
    const Colour colour = stage_colour(strip.kernel().stages[stage]);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += active * colour[c];
  }
  Colour mean;
  for (std::size_t c = 0; c < 3; ++c)
    mean[c] =
        static_cast<std::uint8_t>(std::lround((sum[c] + (issued - on) * kLaneOff[c]) / issued));
  return mean;
}

std::string lane_strip_picture(const std::vector<LaneStrip>& strips, PictureFormat format) {
  return Picture(strips, format).draw();
}

}  // namespace lanescope
