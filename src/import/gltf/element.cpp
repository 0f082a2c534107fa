#include "import/gltf/element.h"

#include <cmath>

#include "core/printable_text.h"

namespace ajar::gltf {
namespace {

/// A whole number, also one that is written as 3.0.
std::optional<std::uint64_t> whole_of(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (!value.is_number_float()) return std::nullopt;
  constexpr double kExact = 9007199254740992.0;
  const auto number = value.get<double>();
  if (!(number >= 0.0) || number > kExact || number != std::floor(number)) return std::nullopt;
  return static_cast<std::uint64_t>(number);
}

}  // namespace

SourceLocation Element::where() const {
  const JsonPlaces::Place place = origin_->places.at(pointer_);
  std::string text = origin_->name + ":" + std::to_string(place.line) + ":" +
                     std::to_string(place.column) + (pointer_.empty() ? "" : "#" + pointer_);
  return {std::make_shared<const std::string>(std::move(text)), 0, 0};
}

void Element::fail(const std::string& message) const { throw SceneError(where(), message); }

void Element::fail_type(const char* expected) const {
  constexpr std::size_t kLongest = 40;
  std::string shown = value_->is_structured()
                          ? value_->type_name()
                          : value_->dump(-1, ' ', true, Json::error_handler_t::replace);
  if (shown.size() > kLongest) shown = shown.substr(0, kLongest) + "…";
  fail("this must be " + std::string(expected) + ", not " + shown);
}

void Element::check_object() const {
  if (!value_->is_object()) fail_type("an object");
}

std::size_t Element::size() const {
  if (!value_->is_array()) fail_type("an array");
  return value_->size();
}

Element Element::operator[](std::size_t i) const {
  return {(*value_)[i], origin_, pointer_ + "/" + std::to_string(i)};
}

std::string Element::text() const {
  if (!value_->is_string()) fail_type("text");
  return value_->get<std::string>();
}

double Element::number() const {
  if (!value_->is_number()) fail_type("a number");
  return value_->get<double>();
}

std::uint64_t Element::whole() const {
  const std::optional<std::uint64_t> number = whole_of(*value_);
  if (!number) fail_type("a whole number from 0 on");
  return *number;
}

std::size_t Element::index(std::size_t count) const {
  const std::uint64_t number = whole();
  if (number >= count) {
    fail("this refers to number " + std::to_string(number) + ", but there are " +
         std::to_string(count) + ", counted from 0");
  }
  return static_cast<std::size_t>(number);
}

Element Element::referred(const Element& root, std::string_view name) const {
  const std::optional<Element> array = root.find(name);
  const std::size_t i = index(array ? array->size() : 0);
  return (*array)[i];
}

std::optional<Element> Element::find(std::string_view name) const {
  check_object();
  const auto member = value_->find(name);
  if (member == value_->end()) return std::nullopt;
  return Element(*member, origin_, pointer_ + "/" + pointer_part(name));
}

Element Element::at(std::string_view name) const {
  const std::optional<Element> member = find(name);
  if (!member) fail("there is no \"" + std::string(name) + "\" here");
  return *member;
}

std::vector<Element> Element::elements(std::string_view name) const {
  std::vector<Element> all;
  const std::optional<Element> member = find(name);
  const std::size_t count = member ? member->size() : 0;
  all.reserve(count);
  for (std::size_t i = 0; i < count; ++i) all.push_back((*member)[i]);
  return all;
}

std::optional<Element> Element::extension(std::string_view name) const {
  const std::optional<Element> extensions = find("extensions");
  return extensions ? extensions->find(name) : std::nullopt;
}

std::optional<double> Element::find_number(std::string_view name) const {
  const std::optional<Element> member = find(name);
  return member ? std::optional<double>(member->number()) : std::nullopt;
}

std::optional<std::string> Element::find_text(std::string_view name) const {
  const std::optional<Element> member = find(name);
  return member ? std::optional<std::string>(member->text()) : std::nullopt;
}

std::optional<std::size_t> Element::find_index(std::string_view name, std::size_t count) const {
  const std::optional<Element> member = find(name);
  return member ? std::optional<std::size_t>(member->index(count)) : std::nullopt;
}

std::optional<std::vector<double>> Element::find_numbers(std::string_view name,
                                                         std::size_t count) const {
  const std::optional<Element> member = find(name);
  if (!member) return std::nullopt;
  if (member->size() != count) {
    member->fail("this must have " + std::to_string(count) + " numbers, not " +
                 std::to_string(member->size()));
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back((*member)[i].number());
  return numbers;
}

float Element::number_or(std::string_view name, double fallback) const {
  return static_cast<float>(find_number(name).value_or(fallback));
}

std::uint64_t Element::whole_or(std::string_view name, std::uint64_t fallback) const {
  const std::optional<Element> member = find(name);
  return member ? member->whole() : fallback;
}

bool Element::flag_or(std::string_view name, bool fallback) const {
  const std::optional<Element> member = find(name);
  if (!member) return fallback;
  if (!member->value_->is_boolean()) member->fail_type("true or false");
  return member->value_->get<bool>();
}

std::string Element::text_or(std::string_view name, const std::string& fallback) const {
  return find_text(name).value_or(fallback);
}

Vec3 Element::vector_or(std::string_view name, const Vec3& fallback) const {
  const std::optional<std::vector<double>> numbers = find_numbers(name, 3);
  return numbers ? Vec3(Vec3d((*numbers)[0], (*numbers)[1], (*numbers)[2])) : fallback;
}

std::vector<std::string> Element::names() const {
  std::vector<std::string> names;
  if (!value_->is_object()) return names;
  for (const auto& [name, member] : value_->items()) names.push_back(name);
  return names;
}

bool Element::mentions(std::string_view end_of_name) const {
  std::vector<const Json*> left{value_};
  while (!left.empty()) {
    const Json& value = *left.back();
    left.pop_back();
    if (value.is_object()) {
      for (const auto& [name, member] : value.items()) {
        if (name.ends_with(end_of_name)) return true;
        left.push_back(&member);
      }
    } else if (value.is_array()) {
      for (const Json& element : value) left.push_back(&element);
    }
  }
  return false;
}

}  // namespace ajar::gltf
