// SPDX-License-Identifier: MIT
#include "repack_records.h"

#include "examples/scatter_record/starters.h"
#include "kernels/micropolygons/descriptors.h"

namespace lanescope {

constexpr const InstructionInfo* kInstructions[] = {&FrameMerge::kInfo, &ScatterRecord::kInfo,
                                                    &LoadRecord::kInfo};

extern const Kernel k_repack_records;
const Kernel k_repack_records =
    repack_kernel("repack_records", "REPACK whose hits carry their edge values",
                  start_repack_records, kInstructions);

}  // namespace lanescope
