#pragma once
#include <istream>
#include <streambuf>
#include <string_view>

namespace ajar::obj {

/// Text as a stream for tinyobjloader, which says at no callback where it is.
class TextStream : private std::streambuf, public std::istream {
 public:
  explicit TextStream(std::string_view text) : std::istream(this), counted_(text.data()) {
    // The buffer is only read.
    char* begin = const_cast<char*>(text.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
    setg(begin, begin, begin + text.size());
  }

  /// The line that was read last, counted from 1.
  int line() {
    for (; counted_ < gptr(); ++counted_) lines_ += *counted_ == '\n' ? 1 : 0;
    const bool is_within = gptr() > eback() && gptr()[-1] != '\n';
    return lines_ + (is_within ? 1 : 0);
  }

 private:
  const char* counted_;
  int lines_ = 0;
};

}  // namespace ajar::obj
