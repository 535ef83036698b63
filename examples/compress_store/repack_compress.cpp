// SPDX-License-Identifier: MIT
#include "repack_compress.h"

#include "examples/compress_store/starters.h"
#include "kernels/micropolygons/descriptors.h"

namespace lanescope {

constexpr const InstructionInfo* kInstructions[] = {&FrameMerge::kInfo, &CompressStore::kInfo,
                                                    &ExpandLoad::kInfo};

extern const Kernel k_repack_compress;
const Kernel k_repack_compress =
    repack_kernel("repack_compress", "REPACK with compress_store and expand_load",
                  start_repack_compress, kInstructions);

}  // namespace lanescope
