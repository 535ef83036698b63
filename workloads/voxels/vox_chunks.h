// SPDX-License-Identifier: MIT
// The chunks of MagicaVoxel files: bytes that are taken one after another, never beyond their end.
//
// A file is "VOX ", its version, and the chunk MAIN. A chunk is a name of four letters, the size of
// its content, the size of its children, the content, and the children, which are chunks again.
// Those of MAIN are SIZE and XYZI for each model, RGBA for the palette, LAYR for each layer, and
// the nodes of the scene graph: nTRN places a node, nGRP has nodes, nSHP shows a model. Numbers are
// of 32 bits, the lowest byte first, with a sign.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/base/error.h"
#include "workloads/geometry/obj_words.h"

namespace lanescope::vox {

/// What fails says where.
class Place {
 public:
  Place(std::string_view file, std::size_t byte) : file_(file), byte_(byte) {}

  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    throw InputError(file_, "at byte {}: {}", byte_,
                     fmt::format(format, std::forward<Args>(args)...));
  }

 private:
  std::string_view file_;
  std::size_t byte_;
};

struct Entry {
  std::string_view key, value;
  Place place;  ///< Of the value.
};

/// Bytes of the file, taken from the front.
class Bytes {
 public:
  Bytes(std::string_view file, std::string_view bytes, std::size_t first_byte)
      : file_(file), bytes_(bytes), at_(first_byte) {}

  Place place() const { return {file_, at_}; }
  std::size_t left() const { return bytes_.size(); }

  Bytes take(std::int64_t count, std::string_view what) {
    if (count < 0) place().fail("{} has {} bytes; use 0 or more", what, count);
    if (static_cast<std::uint64_t>(count) > bytes_.size())
      place().fail("{} has {} bytes, but {} are left; is the file cut off?", what, count,
                   bytes_.size());
    const Bytes taken(file_, bytes_.substr(0, static_cast<std::size_t>(count)), at_);
    bytes_.remove_prefix(taken.bytes_.size());
    at_ += taken.bytes_.size();
    return taken;
  }
  std::string_view text() const { return bytes_; }

  std::int64_t number(std::string_view what) {
    const std::string_view four = take(4, what).bytes_;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value |= std::uint32_t{static_cast<std::uint8_t>(four[i])} << (8 * i);
    return static_cast<std::int32_t>(value);
  }

  /// How many parts of at least `least_bytes` follow.
  std::int64_t count(std::string_view what, std::size_t least_bytes) {
    const Place here = place();
    const std::int64_t count = number(what);
    if (count < 0) here.fail("{} is {}; use 0 or more", what, count);
    if (static_cast<std::uint64_t>(count) > bytes_.size() / least_bytes)
      here.fail("{} is {}, but there is room for {}", what, count, bytes_.size() / least_bytes);
    return count;
  }

  std::vector<Entry> dictionary() {
    std::vector<Entry> entries;
    const std::int64_t size = count("the number of attributes", 8);
    for (std::int64_t i = 0; i < size; ++i) {
      const std::string_view key = string("the name of an attribute").bytes_;
      const Bytes value = string("the value of an attribute");
      entries.push_back({key, value.bytes_, value.place()});
    }
    return entries;
  }

 private:
  Bytes string(std::string_view what) { return take(number(what), what); }

  std::string_view file_;
  std::string_view bytes_;
  std::size_t at_;  ///< Byte of the file.
};

struct Chunk {
  std::string_view name;
  Place place;
  Bytes content, children;
};

/// Takes a chunk from the front.
inline Chunk next_chunk(Bytes& bytes) {
  constexpr std::size_t kHeaderBytes = 12;
  const Place place = bytes.place();
  if (bytes.left() < kHeaderBytes)
    place.fail("{} bytes, where a chunk needs {}; is the file cut off?", bytes.left(),
               kHeaderBytes);
  const std::string_view name = bytes.take(4, "the name of a chunk").text();
  const std::int64_t content_bytes = bytes.number("a size");
  const std::int64_t children_bytes = bytes.number("a size");
  const std::string title = fmt::format("chunk '{}'", shown(name));
  const Bytes content = bytes.take(content_bytes, title);
  return {name, place, content, bytes.take(children_bytes, "the part of children of " + title)};
}

}  // namespace lanescope::vox
