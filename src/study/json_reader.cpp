#include "study/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/error.h"

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
}  // namespace

JsonNode JsonNode::read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  if (!file) throw IoError("cannot read \"" + path + "\"");
  const std::string text = content.str();
  try {
    return {Json::parse(text), path, ""};
  } catch (const Json::parse_error& error) {
    // The library's message repeats its own idea of the place after the first colon.
    const std::string message = error.what();
    const std::size_t colon = message.find(": ");
    throw UsageError(fmt::format("{}:{}: this is not JSON: {}", path, place_of(text, error.byte),
                                 message.substr(colon == std::string::npos ? 0 : colon + 2)));
  }
}

std::string JsonNode::place() const { return file_ + ": " + (path_.empty() ? "" : path_ + ": "); }

void JsonNode::fail(const std::string& message) const { throw UsageError(place() + message); }

void JsonNode::check(const std::function<void()>& check) const {
  try {
    check();
  } catch (const UsageError& error) {
    fail(error.what());
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
