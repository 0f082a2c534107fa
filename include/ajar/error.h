#pragma once
#include <stdexcept>
#include <string>

#include "ajar/namespace.h"

namespace ajar::AJAR_INTERFACE {
/// Error caused by a caller, a scene or a file. `what()` is the whole message, ready to print; that
/// of a scene begins with file:line:column. Anything else, such as too little memory, comes as
/// other `std::exception`s.
class Error : public std::runtime_error {
 public:
  enum class Kind {
    Usage,   ///< an unknown name, or a value that cannot be
    Scene,   ///< a scene that cannot be used
    File,    ///< a file that cannot be read or written
    Stopped  ///< a render that was stopped before there was a picture
  };
  Error(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};
}  // namespace ajar::AJAR_INTERFACE
