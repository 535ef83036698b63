// SPDX-License-Identifier: MIT
#include "analysis/pictures/picture_title.h"

#include <fmt/format.h>

#include <filesystem>

#include "analysis/configuration/special_options.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {

std::string picture_title(const Configuration& configuration) {
  const std::string facet = shown_facet({configuration.kernel, facet_of(configuration)});
  std::string title = configuration.scene + (facet.empty() ? "" : ", ") + facet;
  for (const NamedOption& option : special_options(configuration))
    if (option.of_source && option.parameter != facet_name(configuration.kernel))
      title += ", " + option.text();
  return title;
}

std::string picture_name(const Configuration& configuration) {
  return fmt::format("frame-{}.png", std::filesystem::path(configuration.scene).stem().string());
}

std::string picture_command(const Configuration& configuration, const std::string& path) {
  std::string command = "lanescope render --scene " + configuration.scene;
  for (const NamedOption& option : special_options(configuration))
    if (option.of_source) command += fmt::format(" --{} {}", option.option, option.value);
  return command + " -o " + path;
}

}  // namespace lanescope
