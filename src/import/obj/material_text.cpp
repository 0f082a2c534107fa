#include "import/obj/material_text.h"

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include "core/printable_text.h"
#include "import/mesh/text_lines.h"
#include "import/obj/image_words.h"

namespace ajar::obj {
namespace {

constexpr WarningKind kNoNumber{Effect::Surface, "values of materials are no numbers: ignored"};
constexpr WarningKind kRange{Effect::Surface, "colours of materials are beyond 0 to 1: clamped"};
constexpr WarningKind kTwice{Effect::Surface, "materials are there twice: the first counts"};

template <typename Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

constexpr std::string_view kColors[] = {"Ka", "Kd", "Ks", "Ke", "Kt", "Tf"};
constexpr std::string_view kShares[] = {"Kd", "Ks", "Kt", "Tf"};
/// Keywords of visible parts, unless they are black.
constexpr std::string_view kVisible[] = {"Kd", "map_Kd", "Ks", "map_Ks", "Ke", "map_Ke"};
constexpr std::string_view kNumbers[] = {"Ni", "Ns", "d", "Tr", "Pr", "Pm", "illum"};

class Text {
 public:
  Text(const std::string& name, Warnings& warnings)
      : file_(std::make_shared<const std::string>(name)), warnings_(warnings) {}

  void add(int number, std::string_view line) {
    LineWords words(line);
    const std::string keyword(words.word());
    where_ = {file_, number, 1};
    if (keyword == "newmtl") {
      end_material();
      begin_material(words.rest());
    } else if (contains(kColors, keyword)) {
      return add_color(keyword, words.rest(), line);
    } else if (contains(kNumbers, keyword) && !has_number(keyword, words.rest())) {
      return;
    } else if (names_image(keyword)) {
      const ImageWords image = image_words(words.rest());
      if (!image.file.empty()) words_.insert(keyword);
      return append(keyword + " " + in_full(image));
    }
    if (keyword == "illum") illum_ = number_in(LineWords(words.rest()).word()).value_or(0.F);
    if (!keyword.empty()) words_.insert(keyword);
    append(line);
  }
  std::string take() {
    end_material();
    return std::move(text_);
  }

 private:
  void append(std::string_view line) {
    text_ += line;
    text_ += '\n';
  }

  void begin_material(std::string_view name) {
    if (materials_.insert(std::string(name)).second) return;
    const std::string shown = printable_line(name);
    warnings_.add(kTwice, where_,
                  "there is a material \"" + shown + "\" before this one, which counts", shown);
  }

  void end_material() {
    const bool is_hidden = words_.contains("map_Kd") && black_.contains("Kd");
    if (is_hidden) append(std::string(kHiddenImage) + " 1");
    if (words_.contains("map_Kd") && (is_hidden || !words_.contains("Kd"))) append("Kd 1 1 1");
    if (words_.contains("newmtl") && !has_color() && !may_be_glass()) {
      append(std::string(kColorless) + " 1\nKd 0.6 0.6 0.6");
    }
    if (words_.contains("map_Ks") && !words_.contains("Ks")) append("Ks 1 1 1");
    const bool has_gloss = words_.contains("Ks") || words_.contains("map_Ks");
    if (has_gloss && !words_.contains("illum")) append("illum 2");
    words_.clear();
    black_.clear();
    illum_ = 0.F;
  }
  bool has_color() const {
    return std::any_of(std::begin(kVisible), std::end(kVisible), [&](std::string_view word) {
      return words_.contains(word) && (word == "Kd" || !black_.contains(word));
    });
  }
  bool may_be_glass() const {
    const bool is_clear = words_.contains("d") || words_.contains("Tr");
    return illum_ == 6.F || illum_ == 7.F || ((illum_ == 4.F || illum_ == 9.F) && is_clear);
  }

  bool has_number(const std::string& keyword, std::string_view values) {
    LineWords words(values);
    if (number_in(words.word())) return true;
    warnings_.add(kNoNumber, where_,
                  "the value of \"" + keyword + "\" is no number: \"" + printable_line(values) +
                      "\" is ignored",
                  keyword);
    return false;
  }

  void add_color(const std::string& keyword, std::string_view values, std::string_view line) {
    if (!has_number(keyword, values)) return;
    words_.insert(keyword);
    std::vector<float> numbers;
    LineWords words(values);
    for (std::string_view word = words.word(); numbers.size() < 3; word = words.word()) {
      const std::optional<float> number = number_in(word);
      if (!number) break;
      numbers.push_back(*number);
    }
    constexpr float kRounding = 1e-4F;
    const auto is_beyond = [](float v) { return !(v >= -kRounding && v <= 1.F + kRounding); };
    if (contains(kShares, keyword) && std::any_of(numbers.begin(), numbers.end(), is_beyond)) {
      warnings_.add(kRange, where_, "\"" + keyword + "\" must be between 0 and 1: clamped",
                    keyword);
    }
    if (numbers.size() == 2) {
      warnings_.add(kNoNumber, where_,
                    "\"" + keyword + "\" has two numbers, not one or three: the third is 0",
                    keyword);
    }
    const bool is_black = std::ranges::all_of(numbers, [](float v) { return v == 0.F; });
    if (is_black) {
      black_.insert(keyword);
    } else {
      black_.erase(keyword);
    }
    if (numbers.size() > 1) return append(line);
    const std::string grey(LineWords(values).word());
    append(keyword + " " + grey + " " + grey + " " + grey);
  }

  std::shared_ptr<const std::string> file_;
  Warnings& warnings_;
  SourceLocation where_;  ///< start of the line
  std::string text_;
  std::set<std::string, std::less<>> words_;  ///< words of the material
  std::set<std::string, std::less<>> black_;  ///< colours of it
  float illum_ = 0.F;
  std::set<std::string, std::less<>> materials_;
};

}  // namespace

std::string understood_materials(std::string_view text, const std::string& name,
                                 Warnings& warnings) {
  Text result(name, warnings);
  TextLines lines(text);
  while (lines.next()) result.add(lines.number(), lines.line());
  return result.take();
}

}  // namespace ajar::obj
