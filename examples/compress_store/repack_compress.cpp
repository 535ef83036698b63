// SPDX-License-Identifier: MIT
#include "repack_compress.h"

#include "kernels/micropolygons/descriptors.h"
#include "starters.h"

namespace lanescope {

extern const Kernel k_repack_compress;
const Kernel k_repack_compress =
    repack_kernel("repack_compress", "REPACK with compress_store and expand_load",
                  most_width_of_repack_compress(), start_repack_compress);

}  // namespace lanescope
