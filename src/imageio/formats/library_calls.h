#pragma once
#include <csetjmp>
#include <cstring>
#include <string>
#include <type_traits>

#include "core/error.h"

namespace ajar::image_formats {

/// Calls of a C library whose errors end by a long jump out of it: exceptions would have to pass
/// through its functions, which need not have unwind tables.
class LibraryCalls {
 public:
  /// `failure` is what errors say before what the library says.
  explicit LibraryCalls(const char* failure) : failure_(failure) {}
  LibraryCalls(const LibraryCalls&) = delete;
  LibraryCalls& operator=(const LibraryCalls&) = delete;

  /// Runs `body`, in which nothing may have a destructor. Raises IoError if the library fails.
  template <typename Body>
  void run(const Body& body) {
    static_assert(std::is_trivially_destructible_v<Body>);
    if (setjmp(place_) == 0) {  // NOLINT(cert-err52-cpp)
      body();
      return;
    }
    throw IoError(std::string(failure_) + " (" + text_ + ")");
  }

  /// For what the library calls while `run` runs: ends that with an error.
  [[noreturn]] void fail(const char* what) {
    std::strncpy(text_, what, sizeof(text_) - 1);
    std::longjmp(place_, 1);  // NOLINT(cert-err52-cpp)
  }

 private:
  const char* failure_;
  std::jmp_buf place_{};
  char text_[256] = {};
};

}  // namespace ajar::image_formats
