// SPDX-License-Identifier: MIT
// Memory that instructions address: views with a size, so that a checked machine can check bounds
// and reads of what was never written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <string_view>
#include <type_traits>

#include "simulator/base/error.h"

namespace lanescope {

/// Size of a line of memory. Lines are counted from the first element of the Memory that an
/// instruction addresses, wherever the host has put it, so that counts of them are reproducible.
inline constexpr std::size_t kLineBytes = 64;

/// What an instruction does to an element of memory.
enum class Access {
  kLoad,
  kStore,
  kUpdate  ///< Reads the element and stores to it; lanes do so one after another.
};

/// A view of elements in memory. `written`, where not null, has a byte for each element, 0 until it
/// has been stored to.
template <class T>
struct Memory {
  T* data = nullptr;
  std::size_t size = 0;
  std::string_view name;
  std::uint8_t* written = nullptr;

  /// The elements begin ... begin + count - 1.
  Memory part(std::size_t begin, std::size_t count) const {
    return {data + begin, count, name, written ? written + begin : nullptr};
  }

  /// A view for reading only.
  operator Memory<const T>() const requires(!std::is_const_v<T>) {
    return {data, size, name, written};
  }
};

/// A view of memory that is wholly initialized.
template <class T>
Memory<const T> read_only(const T* data, std::size_t size, std::string_view name) {
  return {data, size, name, nullptr};
}

/// Scratch memory of a kernel, aligned to a cache line; a checked machine follows what has been
/// written to it.
template <class T>
class Buffer {
 public:
  Buffer(std::size_t size, std::string_view name, bool checked)
      : data_(static_cast<T*>(::operator new[](size * sizeof(T), std::align_val_t{64}))),
        written_(checked ? new std::uint8_t[size]() : nullptr),
        size_(size),
        name_(name) {
    std::fill_n(data_.get(), size, T{});
  }

  /// The buffer as kernels address it.
  Memory<T> memory() { return {data_.get(), size_, name_, written_.get()}; }
  const T* data() const { return data_.get(); }
  /// Copies `count` elements to element `begin` and on, as the host, not as an instruction.
  void fill(std::size_t begin, const T* from, std::size_t count) {
    std::copy_n(from, count, data_.get() + begin);
    if (written_) std::fill_n(written_.get() + begin, count, std::uint8_t{1});
  }

 private:
  struct AlignedDelete {
    void operator()(T* p) const { ::operator delete[](p, std::align_val_t{64}); }
  };
  std::unique_ptr<T[], AlignedDelete> data_;
  std::unique_ptr<std::uint8_t[]> written_;
  std::size_t size_;
  std::string_view name_;
};

}  // namespace lanescope
