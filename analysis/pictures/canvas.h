// SPDX-License-Identifier: MIT
// A sheet to draw on, which becomes a PNG or an SVG file: one drawing function serves both.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "analysis/pictures/image.h"

namespace lanescope {

/// In pixels from the upper left corner.
struct Rectangle {
  double x, y, width, height;
};

enum class Align { kLeft, kCentre, kRight };

struct TextStyle {
  double size_px = 13.0;
  Colour colour{};
  bool bold = false;
  Align align = Align::kLeft;
};

/// Coordinates are in pixels, y down. Edges of rectangles at whole numbers are sharp. Out of memory
/// ends in a CheckError.
class Canvas {
 public:
  virtual ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Fills rectangles that do not overlap.
  void fill(Colour colour, std::span<const Rectangle> rectangles);
  void fill(Colour colour, const Rectangle& rectangle) { fill(colour, {&rectangle, 1}); }
  /// Draws text on a base line at y and returns its width.
  double text(double x, double y, const std::string& text, const TextStyle& style);
  /// Draws a picture with its upper left corner at (x, y), one of its pixels on each pixel.
  void image(double x, double y, const Image& image);

  /// Ends the drawing and gives the contents of the file. Requires that it is called once.
  virtual std::string finish() = 0;

 protected:
  struct Surface;
  explicit Canvas(std::unique_ptr<Surface> surface);
  Surface& surface() { return *surface_; }

 private:
  std::unique_ptr<Surface> surface_;
};

enum class PictureFormat { kPng, kSvg };

/// An empty white sheet. Requires a positive size. Text in an SVG is drawn as outlines, so that it
/// needs no font where it is shown.
std::unique_ptr<Canvas> make_canvas(PictureFormat format, int width_px, int height_px);

}  // namespace lanescope
