#include "transport/technique_set.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/number_text.h"

namespace ajar {

namespace {

const std::string kWhatIsAllowed =
    "a list of pt, lt, ibpt, bdpt, implicit, explicit, light, inner and (s,t) pairs such as (2,3) "
    "or (2,*), each with an optional count such as explicit*4";

[[noreturn]] void reject(const std::string& item, const std::string& why) {
  throw UsageError("techniques: \"" + item + "\" " + why + "; valid is " + kWhatIsAllowed);
}

/// Commas inside parentheses do not separate.
std::vector<std::string> split_items(const std::string& text) {
  std::vector<std::string> items(1);
  int parentheses = 0;
  for (const char c : text) {
    parentheses += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && parentheses == 0) {
      items.emplace_back();
    } else if (c != ' ') {
      items.back() += c;
    }
  }
  return items;
}

std::optional<double> number(const std::string& text) {
  const std::optional<double> value = number_of(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Cuts a trailing "*n" off, which "(2,*)" does not have.
double take_count(const std::string& item, std::string& name) {
  const std::size_t star = item.rfind('*');
  const std::size_t close = item.rfind(')');
  name = item;
  if (star == std::string::npos || (close != std::string::npos && star < close)) return 1.0;
  name = item.substr(0, star);
  const std::optional<double> count = number(item.substr(star + 1));
  if (!count || !(*count > 0.0)) reject(item, "has a count that is not a number above zero");
  return *count;
}

int subpath_vertices(const std::string& item, const std::string& text) {
  if (text == "*") return TechniqueSet::kAny;
  const std::optional<double> value = number(text);
  if (!value || *value != std::floor(*value) || *value < 0.0 || *value > 1e5) {
    reject(item, "is not a pair of vertex counts");
  }
  return static_cast<int>(*value);
}

TechniqueSet::Rule parse_pair(const std::string& item, const std::string& name, double count) {
  const std::size_t comma = name.find(',');
  if (comma == std::string::npos || name.back() != ')') reject(item, "is not a pair (s,t)");
  const TechniqueSet::Rule rule{
      subpath_vertices(item, name.substr(1, comma - 1)),
      subpath_vertices(item, name.substr(comma + 1, name.size() - comma - 2)), count};
  if (rule.t == 0) reject(item, "asks light paths to run into the lens, which they never do");
  const bool exact = rule.s != TechniqueSet::kAny && rule.t != TechniqueSet::kAny;
  if (exact && rule.s + rule.t < 3 && rule.t != 2) {
    reject(item, "is no technique: light and lens are not connected directly");
  }
  return rule;
}

/// Counts are allowed only where a technique can be tried again.
void check_count(const std::string& item, TechniqueClass kind, double count) {
  if (kind == TechniqueClass::Implicit && count != 1.0) {
    reject(item, "cannot have a count: a camera path runs into lights by itself");
  }
  if (kind == TechniqueClass::NextEvent && count > TechniqueSet::kMaxNextEventCount) {
    reject(item, "has a count above 32");
  }
  if ((kind == TechniqueClass::Light || kind == TechniqueClass::Inner) && count > 1.0) {
    reject(item,
           "has a count above 1: the same connection again brings nothing; raise "
           "light-paths-per-pixel instead");
  }
}

std::vector<TechniqueClass> classes_of(const TechniqueSet::Rule& rule) {
  std::vector<TechniqueClass> result;
  for (int s = 0; s <= 2; ++s) {
    for (int t = 1; t <= 3; ++t) {
      // The small pairs represent all larger ones.
      const bool same_s = rule.s == TechniqueSet::kAny || std::min(rule.s, 2) == s;
      const bool same_t = rule.t == TechniqueSet::kAny || std::min(rule.t, 3) == t;
      if (same_s && same_t && s + t >= 3) result.push_back(class_of({s, t}));
    }
  }
  return result;
}

struct Named {
  std::string name;
  std::vector<TechniqueClass> classes;
};
const std::vector<Named>& named_sets() {
  using enum TechniqueClass;
  static const std::vector<Named> kNamed = {{"pt", {Implicit, NextEvent}},
                                            {"lt", {Light}},
                                            {"ibpt", {Implicit, NextEvent, Light}},
                                            {"bdpt", {Implicit, NextEvent, Light, Inner}},
                                            {"implicit", {Implicit}},
                                            {"explicit", {NextEvent}},
                                            {"light", {Light}},
                                            {"inner", {Inner}}};
  return kNamed;
}

}  // namespace

std::string_view name_of(TechniqueClass kind) {
  constexpr ByTechniqueClass<std::string_view> kNames = {"implicit", "explicit", "light", "inner"};
  static_assert(!kNames.back().empty());
  return kNames[index_of(kind)];
}

TechniqueSet::TechniqueSet(const ByTechniqueClass<double>& counts, std::vector<Rule> rules)
    : counts_(counts), rules_(std::move(rules)) {
  // Exact pairs take precedence over pairs with a wildcard, in any order.
  std::stable_partition(rules_.begin(), rules_.end(),
                        [](const Rule& rule) { return rule.s != kAny && rule.t != kAny; });
  for (std::size_t i = 0; i < any_.size(); ++i) any_[i] = counts_[i] > 0.0;
  for (const Rule& rule : rules_) {
    for (const TechniqueClass kind : classes_of(rule)) any_[index_of(kind)] = true;
  }
}

bool TechniqueSet::tries_once() const {
  const auto once = [](double count) { return count == 0.0 || count == 1.0; };
  return std::all_of(counts_.begin(), counts_.end(), once) &&
         std::all_of(rules_.begin(), rules_.end(),
                     [&](const Rule& rule) { return once(rule.count); });
}

TechniqueSet TechniqueSet::parse(const std::string& text) {
  ByTechniqueClass<double> counts{};
  std::vector<Rule> rules;
  for (const std::string& item : split_items(text)) {
    std::string name;
    const double count = take_count(item, name);
    if (name.starts_with('(')) {
      rules.push_back(parse_pair(item, name, count));
      for (const TechniqueClass kind : classes_of(rules.back())) check_count(item, kind, count);
      continue;
    }
    const auto& named = named_sets();
    const auto found = std::find_if(named.begin(), named.end(),
                                    [&](const Named& set) { return set.name == name; });
    if (found == named.end()) {
      std::vector<std::string> names;
      names.reserve(named.size());
      for (const Named& set : named) names.push_back(set.name);
      throw UsageError(unknown_name_message("technique", name, names) +
                       ", and pairs such as (2,3) or (2,*)");
    }
    for (const TechniqueClass kind : found->classes) {
      check_count(item, kind, count);
      counts[index_of(kind)] = count;
    }
  }
  return TechniqueSet(counts, std::move(rules));
}

}  // namespace ajar
