// SPDX-License-Identifier: MIT
#include "analysis/pictures/canvas.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <string_view>
#include <utility>

#include "analysis/pictures/palette.h"
#include "simulator/base/error.h"

#ifdef __SANITIZE_ADDRESS__
// Fontconfig keeps what it has read of fonts until the process ends.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace lanescope {
namespace {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using SurfacePointer = std::unique_ptr<cairo_surface_t, Destroy>;
using ContextPointer = std::unique_ptr<cairo_t, Destroy>;

/// Cairo's pixels are native words 0x..RRGGBB.
std::uint32_t to_word(Colour colour) {
  return std::uint32_t{colour[0]} << 16 | std::uint32_t{colour[1]} << 8 | colour[2];
}

Colour to_colour(std::uint32_t word) {
  return {static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 8),
          static_cast<std::uint8_t>(word)};
}

SurfacePointer empty_bitmap(int width_px, int height_px) {
  return SurfacePointer(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px));
}

std::uint32_t* row_of(cairo_surface_t* bitmap, int y) {
  return reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(bitmap) +
                                          std::ptrdiff_t{y} *
                                              cairo_image_surface_get_stride(bitmap));
}

SurfacePointer bitmap_of(const Image& image) {
  SurfacePointer bitmap = empty_bitmap(image.width_px, image.height_px);
  const Colour* pixel = image.pixels.data();
  for (int y = 0; y < image.height_px; ++y) {
    std::uint32_t* row = row_of(bitmap.get(), y);
    for (int x = 0; x < image.width_px; ++x) row[x] = to_word(*pixel++);
  }
  cairo_surface_mark_dirty(bitmap.get());
  return bitmap;
}

cairo_status_t append_to(void* text, const unsigned char* bytes, unsigned int size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

/// Takes out the number that Cairo gives a surface: it counts those of the process, and the same
/// drawing is to give the same bytes.
void remove_surface_number(std::string& svg) {
  constexpr std::string_view kBegin = " id=\"surface";
  const std::size_t begin = svg.find(kBegin);
  if (begin != svg.npos) svg.erase(begin, svg.find('"', begin + kBegin.size()) + 1 - begin);
}

}  // namespace

struct Canvas::Surface {
  void open(SurfacePointer made) {
    surface = std::move(made);
    context.reset(cairo_create(surface.get()));
  }

  void check() const {
    const cairo_status_t status = cairo_status(context.get());
    LANESCOPE_CHECK(status == CAIRO_STATUS_SUCCESS, "Cairo: {}", cairo_status_to_string(status));
  }

  void set_colour(Colour colour) {
    cairo_set_source_rgb(context.get(), colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
  }

  std::string written;  ///< By an SVG surface, to its very end.
  SurfacePointer surface;
  ContextPointer context;
};

Canvas::Canvas(std::unique_ptr<Surface> surface) : surface_(std::move(surface)) {
  surface_->set_colour(kPaper);
  cairo_paint(surface_->context.get());
}

Canvas::~Canvas() = default;

void Canvas::fill(Colour colour, std::span<const Rectangle> rectangles) {
  cairo_t* const context = surface_->context.get();
  surface_->set_colour(colour);
  for (const Rectangle& r : rectangles) cairo_rectangle(context, r.x, r.y, r.width, r.height);
  cairo_fill(context);
}

double Canvas::text(double x, double y, const std::string& text, const TextStyle& style) {
  cairo_t* const context = surface_->context.get();
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size_px);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  const double shift = style.align == Align::kLeft     ? 0.0
                       : style.align == Align::kCentre ? extents.x_advance / 2.0
                                                       : extents.x_advance;
  surface_->set_colour(style.colour);
  cairo_move_to(context, x - shift, y);
  cairo_show_text(context, text.c_str());
  return extents.x_advance;
}

void Canvas::image(double x, double y, const Image& image) {
  const SurfacePointer bitmap = bitmap_of(image);
  cairo_t* const context = surface_->context.get();
  cairo_set_source_surface(context, bitmap.get(), x, y);
  cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_NEAREST);
  cairo_paint(context);
}

/// Drawn into a bitmap, which our own encoder writes.
class PngCanvas final : public Canvas {
 public:
  PngCanvas(int width_px, int height_px) : Canvas(open(width_px, height_px)) {}

  std::string finish() override {
    surface().check();
    cairo_surface_t* const bitmap = surface().surface.get();
    cairo_surface_flush(bitmap);
    Image image{cairo_image_surface_get_width(bitmap), cairo_image_surface_get_height(bitmap), {}};
    for (int y = 0; y < image.height_px; ++y) {
      const std::uint32_t* row = row_of(bitmap, y);
      for (int x = 0; x < image.width_px; ++x) image.pixels.push_back(to_colour(row[x]));
    }
    return png(image);
  }

 private:
  static std::unique_ptr<Surface> open(int width_px, int height_px) {
    auto surface = std::make_unique<Surface>();
    surface->open(empty_bitmap(width_px, height_px));
    return surface;
  }
};

class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(int width_px, int height_px) : Canvas(open(width_px, height_px)) {}

  std::string finish() override {
    surface().check();
    cairo_surface_finish(surface().surface.get());
    remove_surface_number(surface().written);
    return std::move(surface().written);
  }

 private:
  static std::unique_ptr<Surface> open(int width_px, int height_px) {
    auto surface = std::make_unique<Surface>();
    surface->open(SurfacePointer(
        cairo_svg_surface_create_for_stream(append_to, &surface->written, width_px, height_px)));
    cairo_svg_surface_set_document_unit(surface->surface.get(), CAIRO_SVG_UNIT_PX);
    return surface;
  }
};

std::unique_ptr<Canvas> make_canvas(PictureFormat format, int width_px, int height_px) {
  if (format == PictureFormat::kPng) return std::make_unique<PngCanvas>(width_px, height_px);
  return std::make_unique<SvgCanvas>(width_px, height_px);
}

}  // namespace lanescope
