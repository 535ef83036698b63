// SPDX-License-Identifier: MIT
#include "simulator/host.h"

namespace lanescope::host::inline LANESCOPE_HOST {

void require_same_host() {}

}  // namespace lanescope::host::inline LANESCOPE_HOST
