#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"

namespace ajar {

/// Lines and columns of places that come in the order of the text.
class PlaceFinder {
 public:
  PlaceFinder(std::string_view text, std::shared_ptr<const std::string> file)
      : text_(text), file_(std::move(file)) {}

  /// The place of byte `offset`, or of the end of the text.
  SourceLocation at(std::size_t offset) {
    for (offset = std::min(offset, text_.size()); position_ < offset; ++position_) {
      if (text_[position_] != '\n') continue;
      ++line_;
      line_start_ = position_ + 1;
    }
    return {file_, line_, static_cast<int>(offset - std::min(offset, line_start_)) + 1};
  }
  /// The first byte from `offset` on that begins a token.
  std::size_t next_token(std::size_t offset) const {
    constexpr std::string_view kBetween = " \t\r\n,:";
    return std::min(text_.find_first_not_of(kBetween, offset), text_.size());
  }

 private:
  std::string_view text_;
  std::shared_ptr<const std::string> file_;
  std::size_t position_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
};

}  // namespace ajar
