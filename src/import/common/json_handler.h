#pragma once
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/counting_iterator.h"
#include "core/error.h"
#include "import/common/place_finder.h"

namespace ajar {

/// Common base of handlers of nlohmann's parser events: places of tokens, and messages on text that
/// is no JSON. A token begins where the one before it ended, but for what lies between tokens; of a
/// number the parser has read one character more.
class JsonHandler {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  bool binary(binary_t& /*value*/) { return false; }  // JSON has none
  /// Raises SceneError, with line and column.
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error);

 protected:
  /// `text` must outlive it. `name` stands in messages.
  JsonHandler(std::string_view text, std::shared_ptr<const std::string> name)
      : text_(text), places_(text, std::move(name)) {}

  /// Calls `handler`, which has this as its base, for all of the text.
  template <typename Handler>
  void parse(Handler* handler) {
    nlohmann::json::sax_parse(CountingIterator(text_.data(), &read_),
                              CountingIterator(text_.data() + text_.size(), &read_), handler);
  }
  /// Where the token begins that was just read.
  SourceLocation token_place() {
    const SourceLocation place = places_.at(places_.next_token(token_end_));
    pass_token();
    return place;
  }
  /// Instead, where that does not matter.
  void pass_token() { token_end_ = read_; }

 private:
  std::string_view text_;
  PlaceFinder places_;
  std::size_t read_ = 0;       ///< bytes that the parser has read
  std::size_t token_end_ = 0;  ///< bytes up to the end of the last token, or one more
};

}  // namespace ajar
