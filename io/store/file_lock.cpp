#include "io/store/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "io/store/database.h"

namespace coapt {

Expected<FileLock> FileLock::take(const std::string& path) {
  const auto refused = [&path](ErrorCode code) {
    return Error{code, "", path + ": cannot be locked: " + std::strerror(errno)};
  };
  FileLock lock(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
  if (lock.descriptor_ < 0) return refused(code_of_errno(errno));
  if (flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0)
    return refused(errno == EWOULDBLOCK ? ErrorCode::Busy : code_of_errno(errno));
  return lock;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace coapt
