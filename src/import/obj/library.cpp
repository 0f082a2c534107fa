#include "import/obj/library.h"

#include <sstream>

#include "core/error.h"
#include "core/printable_text.h"
#include "import/mesh/text_lines.h"
#include "import/obj/material_text.h"
#include "import/obj/words.h"

namespace ajar::obj {
namespace {

constexpr WarningKind kNoLibrary{Effect::Surface, "files of materials cannot be read"};
constexpr WarningKind kOddLibrary{Effect::Slight, "files of materials have contradictions"};

/// Where each material begins.
std::map<std::string, SourceLocation> places_of(std::string_view text, const std::string& name) {
  const auto file = std::make_shared<const std::string>(name);
  std::map<std::string, SourceLocation> places;
  TextLines lines(text);
  while (lines.next()) {
    LineWords words(lines.line());
    if (words.word() != "newmtl") continue;
    places.try_emplace(std::string(words.rest()), SourceLocation{file, lines.number(), 1});
  }
  return places;
}

}  // namespace

void Library::load(const SourceLocation& where, std::string_view names) {
  std::string reason;
  const auto load = [&](const std::string& file) {
    if (loaded_.contains(file)) return true;
    if (!load_if_there(where, file, reason)) return false;
    loaded_.insert(file);
    return true;
  };
  if (load(trimmed(names))) return;
  LineWords words(names);
  for (std::string_view word = words.word(); !word.empty(); word = words.word()) {
    const std::string file(word);
    if (load(file)) continue;
    loaded_.insert(file);  // to be missed once
    warnings_.add(kNoLibrary, where, "cannot read these materials: " + reason,
                  printable_line(file));
  }
}

bool Library::load_if_there(const SourceLocation& where, const std::string& file,
                            std::string& reason) {
  try {
    const FileBytes bytes = files_.load_text(files_.resolve_inside(file, where));
    std::istringstream stream{understood_materials(bytes.view(), file, warnings_)};
    std::map<std::string, int> numbers;
    std::vector<tinyobj::material_t> materials;
    std::string remarks;
    tinyobj::LoadMtl(&numbers, &materials, &stream, &remarks, nullptr);
    if (!remarks.empty()) {
      warnings_.add(kOddLibrary, {std::make_shared<const std::string>(file), 0, 0},
                    printable_line(trimmed(remarks)));
    }
    check_material_words(bytes.view(), file, warnings_);
    std::map<std::string, SourceLocation> places = places_of(bytes.view(), file);
    for (tinyobj::material_t& material : materials) {
      const std::string name = trimmed(material.name);
      if (name.empty()) continue;
      materials_.try_emplace(name, Description{std::move(material), places[name]});
    }
    return true;
  } catch (const IoError& error) {
    reason = error.what();
    return false;
  }
}

const Description* Library::find(const std::string& material) const {
  const auto found = materials_.find(material);
  return found == materials_.end() ? nullptr : &found->second;
}

std::vector<std::string> Library::names() const {
  std::vector<std::string> names;
  for (const auto& [name, description] : materials_) names.push_back(printable_line(name));
  return names;
}

std::string trimmed(std::string_view name) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t begin = name.find_first_not_of(kSpace);
  if (begin == name.npos) return {};
  return std::string(name.substr(begin, name.find_last_not_of(kSpace) - begin + 1));
}

}  // namespace ajar::obj
