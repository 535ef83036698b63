// SPDX-License-Identifier: MIT
// Memory that this process can have.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lanescope {

/// What a message says when memory could not be had after all.
inline constexpr std::string_view kOutOfMemory =
    "memory: there is not enough; ask for smaller outputs (frames), or run fewer at a time";

/// The memory that can be had beside what the process has: what the host has available, within the
/// limits of the process (RLIMIT_AS, RLIMIT_DATA) and of its control groups. As much as there can
/// be where nothing tells.
std::uint64_t available_memory_bytes();

/// Throws InputError if outputs that take so much together cannot be had.
void require_memory(std::uint64_t output_bytes);

/// `2.1 GB`, `24 MB`.
std::string memory_text(std::uint64_t bytes);

}  // namespace lanescope
