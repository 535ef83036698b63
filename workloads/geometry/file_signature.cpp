// SPDX-License-Identifier: MIT
#include "workloads/geometry/file_signature.h"

#include <algorithm>
#include <array>

namespace lanescope {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  std::string_view what;
};

/// The longer of two that begin alike comes first.
constexpr Signature kSignatures[] = {
    {"\xff\xfe\0\0"sv, "is UTF-32 text; save it as UTF-8"},
    {"\0\0\xfe\xff"sv, "is UTF-32 text; save it as UTF-8"},
    {"\xff\xfe"sv, "is UTF-16 text; save it as UTF-8"},
    {"\xfe\xff"sv, "is UTF-16 text; save it as UTF-8"},
    {"\x1f\x8b"sv, "is compressed with gzip; unpack it with gunzip"},
    {"\x1f\x9d"sv, "is compressed; unpack it with uncompress"},
    {"BZh"sv, "is compressed with bzip2; unpack it with bunzip2"},
    {"\xfd"
     "7zXZ"sv,
     "is compressed with xz; unpack it with unxz"},
    {"\x28\xb5\x2f\xfd"sv, "is compressed with zstd; unpack it with unzstd"},
    {"\x04\x22\x4d\x18"sv, "is compressed with lz4; unpack it with unlz4"},
    {"PK\x03\x04"sv, "is a zip archive; unpack it with unzip"},
    {"7z\xbc\xaf\x27\x1c"sv, "is a 7z archive; unpack it with 7z"},
    {"Rar!"sv, "is a rar archive; unpack it with unrar"},
    {"ply\n"sv, "is a PLY file; convert it to Wavefront OBJ"},
    {"ply\r"sv, "is a PLY file; convert it to Wavefront OBJ"},
    {"solid "sv, "is an STL file; convert it to Wavefront OBJ"},
    {"OFF\n"sv, "is an OFF file; convert it to Wavefront OBJ"},
    {"glTF"sv, "is a glTF file; convert it to Wavefront OBJ"},
    {"Kaydara FBX"sv, "is an FBX file; convert it to Wavefront OBJ"},
    {"BLENDER"sv, "is a Blender file; export it as Wavefront OBJ"},
    {"version https://git-lfs"sv, "is a pointer of Git LFS; fetch the file with git lfs pull"},
    {"\x4c\x01"sv, "is an object file of a compiler; use a Wavefront OBJ file"},
    {"\x64\x86"sv, "is an object file of a compiler; use a Wavefront OBJ file"},
    {"\x7f"
     "ELF"sv,
     "is an object file of a compiler; use a Wavefront OBJ file"},
};

/// Of the first characters, as text in UTF-16 without a byte order mark has them.
bool every_second_is_zero(std::string_view bytes) {
  constexpr std::size_t kLooked = 64;
  std::array<std::size_t, 2> zeros{};
  const std::size_t looked = std::min(bytes.size(), kLooked);
  for (std::size_t i = 0; i < looked; ++i)
    if (bytes[i] == '\0') ++zeros[i % 2];
  return looked >= 4 && ((zeros[0] == 0 && zeros[1] == looked / 2) ||
                         (zeros[1] == 0 && zeros[0] == (looked + 1) / 2));
}

}  // namespace

std::string_view unreadable_kind(std::string_view bytes) {
  for (const Signature& signature : kSignatures)
    if (bytes.starts_with(signature.bytes)) return signature.what;
  if (every_second_is_zero(bytes)) return "is UTF-16 text; save it as UTF-8";
  if (bytes.find('\0') != bytes.npos) return "is not a text file; use a Wavefront OBJ file";
  return {};
}

}  // namespace lanescope
