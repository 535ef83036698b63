// SPDX-License-Identifier: MIT
// The frames: pictures of the scenes, made small enough to be part of the page.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// A figure for each scene, from the file picture_name() of the directory. Where it is missing, the
/// command that draws it. Pictures are made narrower until all of them together have less than 1.5
/// MB. Throws InputError if a file is there and is no PNG file.
std::string pictures_html(const std::vector<NamedReport>& sources, const std::string& directory);

}  // namespace lanescope
