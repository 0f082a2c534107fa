#include "core/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/error.h"
#include "core/number_text.h"

namespace ajar {

namespace {

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<bool> parse_bool(std::string_view text) {
  if (text == "true" || text == "on" || text == "yes" || text == "1") return true;
  if (text == "false" || text == "off" || text == "no" || text == "0") return false;
  return std::nullopt;
}

[[noreturn]] void reject(const ParameterSpec& spec, const std::string& given,
                         const std::string& expected) {
  throw UsageError("parameter \"" + spec.name + "\" must be " + expected + ", not \"" + given +
                   "\" (" + spec.help + ")");
}

void check_range(const ParameterSpec& spec, const std::string& given, double value) {
  if (!in_range(spec, value)) reject(spec, given, range_text(spec));
}

/// The value in the one spelling that the getters and the statistics use.
std::string checked_value(const ParameterSpec& spec, const std::string& given) {
  switch (spec.type) {
    case ParameterType::Bool: {
      const auto value = parse_bool(given);
      if (!value) reject(spec, given, "true or false");
      return *value ? "true" : "false";
    }
    case ParameterType::Int: {
      const auto value = parse_number<int>(given);
      if (!value) reject(spec, given, "a whole number");
      check_range(spec, given, *value);
      return std::to_string(*value);
    }
    case ParameterType::Float: {
      if (std::find(spec.choices.begin(), spec.choices.end(), given) != spec.choices.end()) {
        return given;
      }
      const auto value = parse_number<double>(given);
      if (!value || !std::isfinite(*value)) {
        std::string expected = "a number";
        for (const std::string& word : spec.choices) expected.append(" or ").append(word);
        reject(spec, given, expected);
      }
      check_range(spec, given, *value);
      return given;
    }
    case ParameterType::Choice:
      if (std::find(spec.choices.begin(), spec.choices.end(), given) == spec.choices.end()) {
        throw UsageError(
            unknown_name_message("value of parameter " + spec.name, given, spec.choices));
      }
      return given;
    case ParameterType::Text:
      return given;
    default:
      throw std::logic_error("parameter \"" + spec.name + "\" is of a type for scenes only");
  }
}

const std::string& value_of(const std::map<std::string, std::string, std::less<>>& values,
                            std::string_view name) {
  const auto found = values.find(name);
  if (found == values.end()) {
    throw std::logic_error("parameter \"" + std::string(name) + "\" is not declared");
  }
  return found->second;
}

}  // namespace

bool ParameterSpec::matters_with(const std::string& value) const {
  return std::find(matters_for.begin(), matters_for.end(), value) != matters_for.end();
}

bool in_range(const ParameterSpec& spec, double value) {
  if (spec.open_range) return value > spec.minimum && value < spec.maximum;
  return value >= spec.minimum && value <= spec.maximum;
}

std::string range_text(const ParameterSpec& spec) {
  const bool has_minimum = spec.minimum > -1e300;
  const bool has_maximum = spec.maximum < 1e300;
  if (has_minimum && has_maximum) {
    return "between " + number_text(spec.minimum) + " and " + number_text(spec.maximum) +
           (spec.open_range ? ", both excluded" : "");
  }
  if (has_minimum) return "at least " + number_text(spec.minimum);
  return has_maximum ? "at most " + number_text(spec.maximum) : "";
}

ParameterSpec number_parameter(std::string name, std::string value, std::string help,
                               double maximum, std::vector<std::string> words) {
  return {.name = std::move(name),
          .type = ParameterType::Float,
          .default_value = std::move(value),
          .unit = "",
          .help = std::move(help),
          .choices = std::move(words),
          .minimum = 0.0,
          .maximum = maximum};
}

ParameterSpec choice_parameter(std::string name, std::vector<std::string> choices,
                               std::string help) {
  std::string first = choices.front();
  return {.name = std::move(name),
          .type = ParameterType::Choice,
          .default_value = std::move(first),
          .unit = "",
          .help = std::move(help),
          .choices = std::move(choices)};
}

void mark_experts(std::span<ParameterSpec> specs, std::initializer_list<std::string_view> basic) {
  for (ParameterSpec& spec : specs) spec.expert = true;
  for (const std::string_view name : basic) {
    const auto found = std::find_if(specs.begin(), specs.end(),
                                    [&](const ParameterSpec& spec) { return spec.name == name; });
    if (found == specs.end()) {
      throw std::logic_error("there is no parameter \"" + std::string(name) + "\" to be basic");
    }
    found->expert = false;
  }
}

Parameters::Parameters(std::span<const ParameterSpec> specs,
                       const std::map<std::string, std::string>& given)
    : given_(given) {
  std::vector<std::string> names;
  names.reserve(specs.size());
  for (const ParameterSpec& spec : specs) names.push_back(spec.name);
  for (const auto& [name, value] : given) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw UsageError(names.empty() ? "unknown parameter \"" + name + "\": there are none to set"
                                     : unknown_name_message("parameter", name, names));
    }
  }
  for (const ParameterSpec& spec : specs) {
    const auto found = given.find(spec.name);
    values_[spec.name] =
        checked_value(spec, found == given.end() ? spec.default_value : found->second);
  }
}

bool Parameters::get_bool(std::string_view name) const {
  return parse_bool(value_of(values_, name)).value();
}

int Parameters::get_int(std::string_view name) const {
  return parse_number<int>(value_of(values_, name)).value();
}

double Parameters::get_float(std::string_view name) const { return get_number(name).value(); }

std::optional<double> Parameters::get_number(std::string_view name) const {
  return parse_number<double>(value_of(values_, name));
}

const std::string& Parameters::get_text(std::string_view name) const {
  return value_of(values_, name);
}

}  // namespace ajar
