#include "import/gltf/json_places.h"

#include <charconv>
#include <limits>

#include "core/printable_text.h"
#include "import/common/json_handler.h"

namespace ajar::gltf {
namespace {

constexpr std::uint32_t kNoValue = std::numeric_limits<std::uint32_t>::max();

std::string unescaped(std::string_view part) {
  std::string name;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const bool is_escape = part[i] == '~' && i + 1 < part.size();
    name += is_escape ? (part[++i] == '0' ? '~' : '/') : part[i];
  }
  return name;
}

}  // namespace

std::string pointer_part(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (c == '~') {
      text += "~0";
    } else if (c == '/') {
      text += "~1";
    } else {
      text += c;
    }
  }
  return printable_line(text);
}

JsonPlaces::Place JsonPlaces::at(std::string_view pointer) const {
  if (values_.empty()) return {};
  const Value* value = &values_.front();
  while (!pointer.empty() && value->children) {
    pointer.remove_prefix(1);  // the slash
    const std::string_view part = pointer.substr(0, pointer.find('/'));
    pointer.remove_prefix(part.size());
    const Children& children = *value->children;
    std::uint32_t next = kNoValue;
    if (!children.items.empty()) {
      std::size_t i = 0;
      const auto end = std::from_chars(part.data(), part.data() + part.size(), i);
      if (end.ec == std::errc() && i < children.items.size()) next = children.items[i];
    } else if (const auto found = children.members.find(unescaped(part));
               found != children.members.end()) {
      next = found->second;
    }
    if (next == kNoValue) break;
    value = &values_[next];
  }
  return value->place;
}

/// Makes the values that the parser finds, and notes where they are.
class JsonReader : public JsonHandler {
 public:
  using Json = nlohmann::json;

  JsonReader(std::string_view text, const std::shared_ptr<const std::string>& name)
      : JsonHandler(text, name) {}

  PlacedJson read() {
    parse(this);
    return {std::move(root_), std::move(places_)};
  }

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(number_integer_t value) { return add(value); }
  bool number_unsigned(number_unsigned_t value) { return add(value); }
  bool number_float(number_float_t value, const string_t& /*spelling*/) { return add(value); }
  bool string(string_t& value) { return add(std::move(value)); }
  bool key(string_t& name) {
    open_.back().name = std::move(name);
    pass_token();
    return true;
  }
  bool start_object(std::size_t /*size*/) { return open(Json::object()); }
  bool start_array(std::size_t /*size*/) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

 private:
  /// An array or object around the next value.
  struct Open {
    Json* json;
    std::uint32_t value;
    std::string name = {};  ///< name of the member of an object that comes next, or is open
    bool is_array() const { return json->is_array(); }
  };

  bool add(Json value) {
    make(std::move(value));
    return true;
  }
  bool open(Json value) {
    open_.push_back(make(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    pass_token();
    return true;
  }

  Open make(Json value) {
    const std::uint32_t number = note(value.is_number());
    if (open_.empty()) {
      root_ = std::move(value);
      return {&root_, number};
    }
    Json& parent = *open_.back().json;
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return {&parent.back(), number};
    }
    Json& member = parent[open_.back().name];
    member = std::move(value);
    return {&member, number};
  }

  /// The number of the place of the value that comes next.
  std::uint32_t note(bool is_number) {
    const SourceLocation where = token_place();
    const bool is_item = !open_.empty() && open_.back().is_array();
    if (is_item && is_number) return kNoValue;
    const auto added = static_cast<std::uint32_t>(places_.values_.size());
    places_.values_.push_back({{where.line, where.column}, nullptr});
    if (open_.empty()) return added;
    auto& children = places_.values_[open_.back().value].children;
    if (!children) children = std::make_unique<JsonPlaces::Children>();
    if (is_item) {
      children->items.resize(open_.back().json->size() + 1, kNoValue);
      children->items.back() = added;
    } else if (!children->members.insert_or_assign(open_.back().name, added).second) {
      note_repeated();
    }
    return added;
  }

  void note_repeated() {
    // A pointer may be as long as the text.
    constexpr std::size_t kMostRepeated = 100;
    if (places_.repeated_.size() < kMostRepeated) {
      places_.repeated_.push_back({pointer_of_open(), open_.back().name});
    } else {
      ++places_.more_repeated_;
    }
  }

  /// Pointer of the innermost object that is open.
  std::string pointer_of_open() const {
    std::string pointer;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      pointer += "/" + (open_[i].is_array() ? std::to_string(open_[i].json->size() - 1)
                                            : pointer_part(open_[i].name));
    }
    return pointer;
  }

  Json root_;
  JsonPlaces places_;
  std::vector<Open> open_;
};

PlacedJson parse_placed_json(std::string_view text,
                             const std::shared_ptr<const std::string>& name) {
  return JsonReader(text, name).read();
}

}  // namespace ajar::gltf
