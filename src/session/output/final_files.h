#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "session/job/interrupts.h"
#include "session/job/resources.h"

namespace ajar {

/// A file that a render leaves behind.
struct FinalFile {
  std::string what;  ///< for messages, such as "the picture"
  std::string path;
  /// Raises something if it cannot be written there.
  std::function<void(const std::string& path)> write;
};

/// Result of writing a file.
struct WrittenFile {
  std::string what;
  std::string path;    ///< where it is now; empty if it is nowhere
  std::string wanted;  ///< where it should be
  std::string error;   ///< why it is not there; empty if it is
};

/// Waits until there may be room for what a render has made; only the user ends that.
class Patience {
 public:
  using Say = std::function<void(const std::string&)>;

  /// `interrupts`: one more than there are when the waiting begins ends it.
  Patience(const InterruptCount& interrupts, Say say)
      : interrupts_(interrupts), say_(std::move(say)) {}
  /// A while, after which it is worth to try again. False if the user has given up.
  bool wait(const WrittenFile& file);

 private:
  const InterruptCount& interrupts_;
  Say say_;
  std::optional<int> interrupts_before_;
  Stopwatch clock_;
  double next_word_ = 0.0;  ///< seconds
};

/// Writes each file to its place or, if that fails, as `NAME-rescued-N.EXT` into the current folder
/// or the one for temporary files. Those that can be written nowhere are tried again as long as
/// `patience` lasts; null: once. Raises nothing.
std::vector<WrittenFile> write_final_files(const std::vector<FinalFile>& files, Patience* patience);

}  // namespace ajar
