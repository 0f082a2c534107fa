#include "study/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include "core/counting_iterator.h"
#include "core/error.h"
#include "os/regular_file.h"

namespace ajar::study {

namespace {
/// Line and column, from 1, of a byte that is counted from 1.
std::string place_of(const std::string& text, std::size_t byte) {
  const std::size_t end = std::min(byte == 0 ? 0 : byte - 1, text.size());
  const auto begin = text.begin();
  const auto line = 1 + std::count(begin, begin + static_cast<std::ptrdiff_t>(end), '\n');
  const std::size_t last_break = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  const std::size_t column = last_break == std::string::npos ? end + 1 : end - last_break;
  return fmt::format("{}:{}", line, column);
}

/// Reads JSON; every error is a UsageError with file:line:column.
class Parser {
 public:
  Parser(const std::string& path, const std::string& text) : path_(path), text_(text) {}

  JsonNode::Json run() {
    try {
      const CountingIterator begin(text_.data(), &taken_);
      const CountingIterator end(text_.data() + text_.size(), &taken_);
      return JsonNode::Json::parse(begin, end,
                                   [this](int /*depth*/, Event event, JsonNode::Json& parsed) {
                                     watch(event, parsed);
                                     return true;
                                   });
    } catch (const JsonNode::Json::parse_error& error) {
      // The library's message repeats its own idea of the place after the first colon.
      const std::string message = error.what();
      const std::size_t colon = message.find(": ");
      fail(error.byte,
           "this is not JSON: " + message.substr(colon == std::string::npos ? 0 : colon + 2));
    } catch (const JsonNode::Json::out_of_range& error) {
      // "… '1e309'"; the parser has taken one character more than the number.
      const std::string message = error.what();
      const std::size_t quote = message.find('\'');
      const std::string number =
          quote == std::string::npos ? "" : message.substr(quote + 1, message.size() - quote - 2);
      fail(taken_ - std::min(taken_, number.size()),
           "the number " + number + " is too large; at most 1.7e308");
    }
  }

 private:
  using Event = JsonNode::Json::parse_event_t;

  void watch(Event event, const JsonNode::Json& parsed) {
    constexpr std::size_t kDeepest = 64;
    if (event == Event::object_start || event == Event::array_start) {
      members_.emplace_back();
      if (members_.size() > kDeepest) fail(taken_, "values are nested more than 64 deep");
    } else if (event == Event::object_end || event == Event::array_end) {
      members_.pop_back();
    } else if (event == Event::key) {
      const auto& name = parsed.get_ref<const std::string&>();
      if (members_.back().insert(name).second) return;
      fail(taken_ - std::min(taken_, name.size() + 1),
           "the member \"" + name + "\" is there twice");
    }
  }
  /// `byte` counts from 1.
  [[noreturn]] void fail(std::size_t byte, const std::string& message) const {
    throw UsageError(fmt::format("{}:{}: {}", path_, place_of(text_, byte), message));
  }

  const std::string& path_;
  const std::string& text_;
  std::size_t taken_ = 0;                       ///< bytes
  std::vector<std::set<std::string>> members_;  ///< so far, of each value that is open
};
}  // namespace

JsonNode JsonNode::read_file(const std::string& path) {
  const FileBytes file = ajar::read_file(path);
  const std::string text(file.view());
  return {Parser(path, text).run(), path, ""};
}

std::string JsonNode::place() const { return file_ + ": " + (path_.empty() ? "" : path_ + ": "); }

void JsonNode::fail(const std::string& message) const { throw UsageError(place() + message); }

void JsonNode::check(const std::function<void()>& check) const {
  try {
    check();
  } catch (const UsageError& error) {
    const std::string message = error.what();
    if (message.starts_with(file_ + ": ")) throw;  // error of a node, with its place
    fail(message);
  }
}

void JsonNode::check_members(const std::vector<std::string>& valid) const {
  if (!is_object()) fail("expects an object {…}");
  for (const auto& [name, value] : value_.items()) {
    if (std::find(valid.begin(), valid.end(), name) == valid.end()) {
      fail(unknown_name_message("member", name, valid));
    }
  }
}

bool JsonNode::has(const std::string& name) const { return value_.contains(name); }

JsonNode JsonNode::at(const std::string& name) const {
  if (!has(name)) fail("the member \"" + name + "\" is missing");
  return {value_.at(name), file_, path_.empty() ? name : path_ + "." + name};
}

std::vector<JsonNode> JsonNode::elements() const {
  if (!is_array() || value_.empty()) fail("expects an array […] with at least one element");
  std::vector<JsonNode> nodes;
  for (std::size_t i = 0; i < value_.size(); ++i) {
    nodes.emplace_back(value_[i], file_, fmt::format("{}[{}]", path_, i));
  }
  return nodes;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
  if (!is_object()) fail("expects an object {…}");
  std::vector<std::pair<std::string, JsonNode>> nodes;
  for (const auto& [name, value] : value_.items()) nodes.emplace_back(name, at(name));
  return nodes;
}

std::string JsonNode::text() const {
  if (!is_text() || value_.get_ref<const std::string&>().empty()) fail("expects a text \"…\"");
  return value_.get<std::string>();
}

bool JsonNode::truth() const {
  if (!value_.is_boolean()) fail("expects true or false");
  return value_.get<bool>();
}

double JsonNode::positive() const {
  if (!value_.is_number() || !(value_.get<double>() > 0.0)) fail("expects a number above 0");
  return value_.get<double>();
}

std::int64_t JsonNode::whole(std::int64_t minimum, std::int64_t maximum) const {
  const bool fits = value_.is_number_integer() && value_.get<double>() >= double(minimum) &&
                    value_.get<double>() <= double(maximum);
  if (!fits) fail(fmt::format("expects a whole number from {} to {}", minimum, maximum));
  return value_.get<std::int64_t>();
}

std::string JsonNode::parameter_text() const {
  if (is_text()) return value_.get<std::string>();
  if (!value_.is_number() && !value_.is_boolean()) fail("expects a text, a number, true or false");
  return value_.dump();
}

}  // namespace ajar::study
