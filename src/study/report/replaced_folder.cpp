#include "study/report/replaced_folder.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "os/atomic_file.h"

namespace ajar {

namespace {
namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& folder, const std::string& reason) {
  throw IoError("cannot write the folder \"" + folder.string() + "\": " + reason);
}

/// `folder/` and `folder` name the same; links are replaced at the place they point to.
fs::path normal(const fs::path& folder) {
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(folder, error), error);
  if (error || path.empty()) fail(folder, error ? error.message() : "its name is empty");
  return path.has_filename() ? path : path.parent_path();
}

int rename_at(const fs::path& from, const fs::path& to, unsigned flags) {
  return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags) == 0 ? 0 : errno;
}

/// For file systems that cannot exchange: for a moment there is no target.
int exchange_in_steps(const fs::path& temporary, const fs::path& target) {
  const fs::path old = temporary_path(target);
  if (const int reason = rename_at(target, old, 0); reason != 0) return reason;
  if (const int reason = rename_at(temporary, target, 0); reason != 0) {
    rename_at(old, target, 0);
    return reason;
  }
  return rename_at(old, temporary, 0);
}

}  // namespace

ReplacedFolder::ReplacedFolder(const fs::path& target) : target_(normal(target)) {
  int reason = EEXIST;
  while (reason == EEXIST) {
    temporary_ = temporary_path(target_);
    reason = ::mkdir(temporary_.c_str(), 0777) == 0 ? 0 : errno;
  }
  if (reason == 0) return;
  if (!fs::is_directory(target_.parent_path())) {
    fail(target, "there is no folder \"" + target_.parent_path().string() + "\"");
  }
  fail(target, std::system_category().message(reason));
}

ReplacedFolder::~ReplacedFolder() {
  std::error_code ignored;
  fs::remove_all(temporary_, ignored);
}

void ReplacedFolder::commit() {
  std::error_code error;
  int reason = 0;
  if (fs::exists(target_, error)) {
    reason = rename_at(temporary_, target_, RENAME_EXCHANGE);
    if (reason == EINVAL || reason == ENOSYS) reason = exchange_in_steps(temporary_, target_);
  } else {
    reason = rename_at(temporary_, target_, RENAME_NOREPLACE);
    if (reason == EINVAL || reason == ENOSYS) reason = rename_at(temporary_, target_, 0);
  }
  if (reason != 0) fail(target_, std::system_category().message(reason));
}

}  // namespace ajar
