#include "import/obj/image_words.h"

#include <algorithm>
#include <array>
#include <optional>

#include "import/mesh/text_lines.h"

namespace ajar::obj {
namespace {

/// Values of an option.
enum class Values { Numbers, Switch, Word };
struct Form {
  std::string_view name;
  Values values;
  std::size_t most;
  std::string_view otherwise;  ///< for numbers that are left out
  bool is_taken = true;        ///< tinyobjloader has it, and it has an effect here
};
constexpr std::array<Form, 13> kForms = {{{"-o", Values::Numbers, 3, "0"},
                                          {"-s", Values::Numbers, 3, "1"},
                                          {"-t", Values::Numbers, 3, "0", false},
                                          {"-mm", Values::Numbers, 2, "1"},
                                          {"-bm", Values::Numbers, 1, "1"},
                                          {"-boost", Values::Numbers, 1, "0", false},
                                          {"-texres", Values::Numbers, 1, "0", false},
                                          {"-clamp", Values::Switch, 1, ""},
                                          {"-blendu", Values::Switch, 1, "", false},
                                          {"-blendv", Values::Switch, 1, "", false},
                                          {"-cc", Values::Switch, 1, "", false},
                                          {"-imfchan", Values::Word, 1, ""},
                                          {"-colorspace", Values::Word, 1, ""}}};

const Form* form_of(std::string_view name) {
  const auto found = std::find_if(kForms.begin(), kForms.end(),
                                  [&](const Form& form) { return form.name == name; });
  return found == kForms.end() ? nullptr : &*found;
}

bool is_value(std::string_view word, Values values) {
  if (values == Values::Numbers) return number_in(word).has_value();
  return values == Values::Word || word == "on" || word == "off";
}

/// A word, and where it is in the text.
struct Word {
  std::string_view text;
  std::size_t begin, end;
};
std::vector<Word> words_in(std::string_view text) {
  std::vector<Word> words;
  LineWords line(text);
  for (std::string_view word = line.word(); !word.empty(); word = line.word()) {
    const auto begin = static_cast<std::size_t>(word.data() - text.data());
    words.push_back({word, begin, begin + word.size()});
  }
  return words;
}

/// The option that begins at word `i`, which moves behind it. `is_before_name`: the last word is
/// the name in any case, and unknown options are accepted.
std::optional<ImageOption> take_option(const std::vector<Word>& words, std::size_t& i,
                                       bool is_before_name) {
  const std::size_t end = words.size() - (is_before_name ? 1 : 0);
  if (i >= end) return std::nullopt;
  const std::string_view name = words[i].text;
  const bool is_option = name.size() > 1 && name[0] == '-' && name[1] >= 'a' && name[1] <= 'z';
  const Form* form = form_of(name);
  if (!is_option || (form == nullptr && !is_before_name)) return std::nullopt;
  ImageOption option{std::string(name), {}};
  // An unknown option takes numbers, and a word that others have for their values.
  const std::size_t most = form == nullptr ? 3 : form->most;
  std::size_t next = i + 1;
  const auto fits = [&](std::string_view word) {
    if (form != nullptr) return is_value(word, form->values);
    return is_value(word, Values::Numbers) || is_value(word, Values::Switch);
  };
  while (next < end && option.values.size() < most && fits(words[next].text)) {
    option.values.emplace_back(words[next++].text);
  }
  if (form != nullptr && option.values.empty() && !is_before_name) return std::nullopt;
  i = next;
  return option;
}

}  // namespace

ImageWords image_words(std::string_view text) {
  const std::vector<Word> words = words_in(text);
  ImageWords result;
  if (words.empty()) return result;
  std::size_t first = 0;
  while (std::optional<ImageOption> option = take_option(words, first, true)) {
    // "-type sphere": its word is no name, as another one follows.
    if (option->name == "-type" && first + 1 < words.size()) {
      option->values.emplace_back(words[first++].text);
    }
    result.options.push_back(std::move(*option));
  }
  if (first >= words.size()) return result;
  std::size_t last = first;
  for (std::size_t i = first + 1; i < words.size(); ++i) {
    // Options behind the name go on to the end.
    std::vector<ImageOption> behind;
    std::size_t at = i;
    while (std::optional<ImageOption> option = take_option(words, at, false)) {
      behind.push_back(std::move(*option));
    }
    if (!behind.empty() && at == words.size()) {
      result.options.insert(result.options.end(), behind.begin(), behind.end());
      break;
    }
    // Options that begin within such a run end where it does: none of them need be tried again.
    if (!behind.empty()) i = at - 1;
    last = i;
  }
  result.file = text.substr(words[first].begin, words[last].end - words[first].begin);
  return result;
}

std::string in_full(const ImageWords& words) {
  std::string text;
  for (const ImageOption& option : words.options) {
    const Form* form = form_of(option.name);
    if (form == nullptr || !form->is_taken || option.values.empty()) continue;
    if (option.name == "-imfchan") {
      // "m" is tinyobjloader's default, too.
      const std::string& channel = option.values.front();
      text += option.name + (channel == "m" ? " a " : " " + channel + " ");
      continue;
    }
    text += option.name + " ";
    for (std::size_t i = 0; i < form->most; ++i) {
      text += i < option.values.size() ? option.values[i] : std::string(form->otherwise);
      text += " ";
    }
  }
  return text + words.file;
}

bool names_image(std::string_view keyword) {
  return keyword.starts_with("map_") || keyword == "bump" || keyword == "norm" ||
         keyword == "disp" || keyword == "decal" || keyword == "refl";
}

}  // namespace ajar::obj
