// SPDX-License-Identifier: MIT
#include "analysis/html/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "analysis/base/files.h"
#include "analysis/configuration/special_options.h"
#include "analysis/html/markup.h"
#include "analysis/pictures/image.h"
#include "analysis/pictures/picture_title.h"

namespace lanescope {
namespace {

constexpr std::size_t kMostBytes = 1'500'000;
constexpr std::array<int, 4> kWidthsPx{640, 480, 320, 160};

struct Picture {
  Configuration configuration;
  std::string path;
  Image image;  ///< Without pixels if there is no such file.
};

std::vector<Picture> read_pictures(const std::vector<NamedReport>& sources,
                                   const std::string& directory) {
  std::vector<Picture> pictures;
  for (const NamedReport& source : sources)
    for (const RunRecord& run : source.report.runs) {
      const Configuration& c = run.configuration;
      if (std::any_of(pictures.begin(), pictures.end(),
                      [&](const Picture& p) { return p.configuration.scene == c.scene; }))
        continue;
      const std::string path = directory + '/' + picture_name(c);
      const bool is_there = std::filesystem::exists(path);
      pictures.push_back({c, path, is_there ? read_png(read_file(path), path) : Image{}});
    }
  return pictures;
}

/// The files at the widest width at which they are small enough, or at the narrowest.
std::vector<std::string> small_files(const std::vector<Picture>& pictures) {
  std::vector<std::string> files;
  for (const int width_px : kWidthsPx) {
    files.clear();
    std::size_t bytes = 0;
    for (const Picture& picture : pictures) {
      files.push_back(
          picture.image.pixels.empty() ? "" : base64(png(narrowed(picture.image, width_px))));
      bytes += files.back().size();
    }
    if (bytes < kMostBytes) break;
  }
  return files;
}

std::string picture_html(const Picture& picture, const std::string& file) {
  const std::string caption = html_escaped(scene_title(picture.configuration));
  if (file.empty())
    return fmt::format(
        "<p class=\"note\">There is no picture of {}; this draws it: <code>{}</code></p>\n",
        caption, html_escaped(picture_command(picture.configuration, picture.path)));
  return fmt::format(
      "<figure class=\"frame\"><img alt=\"The scene {0}\" "
      "src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
      caption, file);
}

}  // namespace

std::string pictures_html(const std::vector<NamedReport>& sources, const std::string& directory) {
  const std::vector<Picture> pictures = read_pictures(sources, directory);
  const std::vector<std::string> files = small_files(pictures);
  std::string text = "<div class=\"frames\">\n";
  for (std::size_t i = 0; i < pictures.size(); ++i) text += picture_html(pictures[i], files[i]);
  return text + "</div>\n";
}

}  // namespace lanescope
