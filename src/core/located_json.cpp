#include "core/located_json.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/number_text.h"
#include "core/printable_text.h"

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

/// The part of the parser's message with the reason; its own place is less exact than ours.
std::string reason_of(const std::string& message) {
  std::size_t begin = message.find("column ");
  begin = begin == std::string::npos ? message.find("] ") : message.find(": ", begin);
  return printable_line(begin == std::string::npos ? message : message.substr(begin + 2));
}

/// With ~ and / escaped, as in JSON pointers.
std::string pointer_part(std::string_view name) {
  std::string text;
  for (const char c : name) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return "/" + printable_line(text);
}

/// The text of a string, which has its quotes; most have nothing to decode.
std::string text_of(std::string_view source) {
  if (source.find('\\') != std::string_view::npos) return nlohmann::json::parse(source);
  return std::string(source.substr(1, source.size() - 2));
}

}  // namespace

/// A value: where it begins and ends in the text, and its parts; of an object names and values in
/// turn.
struct LocatedJson::Node {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t parent;
  std::uint32_t first;
  std::uint32_t count;
  Kind kind;
};

/// Nesting may be as deep as the text is long, so that no node owns another.
struct LocatedJson::Tree {
  std::string text;
  JsonRules rules;
  std::shared_ptr<const std::string> name;
  std::vector<std::uint32_t> lines;  ///< where they begin
  std::vector<Node> nodes;           ///< parts of a value in a row, and before it; the whole last
  std::vector<Node> repeated;        ///< names

  std::string_view source(const Node& node) const {
    return std::string_view(text).substr(node.begin, node.end - node.begin);
  }
  SourceLocation place(std::size_t offset) const {
    const auto line = std::upper_bound(lines.begin(), lines.end(), offset);
    return {name, static_cast<int>(line - lines.begin()),
            static_cast<int>(offset - *std::prev(line)) + 1};
  }
  [[noreturn]] void fail(const SourceLocation& where, const std::string& message) const {
    rules.raise(ajar::located(where, message));
    std::abort();
  }
};

/// Makes the nodes from the parser's events.
class LocatedJson::Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit Builder(Tree& tree) : tree_(tree) { nlohmann::json::sax_parse(tree.text, this); }

  bool null() override { return add(Kind::Null); }
  bool boolean(bool /*value*/) override { return add(Kind::Bool); }
  bool number_integer(number_integer_t /*value*/) override { return add(Kind::Number); }
  bool number_unsigned(number_unsigned_t /*value*/) override { return add(Kind::Number); }
  bool number_float(number_float_t /*value*/, const string_t& /*spelling*/) override {
    return add(Kind::Number);
  }
  bool string(string_t& /*value*/) override { return add(Kind::Text); }
  bool key(string_t& /*name*/) override { return add(Kind::Text); }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON has none
  bool start_object(std::size_t /*size*/) override { return open(Kind::Object); }
  bool start_array(std::size_t /*size*/) override { return open(Kind::Array); }
  bool end_object() override {
    drop_repeated();
    return close();
  }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int kNumberOutOfRange = 406;  // from the parser's documentation
    if (error.id == kNumberOutOfRange) {
      fail(next_token(), "the number " + printable(token) + " is too large; at most 1.7e308");
    }
    fail(std::min(position - std::min<std::size_t>(position, 1), tree_.text.size()),
         "this is no JSON: " + reason_of(error.what()));
  }

 private:
  [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
    tree_.fail(tree_.place(offset), message);
  }

  std::size_t next_token() const { return tree_.text.find_first_not_of(" \t\r\n,:", read_); }
  bool add(Kind kind) {
    const std::string& text = tree_.text;
    const std::size_t begin = next_token();
    if (kind == Kind::Array || kind == Kind::Object) {
      read_ = begin + 1;
    } else if (kind == Kind::Text) {
      read_ = end_of_string(text, begin);
    } else {
      read_ = std::min(text.find_first_of(" \t\r\n,]}", begin), text.size());
    }
    // The parent is not there yet.
    pending_.push_back(
        {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(read_), 0, 0, 0, kind});
    if (open_.empty()) place(pending_.back());
    return true;
  }
  bool open(Kind kind) {
    if (open_.size() == tree_.rules.deepest) {
      fail(next_token(),
           "values are nested more than " + std::to_string(tree_.rules.deepest) + " deep");
    }
    open_.push_back(pending_.size());
    return add(kind);
  }
  bool close() {
    Node& value = pending_[open_.back()];
    read_ = next_token() + 1;
    value.end = static_cast<std::uint32_t>(read_);
    const auto parts = pending_.begin() + static_cast<std::ptrdiff_t>(open_.back()) + 1;
    value.first = static_cast<std::uint32_t>(tree_.nodes.size());
    value.count = static_cast<std::uint32_t>(pending_.end() - parts);
    std::for_each(parts, pending_.end(), [&](const Node& part) { place(part); });
    pending_.erase(parts, pending_.end());
    open_.pop_back();
    if (open_.empty()) place(value);
    return true;
  }
  void place(const Node& node) {
    for (std::uint32_t i = 0; i < node.count; ++i) {
      tree_.nodes[node.first + i].parent = static_cast<std::uint32_t>(tree_.nodes.size());
    }
    tree_.nodes.push_back(node);
  }

  /// Leaves out all but one of each name, in the object that ends.
  void drop_repeated() {
    std::map<std::string, std::size_t> places;
    std::size_t kept = open_.back() + 1;
    for (std::size_t i = kept; i < pending_.size(); i += 2) {
      const auto [known, is_new] = places.try_emplace(text_of(tree_.source(pending_[i])), kept);
      if (!is_new) tree_.repeated.push_back(pending_[i]);
      if (is_new || !tree_.rules.first_counts) {
        std::copy_n(pending_.begin() + static_cast<std::ptrdiff_t>(i), 2,
                    pending_.begin() + static_cast<std::ptrdiff_t>(known->second));
      }
      if (is_new) kept += 2;
    }
    pending_.resize(kept);
  }

  Tree& tree_;
  std::size_t read_ = 0;           ///< where the last token ends
  std::vector<Node> pending_;      ///< nodes whose parent is open
  std::vector<std::size_t> open_;  ///< arrays and objects, in `pending_`
};

LocatedJson LocatedJson::parse(std::string text, JsonRules rules) {
  const auto tree = std::make_shared<Tree>();
  tree->name = std::make_shared<const std::string>(rules.name.empty() ? "text" : rules.name);
  tree->rules = std::move(rules);
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  tree->text = tree->rules.has_extras ? without_extras(text) : std::move(text);
  tree->lines.push_back(0);
  if (tree->text.size() > std::numeric_limits<std::uint32_t>::max()) {
    tree->fail({tree->name, 0, 0}, "this JSON has more than 4 GiB");
  }
  for (std::size_t i = 0; (i = tree->text.find('\n', i)) != tree->text.npos;) {
    tree->lines.push_back(static_cast<std::uint32_t>(++i));
  }
  const Builder builder(*tree);
  return {tree, static_cast<std::uint32_t>(tree->nodes.size() - 1)};
}

const LocatedJson::Node& LocatedJson::node() const { return tree_->nodes[node_]; }
LocatedJson::Kind LocatedJson::kind() const { return is_emptied_ ? Kind::Object : node().kind; }
std::string_view LocatedJson::source() const { return tree_->source(node()); }
LocatedJson LocatedJson::child(std::size_t i) const {
  return {tree_, node().first + static_cast<std::uint32_t>(i)};
}

const JsonRules& LocatedJson::rules() const { return tree_->rules; }

SourceLocation LocatedJson::where() const {
  if (tree_->rules.place != nullptr) return tree_->rules.place(*this);
  const std::string path = pointer();
  if (tree_->rules.name.empty()) {
    if (path.empty()) return {};
    return {std::make_shared<const std::string>(path.substr(1)), 0, 0};
  }
  SourceLocation where = tree_->place(node().begin);
  if (!path.empty()) where.part = std::make_shared<const std::string>("#" + path);
  return where;
}

std::optional<LocatedJson> LocatedJson::parent() const {
  if (node_ + 1 == tree_->nodes.size()) return std::nullopt;
  return LocatedJson(tree_, node().parent);
}

std::string LocatedJson::name() const {
  const std::optional<LocatedJson> around = parent();
  if (!around) return {};
  const std::uint32_t number = node_ - around->node().first;
  if (around->is(Kind::Array)) return std::to_string(number);
  return number % 2 == 0 ? "" : around->child(number - 1).text();
}

std::string LocatedJson::pointer() const {
  std::vector<std::string> parts;
  const std::optional<LocatedJson> around = parent();
  const bool is_key = around && around->is(Kind::Object) && (node_ - around->node().first) % 2 == 0;
  for (LocatedJson value = is_key ? *around : *this; value.parent(); value = *value.parent()) {
    parts.push_back(pointer_part(value.name()));
  }
  std::string pointer;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) pointer += *part;
  return pointer;
}

std::string LocatedJson::shown() const {
  if (is(Kind::Object)) return "an object";
  return printable(source());
}

void LocatedJson::fail(const std::string& message) const { tree_->fail(where(), message); }

void LocatedJson::add_place(const Error& error) const {
  const std::string message = error.what();
  if (message.starts_with(*tree_->name + ":")) tree_->rules.raise(message);
  fail(message);
}

void LocatedJson::require(Kind kind, const char* expected) const {
  if (!is(kind)) fail_type(expected);
}

bool LocatedJson::flag() const {
  require(Kind::Bool, "true or false");
  return source() == "true";
}

double LocatedJson::number() const {
  require(Kind::Number, "a number");
  return number_of(source()).value_or(0.0);
}

std::string LocatedJson::text() const {
  require(Kind::Text, "text");
  std::string text = text_of(source());
  if (!rules().may_have_zeros && text.find('\0') != text.npos) fail("must have no zero byte");
  return text;
}

std::size_t LocatedJson::index(std::size_t count) const {
  const auto number = as<std::size_t>();
  if (number >= count) {
    fail("refers to number " + std::to_string(number) + ", but there are " + std::to_string(count) +
         ", counted from 0");
  }
  return number;
}

std::string LocatedJson::plain() const {
  using Json = nlohmann::ordered_json;
  return is(Kind::Text) ? text() : Json::parse(source()).dump();
}

std::size_t LocatedJson::size() const {
  require(Kind::Array, "an array");
  return node().count;
}

LocatedJson LocatedJson::operator[](std::size_t i) const { return child(i); }

std::vector<LocatedJson> LocatedJson::items() const {
  std::vector<LocatedJson> items;
  const std::size_t count = size();
  items.reserve(count);
  for (std::size_t i = 0; i < count; ++i) items.push_back(child(i));
  return items;
}

std::vector<LocatedJson> LocatedJson::items(std::string_view name) const {
  const std::optional<LocatedJson> array = find_member(name);
  return array ? array->items() : std::vector<LocatedJson>();
}

std::vector<LocatedJson::Member> LocatedJson::members() const {
  require(Kind::Object, "an object");
  std::vector<Member> members;
  for (std::size_t i = 0; i < (is_emptied_ ? 0 : node().count); i += 2) {
    members.push_back({child(i).text(), child(i), child(i + 1)});
  }
  return members;
}

std::optional<LocatedJson> LocatedJson::find_member(std::string_view name) const {
  require(Kind::Object, "an object");
  for (std::size_t i = 0; i < (is_emptied_ ? 0 : node().count); i += 2) {
    const std::string_view key = tree_->source(tree_->nodes[node().first + i]);
    const bool is_plain = key.find('\\') == std::string_view::npos;
    if (is_plain ? key.substr(1, key.size() - 2) != name : text_of(key) != name) continue;
    const LocatedJson value = child(i + 1);
    if (tree_->rules.null_is_absent && value.is(Kind::Null)) break;
    return value;
  }
  return std::nullopt;
}

LocatedJson LocatedJson::required(std::string_view name) const {
  const std::optional<LocatedJson> member = find_member(name);
  if (!member) fail("there is no \"" + std::string(name) + "\" here");
  return *member;
}

void LocatedJson::check_members(std::string_view kind,
                                const std::vector<std::string>& names) const {
  for (const Member& member : members()) {
    if (std::find(names.begin(), names.end(), member.name) == names.end()) {
      member.key.fail(unknown_name_message(kind, printable_line(member.name), names));
    }
  }
}

std::vector<LocatedJson::Repeated> LocatedJson::repeated(std::size_t most) const {
  std::vector<Repeated> repeated;
  for (std::size_t i = 0; i < std::min(most, tree_->repeated.size()); ++i) {
    const Node& name = tree_->repeated[i];
    repeated.push_back({text_of(tree_->source(name)), tree_->place(name.begin)});
  }
  return repeated;
}

std::size_t LocatedJson::repeated_count() const { return tree_->repeated.size(); }

LocatedJson LocatedJson::without_members() const {
  LocatedJson object = *this;
  object.is_emptied_ = true;
  return object;
}

}  // namespace ajar
