#include "study/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/error.h"

namespace ajar::study {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : file_(open((folder / ".lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
  if (file_ < 0) {
    throw IoError("cannot write into " + folder.string() + ": " +
                  std::system_category().message(errno));
  }
  if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
    close(file_);
    throw IoError(folder.string() + ": another study is writing here");
  }
}

FolderLock::~FolderLock() { close(file_); }

}  // namespace ajar::study
