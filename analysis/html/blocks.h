// SPDX-License-Identifier: MIT
// The blocks of a section as HTML, once for all settings of the page, which shows one of them at a
// time.
#pragma once

#include <string>
#include <vector>

#include "analysis/html/section.h"

namespace lanescope {

/// The blocks of a section in each setting, of which `first` is shown at first. Blocks that are the
/// same in all settings stand there once; of others each different one is packed for page.js.
/// Charts have the id `<section_id>-<chart's id>`. Empty if no setting has a chart with rows or any
/// markup.
std::string blocks_html(const std::vector<std::vector<SectionBlock>>& by_setting, std::size_t first,
                        const std::string& section_id);

}  // namespace lanescope
