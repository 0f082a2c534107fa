#include "import/obj/words.h"

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <vector>

#include "core/printable_text.h"
#include "import/mesh/text_lines.h"
#include "import/obj/image_words.h"

namespace ajar::obj {
namespace {

constexpr WarningKind kUnused{Effect::Surface, "words of materials are not supported: ignored"};
constexpr WarningKind kUnknownWord{Effect::Slight, "words of materials are unknown and ignored"};
constexpr WarningKind kNoFile{Effect::Surface, "images of materials have no file: ignored"};
constexpr WarningKind kOption{Effect::Surface,
                              "options of images are not supported: the images are as they are"};

/// Words that are read, or have no meaning in a renderer: light is not ambient here.
const std::vector<std::string> kRead = {
    "newmtl", "Ka",     "Kd",     "Ks",     "Ke",     "Kt",     "Tf",    "Ni",       "Ns",
    "d",      "Tr",     "illum",  "Pr",     "Pm",     "norm",   "bump",  "map_bump", "map_Bump",
    "map_Ka", "map_Kd", "map_Ks", "map_Ke", "map_Pr", "map_Pm", "map_d", "map_aat",  "sharpness"};
/// Words with a meaning that is not supported. A number of 0 has none.
const std::vector<std::string> kNotSupported = {
    "Ps", "Pc", "Pcr", "aniso", "anisor", "map_Ps", "map_Ns", "disp", "decal", "refl", "map_refl"};
/// Options of images that are read, and those without effect here: images are sharp, filtered and
/// as large as they are, and bumps have a warning of their own.
constexpr std::array<std::string_view, 11> kOptions = {
    "-s",  "-o",  "-clamp", "-blendu", "-blendv",    "-texres",
    "-cc", "-bm", "-mm",    "-boost",  "-colorspace"};

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> all_words() {
  std::vector<std::string> all = kRead;
  all.insert(all.end(), kNotSupported.begin(), kNotSupported.end());
  return all;
}

/// True if an image of this word becomes a number, of which `-imfchan` says the channel.
bool is_of_numbers(std::string_view keyword) {
  return keyword == "map_d" || keyword == "map_Pr" || keyword == "map_Pm";
}

/// True if an option changes nothing, or is supported.
bool is_read(std::string_view keyword, const ImageOption& option) {
  if (option.name == "-imfchan") {
    const std::string_view channel = option.values.empty() ? "" : option.values.front();
    return is_of_numbers(keyword) && channel.size() == 1 && channel != "z";
  }
  if (option.name == "-t") {
    return std::all_of(option.values.begin(), option.values.end(),
                       [](const std::string& value) { return number_in(value) == 0.F; });
  }
  return std::find(kOptions.begin(), kOptions.end(), option.name) != kOptions.end();
}

class Check {
 public:
  Check(const std::string& name, Warnings& warnings)
      : file_(std::make_shared<const std::string>(name)), warnings_(warnings) {}

  void line(int number, std::string_view line) {
    LineWords words(line);
    const std::string keyword(words.word());
    if (keyword.empty() || keyword.starts_with('#')) return;
    const SourceLocation where{file_, number, 1};
    const std::string shown = printable_line(keyword);
    if (contains(kNotSupported, keyword)) {
      const std::string_view rest = words.rest();
      const std::optional<float> value = number_in(rest);
      if (value && *value == 0.F) return;
      tell(keyword, kUnused, where, "\"" + shown + "\" is not supported: ignored", shown);
    } else if (!contains(kRead, keyword)) {
      const std::string nearest = nearest_name(keyword, all_words());
      tell(keyword, kUnknownWord, where,
           "\"" + shown + "\" is no word of material files" +
               (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?") + ": ignored",
           shown);
    } else if (names_image(keyword)) {
      options(where, keyword, words.rest());
    }
  }

 private:
  void options(const SourceLocation& where, std::string_view keyword, std::string_view rest) {
    const ImageWords words = image_words(rest);
    if (words.file.empty()) {
      tell("file of " + std::string(keyword), kNoFile, where,
           "\"" + std::string(keyword) + "\" names no file: ignored", std::string(keyword));
    }
    for (const ImageOption& option : words.options) {
      if (is_read(keyword, option)) continue;
      const std::string shown = printable_line(option.name);
      tell(option.name, kOption, where,
           "the option \"" + shown + "\" of this image is not supported: ignored", shown);
    }
  }

  void tell(const std::string& word, const WarningKind& kind, const SourceLocation& where,
            const std::string& message, const std::string& shown) {
    if (told_.insert(word).second) warnings_.add(kind, where, message, shown);
  }

  std::shared_ptr<const std::string> file_;
  Warnings& warnings_;
  std::set<std::string> told_;
};

}  // namespace

void check_material_words(std::string_view text, const std::string& name, Warnings& warnings) {
  Check check(name, warnings);
  TextLines lines(text);
  while (lines.next()) check.line(lines.number(), lines.line());
}

std::string remark_on_unread(std::string_view keyword) {
  // Names and groups, and continuations of keywords with a warning of their own.
  static const std::vector<std::string> kNoLoss = {
      "o",     "g",        "s",        "mg",         "usemap",    "maplib", "lod",
      "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "cstype", "deg",
      "bmat",  "step",     "parm",     "trim",       "hole",      "scrv",   "sp",
      "end",   "con",      "ctech",    "stech",      "vp"};
  static const std::vector<std::string> kShapes = {"l", "p", "curv", "curv2", "surf"};
  static const std::vector<std::string> kAll = {"v", "vt", "vn", "f", "usemtl", "mtllib"};
  if (contains(kNoLoss, keyword)) return {};
  if (contains(kShapes, keyword)) {
    return "\"" + std::string(keyword) + "\": points, lines, curves and free surfaces are left out";
  }
  const std::string nearest = nearest_name(keyword, kAll);
  return "\"" + printable_line(keyword) + "\" is no word of OBJ files" +
         (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?") + ": ignored";
}

}  // namespace ajar::obj
