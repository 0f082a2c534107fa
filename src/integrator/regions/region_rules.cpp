#include "integrator/regions/region_rules.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>

namespace ajar {

namespace {

/// Lists of more names than this are not shown in messages: scenes have thousands of objects.
constexpr std::size_t kMostNamesShown = 30;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

struct Word {
  std::string text;
  SourceLocation where;
  bool quoted = false;
};

/// The words of one line.
class LineReader {
 public:
  LineReader(std::string_view line, SourceLocation start) : line_(line), start_(std::move(start)) {}

  /// Empty at the end of the line or where a comment begins.
  std::optional<Word> next() {
    while (at_ < line_.size() && is_space(line_[at_])) ++at_;
    if (at_ == line_.size() || line_[at_] == '#') return std::nullopt;
    const SourceLocation where = here();
    if (line_[at_] == '"') return quoted_word(where);
    const std::size_t first = at_;
    while (at_ < line_.size() && !is_space(line_[at_])) ++at_;
    return Word{std::string(line_.substr(first, at_ - first)), where, false};
  }

  /// Columns are counted in bytes.
  SourceLocation here() const {
    SourceLocation where = start_;
    where.column += static_cast<int>(at_);
    return where;
  }

 private:
  Word quoted_word(const SourceLocation& where) {
    const std::size_t end = line_.find('"', at_ + 1);
    if (end == std::string_view::npos) throw SceneError(where, "this quotation mark is not closed");
    Word word{std::string(line_.substr(at_ + 1, end - at_ - 1)), where, true};
    at_ = end + 1;
    if (at_ < line_.size() && !is_space(line_[at_])) {
      throw SceneError(here(), "expected a space after the closing quotation mark");
    }
    return word;
  }

  std::string_view line_;
  SourceLocation start_;
  std::size_t at_ = 0;
};

Word require_word(LineReader& reader, const std::string& expected) {
  std::optional<Word> word = reader.next();
  if (!word) throw SceneError(reader.here(), "expected " + expected);
  return *std::move(word);
}

RegionRule::Subject parse_subject(const Word& word) {
  static const std::vector<std::string> kSubjects = {"object", "material"};
  if (!word.quoted && word.text == kSubjects[0]) return RegionRule::Subject::Object;
  if (!word.quoted && word.text == kSubjects[1]) return RegionRule::Subject::Material;
  throw SceneError(word.where, unknown_name_message("subject of a rule", word.text, kSubjects));
}

/// The whole text as a number.
std::optional<float> parse_number(const std::string& text) {
  float value = 0.F;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

void parse_choice(const Word& word, RegionRule& rule) {
  static const std::vector<std::string> kChoices = {"auto", "omc", "chain"};
  constexpr std::array kValues = {RegionRule::Choice::Auto, RegionRule::Choice::Omc,
                                  RegionRule::Choice::Chain};
  if (const std::optional<float> weight = parse_number(word.text)) {
    // Written so that NaN fails.
    if (!(*weight >= 0.F && *weight <= 1.F)) {
      throw SceneError(word.where, "the weight " + word.text + " is not between 0 and 1");
    }
    rule.choice = RegionRule::Choice::Weight;
    rule.weight = *weight;
    return;
  }
  const auto found = std::find(kChoices.begin(), kChoices.end(), word.text);
  if (found == kChoices.end()) {
    throw SceneError(word.where, unknown_name_message("choice", word.text, kChoices) +
                                     ", or a weight between 0 and 1");
  }
  rule.choice = kValues[static_cast<std::size_t>(found - kChoices.begin())];
}

std::optional<RegionRule> parse_line(LineReader& reader) {
  const std::optional<Word> subject = reader.next();
  if (!subject) return std::nullopt;
  RegionRule rule;
  rule.subject = parse_subject(*subject);
  Word name = require_word(reader, "the name of an object or a material");
  rule.pattern = std::move(name.text);
  rule.where = std::move(name.where);
  if (rule.pattern.empty()) throw SceneError(rule.where, "the name is empty");
  parse_choice(require_word(reader, "auto, omc, chain, or a weight between 0 and 1"), rule);
  if (const std::optional<Word> rest = reader.next()) {
    throw SceneError(rest->where, "\"" + rest->text +
                                      "\" is too much: a rule is a subject, a name and a choice "
                                      "(names with spaces are quoted)");
  }
  return rule;
}

std::string unmatched_message(const RegionRule& rule, std::span<const std::string> names) {
  const std::string kind = rule.subject == RegionRule::Subject::Object ? "object" : "material";
  if (names.size() <= kMostNamesShown) return unknown_name_message(kind, rule.pattern, names);
  const std::string nearest = nearest_name(rule.pattern, names);
  return "unknown " + kind + " \"" + rule.pattern + "\"" +
         (nearest.empty() ? std::string() : "; did you mean \"" + nearest + "\"?");
}

}  // namespace

std::vector<RegionRule> parse_region_rules(std::string_view text, const std::string& file) {
  const auto name = std::make_shared<const std::string>(file);
  std::vector<RegionRule> rules;
  // Some editors mark a text as UTF-8.
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    LineReader reader(text.substr(0, end), {name, line, 1});
    if (std::optional<RegionRule> rule = parse_line(reader)) rules.push_back(*std::move(rule));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return rules;
}

void check_region_rules(std::span<const RegionRule> rules, std::span<const std::string> objects,
                        std::span<const std::string> materials) {
  for (const RegionRule& rule : rules) {
    const auto names = rule.subject == RegionRule::Subject::Object ? objects : materials;
    if (std::none_of(names.begin(), names.end(), [&](const std::string& name) {
          return matches_pattern(rule.pattern, name);
        })) {
      throw SceneError(rule.where, unmatched_message(rule, names));
    }
  }
}

bool matches_pattern(std::string_view pattern, std::string_view name) {
  // Only the last star need ever take more: what came before it has matched as early as possible.
  std::size_t p = 0;
  std::size_t n = 0;
  std::size_t star = std::string_view::npos;
  std::size_t star_end = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_end = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++star_end;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

const RegionRule* find_region_rule(std::span<const RegionRule> rules, std::string_view object,
                                   std::string_view material) {
  const auto found = std::find_if(rules.rbegin(), rules.rend(), [&](const RegionRule& rule) {
    return matches_pattern(rule.pattern,
                           rule.subject == RegionRule::Subject::Object ? object : material);
  });
  return found == rules.rend() ? nullptr : &*found;
}

std::optional<float> fixed_weight(const RegionRule& rule, float epsilon) {
  switch (rule.choice) {
    case RegionRule::Choice::Omc:
      return epsilon;
    case RegionRule::Choice::Chain:
      return 1.F;
    case RegionRule::Choice::Weight:
      return rule.weight;
    case RegionRule::Choice::Auto:
      break;
  }
  return std::nullopt;
}

}  // namespace ajar
