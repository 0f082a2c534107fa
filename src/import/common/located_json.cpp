#include "import/common/located_json.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "import/common/json_handler.h"

namespace ajar {
namespace {

/// Where the string ends that begins at `i`.
std::size_t end_of_string(std::string_view text, std::size_t i) {
  for (std::size_t k = i + 1; k < text.size(); ++k) {
    if (text[k] == '"') return k + 1;
    if (text[k] == '\\') ++k;
  }
  return text.size();
}
/// End of a comment; `i` if there is none, or it has no end.
std::size_t end_of_comment(std::string_view text, std::size_t i) {
  if (text.substr(i, 2) == "//") return std::min(text.find('\n', i), text.size());
  const std::size_t end = text.substr(i, 2) == "/*" ? text.find("*/", i + 2) : text.npos;
  return end == text.npos ? i : end + 2;
}

/// The text with spaces in place of the extensions of JSON, so that all else stays where it is.
std::string without_extras(std::string_view text) {
  std::string result(text);
  char last = '\0';  // last character that is neither space nor comment
  constexpr std::size_t kNoComma = std::string_view::npos;
  std::size_t comma = kNoComma;  // the last, if only spaces and comments are behind it
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (const std::size_t end = c == '/' ? end_of_comment(text, i) : i; end > i) {
      for (; i < end; ++i) {
        if (text[i] != '\n') result[i] = ' ';
      }
      continue;
    }
    if (std::string_view(" \t\r\n").find(c) == std::string_view::npos) {
      if ((c == ']' || c == '}') && comma != kNoComma) result[comma] = ' ';
      const bool follows_value = last != '\0' && std::string_view("[{,:").find(last) == kNoComma;
      comma = c == ',' && follows_value ? i : kNoComma;
      last = c;
    }
    i = c == '"' ? end_of_string(text, i) : i + 1;
  }
  return result;
}

}  // namespace

/// Makes the tree from the parser's events.
class LocatedJson::Builder : public JsonHandler {
 public:
  Builder(std::string_view text, const std::string& name)
      : JsonHandler(text, std::make_shared<const std::string>(name)) {}

  LocatedJson build() {
    parse(this);
    return std::move(root_);
  }

  bool null() {
    add(Kind::Null);
    return true;
  }
  bool boolean(bool value) {
    add(Kind::Bool).flag_ = value;
    return true;
  }
  bool number_integer(number_integer_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t& /*spelling*/) { return number(value); }
  bool string(string_t& value) {
    add(Kind::String).text_ = std::move(value);
    return true;
  }
  bool key(string_t& name) {
    Member member{std::move(name), token_place(), {}};
    open_.back()->members_.push_back(std::move(member));
    return true;
  }
  bool start_object(std::size_t /*size*/) { return open(Kind::Object); }
  bool start_array(std::size_t /*size*/) { return open(Kind::Array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

 private:
  /// A value at its place in the tree.
  LocatedJson& add(Kind kind) {
    LocatedJson* value = &root_;
    if (!open_.empty()) {
      LocatedJson& parent = *open_.back();
      value =
          parent.is(Kind::Object) ? &parent.members_.back().value : &parent.items_.emplace_back();
    }
    value->kind_ = kind;
    value->where_ = token_place();
    return *value;
  }
  bool number(double value) {
    add(Kind::Number).number_ = value;
    return true;
  }
  bool open(Kind kind) {
    LocatedJson& value = add(kind);
    if (open_.size() == kDeepest) {
      throw SceneError(value.where(),
                       "values are nested more than " + std::to_string(kDeepest) + " levels deep");
    }
    open_.push_back(&value);
    return true;
  }
  bool close() {
    open_.pop_back();
    pass_token();
    return true;
  }

  LocatedJson root_;
  std::vector<LocatedJson*> open_;  ///< arrays and objects around the next value
};

LocatedJson LocatedJson::parse(std::string_view text, const std::string& name, JsonExtras extras) {
  if (extras == JsonExtras::CommentsAndTrailingCommas) {
    return parse(without_extras(text), name);
  }
  return Builder(text, name).build();
}

std::string_view LocatedJson::kind_name() const {
  switch (kind_) {
    case Kind::Null:
      return "null";
    case Kind::Bool:
      return "true or false";
    case Kind::Number:
      return "a number";
    case Kind::String:
      return "a text";
    case Kind::Array:
      return "an array";
    case Kind::Object:
      return "an object";
  }
  return "";
}

const LocatedJson* LocatedJson::find(std::string_view name) const {
  for (const Member& member : members_) {
    if (member.name == name) return &member.value;
  }
  return nullptr;
}

}  // namespace ajar
