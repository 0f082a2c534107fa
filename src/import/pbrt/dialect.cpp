#include "import/pbrt/dialect.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "core/printable_text.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {

struct Word {
  std::string_view word;
  Dialect dialect;
};

constexpr std::array<Word, 4> kFilms = {{{"image", Dialect::V3},
                                         {"rgb", Dialect::V4},
                                         {"gbuffer", Dialect::V4},
                                         {"spectral", Dialect::V4}}};
constexpr std::array<Word, 5> kDirectives = {{{"WorldEnd", Dialect::V3},
                                              {"Option", Dialect::V4},
                                              {"ColorSpace", Dialect::V4},
                                              {"Attribute", Dialect::V4},
                                              {"Import", Dialect::V4}}};
/// Names of types that stand as strings behind a directive, or behind "string type".
constexpr std::array<Word, 43> kTypes = {{{"matte", Dialect::V3},
                                          {"plastic", Dialect::V3},
                                          {"metal", Dialect::V3},
                                          {"glass", Dialect::V3},
                                          {"mirror", Dialect::V3},
                                          {"substrate", Dialect::V3},
                                          {"uber", Dialect::V3},
                                          {"translucent", Dialect::V3},
                                          {"disney", Dialect::V3},
                                          {"fourier", Dialect::V3},
                                          {"kdsubsurface", Dialect::V3},
                                          {"heterogeneous", Dialect::V3},
                                          {"random", Dialect::V3},
                                          {"02sequence", Dialect::V3},
                                          {"lowdiscrepancy", Dialect::V3},
                                          {"maxmindist", Dialect::V3},
                                          {"environment", Dialect::V3},
                                          {"exinfinite", Dialect::V3},
                                          {"cone", Dialect::V3},
                                          {"hyperboloid", Dialect::V3},
                                          {"paraboloid", Dialect::V3},
                                          {"heightfield", Dialect::V3},
                                          {"nurbs", Dialect::V3},
                                          {"coateddiffuse", Dialect::V4},
                                          {"coatedconductor", Dialect::V4},
                                          {"conductor", Dialect::V4},
                                          {"dielectric", Dialect::V4},
                                          {"thindielectric", Dialect::V4},
                                          {"diffusetransmission", Dialect::V4},
                                          {"measured", Dialect::V4},
                                          {"interface", Dialect::V4},
                                          {"uniformgrid", Dialect::V4},
                                          {"rgbgrid", Dialect::V4},
                                          {"cloud", Dialect::V4},
                                          {"nanovdb", Dialect::V4},
                                          {"independent", Dialect::V4},
                                          {"paddedsobol", Dialect::V4},
                                          {"pmj02bn", Dialect::V4},
                                          {"zsobol", Dialect::V4},
                                          {"spherical", Dialect::V4},
                                          {"bilinearmesh", Dialect::V4},
                                          {"directionmix", Dialect::V4}}};
/// Words that both versions have, but not behind the same directives.
struct Typed {
  std::string_view directive, word;
  Dialect dialect;
};
constexpr std::array<Typed, 7> kTyped = {{{"Material", "diffuse", Dialect::V4},
                                          {"MakeNamedMaterial", "diffuse", Dialect::V4},
                                          {"Material", "none", Dialect::V3},
                                          {"PixelFilter", "float xwidth", Dialect::V3},
                                          {"PixelFilter", "float ywidth", Dialect::V3},
                                          {"PixelFilter", "float xradius", Dialect::V4},
                                          {"PixelFilter", "float yradius", Dialect::V4}}};

template <std::size_t Size>
std::optional<Dialect> find(const std::array<Word, Size>& words, std::string_view word) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](const Word& known) { return known.word == word; });
  return found == words.end() ? std::nullopt : std::optional(found->dialect);
}

std::optional<Dialect> find_typed(std::string_view directive, std::string_view word) {
  const auto found = std::find_if(kTyped.begin(), kTyped.end(), [&](const Typed& known) {
    return known.directive == directive && known.word == word;
  });
  return found == kTyped.end() ? std::nullopt : std::optional(found->dialect);
}

/// Kind of the decisive word, the strongest first.
enum class Evidence { Film, Directive, Type, None };

/// Reads words of files until one is decisive.
class Scan {
 public:
  explicit Scan(FileAccess& files) : files_(files) {}

  DialectChoice run(std::string_view text, const std::string& name) {
    scan(text, name);
    for (std::size_t i = 0; strongest_ == Evidence::None && i < included_.size(); ++i) {
      if (i >= kMostIncludes) break;
      try {
        const std::string path = files_.resolve(included_[i]);
        const FileBytes bytes = files_.load_text(path);
        scan(bytes.view(), included_[i]);
      } catch (const Error&) {  // reported when the file is parsed
      }
    }
    return choice_;
  }

 private:
  static constexpr std::size_t kMostIncludes = 16;

  void scan(std::string_view text, const std::string& name) {
    try {
      Lexer lexer(std::make_shared<const std::string>(name), text);
      Token directive;
      for (Token token = lexer.next(); token.kind != TokenKind::End; token = lexer.next()) {
        if (strongest_ == Evidence::Film) return;
        if (token.kind == TokenKind::Word) {
          if (!token.text.empty() && token.text[0] >= 'A' && token.text[0] <= 'Z') {
            directive = token;
            is_first_string_ = true;
            take(Evidence::Directive, find(kDirectives, token.text), lexer, token, token.text, "");
          }
        } else if (token.kind == TokenKind::String) {
          string(lexer, directive, token);
        }
      }
    } catch (const SceneError&) {  // reported when the file is parsed
    }
  }

  void string(const Lexer& lexer, const Token& directive, const Token& token) {
    const std::string_view word = token.text;
    const bool is_include = directive.text == "Include";
    if (is_include && is_first_string_) included_.emplace_back(word);
    const bool names_type = is_first_string_ || previous_ == "string type" ||
                            (directive.text == "Texture" && strings_behind_directive_ < 3);
    strings_behind_directive_ = is_first_string_ ? 1 : strings_behind_directive_ + 1;
    is_first_string_ = false;
    previous_ = word;
    if (directive.text == "Film" && names_type) {
      take(Evidence::Film, find(kFilms, word), lexer, token, directive.text, word);
    } else if (const auto typed = find_typed(directive.text, word)) {
      take(Evidence::Type, typed, lexer, token, directive.text, word);
    } else if (names_type && !is_name(directive.text)) {
      take(Evidence::Type, find(kTypes, word), lexer, token, directive.text, word);
    }
  }

  /// Directives whose first string is a name that the scene's author chose.
  bool is_name(std::string_view directive) const {
    constexpr std::array<std::string_view, 8> kNaming = {
        "MakeNamedMaterial", "NamedMaterial",    "MakeNamedMedium",   "ObjectBegin",
        "ObjectInstance",    "CoordinateSystem", "CoordSysTransform", "MediumInterface"};
    const bool is_naming = std::find(kNaming.begin(), kNaming.end(), directive) != kNaming.end() ||
                           directive == "Include" || directive == "Texture";
    const std::size_t names = directive == "Texture" ? 2 : 1;
    return is_naming && strings_behind_directive_ <= names;
  }

  void take(Evidence evidence, std::optional<Dialect> dialect, const Lexer& lexer,
            const Token& token, std::string_view directive, std::string_view word) {
    if (!dialect || evidence >= strongest_) return;
    strongest_ = evidence;
    choice_ = {*dialect, lexer.where(token), std::string(directive)};
    if (!word.empty()) choice_.word += " \"" + printable(word) + "\"";
  }

  FileAccess& files_;
  DialectChoice choice_;
  Evidence strongest_ = Evidence::None;
  std::vector<std::string> included_;
  std::string_view previous_;
  std::size_t strings_behind_directive_ = 0;
  bool is_first_string_ = false;
};

}  // namespace

std::string_view name_of(Dialect dialect) { return dialect == Dialect::V3 ? "pbrt-v3" : "pbrt-v4"; }

DialectChoice tell_dialect(std::string_view text, const std::string& name, FileAccess& files) {
  return Scan(files).run(text, name);
}

std::optional<Dialect> dialect_of_word(std::string_view word) {
  if (const auto film = find(kFilms, word)) return film;
  if (const auto directive = find(kDirectives, word)) return directive;
  if (word == "diffuse") return Dialect::V4;
  return find(kTypes, word);
}

}  // namespace ajar::pbrt
