#include "import/code/json_place.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/printable_text.h"

namespace ajar::code {

namespace {

/// [file, line], or nothing.
SourceLocation location_of(const Json& json) {
  const auto where = json.find("where");
  if (where == json.end() || !where->is_array() || where->size() != 2 ||
      !where->at(0).is_string() || !where->at(1).is_number_integer()) {
    return {};
  }
  return {std::make_shared<const std::string>(where->at(0).get<std::string>()),
          where->at(1).get<int>(), 0};
}

/// The library's message without its own name and its idea of the place.
std::string reason_of(const Json::exception& error) {
  const std::string message = error.what();
  const std::size_t colon = message.find(": ");
  return printable_line(colon == std::string::npos ? message : message.substr(colon + 2));
}

}  // namespace

Json parse_json(std::string_view text) {
  constexpr int kDeepest = 64;
  try {
    return Json::parse(text, [](int depth, Json::parse_event_t /*event*/, Json& /*parsed*/) {
      if (depth > kDeepest) throw UsageError("JSON is nested more than 64 deep");
      return true;
    });
  } catch (const Json::exception& error) {
    throw UsageError("this is no JSON: " + reason_of(error));
  }
}

std::string shown(const Json& value) {
  if (value.is_object()) return "an object";
  constexpr std::size_t kLongest = 60;
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "…";
  return printable_line(text);
}

JsonPlace::JsonPlace(const Json& json, std::string what, std::initializer_list<const char*> known)
    : json_(json), what_(std::move(what)) {
  if (!json.is_object()) throw SceneError(what_ + " is no object, but " + shown(json));
  where_ = location_of(json);
  std::vector<std::string> names(known.begin(), known.end());
  for (const auto& [name, value] : json.items()) {
    if (name == "where" || std::find(names.begin(), names.end(), name) != names.end()) continue;
    fail(unknown_name_message("member", name, names));
  }
}

void JsonPlace::fail(const std::string& message) const {
  throw SceneError(where_, what_ + ": " + message);
}

const Json* JsonPlace::find(const char* name) const {
  const auto found = json_.find(name);
  return found == json_.end() || found->is_null() ? nullptr : &*found;
}

std::string JsonPlace::text(const char* name, std::string otherwise) const {
  const Json* value = find(name);
  if (value == nullptr) return otherwise;
  if (!value->is_string()) fail("\"" + std::string(name) + "\" must be text, not " + shown(*value));
  return value->get<std::string>();
}

bool JsonPlace::flag(const char* name, bool otherwise) const {
  const Json* value = find(name);
  if (value == nullptr) return otherwise;
  if (!value->is_boolean()) {
    fail("\"" + std::string(name) + "\" must be true or false, not " + shown(*value));
  }
  return value->get<bool>();
}

double JsonPlace::number(const char* name, double otherwise) const {
  const Json* value = find(name);
  if (value == nullptr) return otherwise;
  if (!value->is_number() || !std::isfinite(value->get<double>())) {
    fail("\"" + std::string(name) + "\" must be a finite number, not " + shown(*value));
  }
  return value->get<double>();
}

int JsonPlace::index(const char* name, std::size_t count) const {
  const Json* value = find(name);
  if (value == nullptr) return -1;
  if (!value->is_number_integer() || value->get<std::int64_t>() < 0 ||
      value->get<std::uint64_t>() >= count) {
    fail("\"" + std::string(name) + "\" must be a whole number below " + std::to_string(count) +
         ", not " + shown(*value));
  }
  return value->get<int>();
}

}  // namespace ajar::code
