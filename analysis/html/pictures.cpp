// SPDX-License-Identifier: MIT
#include "analysis/html/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "analysis/base/files.h"
#include "analysis/html/markup.h"
#include "analysis/pictures/image.h"

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

/// The command that draws a picture that is missing.
std::string command_for(const Picture& picture) {
  const Configuration& c = picture.configuration;
  const std::string scene = c.is_mesh() ? fmt::format("--mesh {} --patches {}", c.scene,
                                                      name_of(kMeshPatches, *c.mesh_patches))
                                        : fmt::format("--scene {} --frame {}", c.scene, c.frame);
  return fmt::format("lanescope render {} --resolution {}x{} -o {}", scene, c.tessellation.width_px,
                     c.tessellation.height_px, picture.path);
}

std::string picture_html(const Picture& picture, const std::string& file) {
  const std::string scene = html_escaped(picture.configuration.scene);
  if (file.empty())
    return fmt::format(
        "<p class=\"note\">There is no picture of {}; this draws it: <code>{}</code></p>\n", scene,
        html_escaped(command_for(picture)));
  return fmt::format(
      "<figure class=\"frame\"><img alt=\"The scene {0}, frame {1}\" "
      "src=\"data:image/png;base64,{2}\"><figcaption>{0}, frame {1}</figcaption></figure>\n",
      scene, picture.configuration.frame, file);
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
