// SPDX-License-Identifier: MIT
#include "analysis/sweep/cell_claims.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <limits>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

std::string file_in(const std::string& directory) {
  return directory + "/" + CellClaims::kFileName;
}

/// The byte that stands for a cell. Ids are hashes of 64 bits; places in files have 63.
struct flock byte_of(const std::string& cell_id, short type) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = static_cast<off_t>(std::stoull(cell_id, nullptr, 16) >> 1);
  lock.l_len = 1;
  // A range may not end beyond the last place.
  if (lock.l_start == std::numeric_limits<off_t>::max()) --lock.l_start;
  return lock;
}

}  // namespace

CellClaims::CellClaims(const std::string& directory)
    : descriptor_(::open(file_in(directory).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0)
    throw InputError(file_in(directory), "cannot be written: {}", std::strerror(errno));
}

CellClaims::~CellClaims() { ::close(descriptor_); }

bool CellClaims::take(const std::string& cell_id) const {
  struct flock lock = byte_of(cell_id, F_WRLCK);
  return ::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES);
}

void CellClaims::give_back(const std::string& cell_id) const {
  struct flock lock = byte_of(cell_id, F_UNLCK);
  ::fcntl(descriptor_, F_OFD_SETLK, &lock);
}

bool is_claimed(const std::string& directory, const std::string& cell_id) {
  const int descriptor = ::open(file_in(directory).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  struct flock lock = byte_of(cell_id, F_WRLCK);
  const bool known = ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0;
  ::close(descriptor);
  return known && lock.l_type != F_UNLCK;
}

}  // namespace lanescope
