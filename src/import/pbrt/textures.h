#pragma once
#include <optional>
#include <string>
#include <vector>

#include "import/pbrt/context.h"
#include "import/pbrt/parameter_list.h"
#include "import/pbrt/scoped_names.h"

namespace ajar::pbrt {

/// pbrt keeps textures of numbers and of colours apart, even under the same name.
enum class TextureClass { Float, Spectrum };

/// True if pbrt-v4 reads an image of this name as its encoding says. The formats that it leaves to
/// a library are three channels of sRGB in any case.
bool obeys_encoding(const std::string& file);

/// The textures of the scene, and their names in the current scope.
class TextureTable {
 public:
  explicit TextureTable(Context& context) : context_(context) {}

  /// A texture that is 0 everywhere, always the same.
  desc::TextureId zero();

  /// `Texture "name" "class" "type" parameters`.
  void define(const SourceLocation& where, const std::string& name,
              const std::string& texture_class, const std::string& type,
              const ParameterList& parameters, const Mat4& ctm);
  /// The texture that a parameter names; empty, after a warning, if there is none of this name and
  /// class.
  std::optional<desc::TextureId> find(const Parameter& reference, TextureClass texture_class) const;

  /// Adds a texture without a name.
  desc::TextureId add(const SourceLocation& where, desc::Node node);

  /// Names of pbrt-v4 are known to the end of the file.
  void begin_scope();
  void end_scope();

 private:
  Context& context_;
  desc::TextureId zero_ = desc::kNone;
  ScopedNames<desc::TextureId> floats_, spectra_;
};

/// Lookup of parameters, which may be textures, in one list or, for materials whose parameters a
/// shape overrides, in two.
class TextureParameters {
 public:
  TextureParameters(Context& context, TextureTable& table, const ParameterList& first,
                    const ParameterList* second = nullptr, ColorRole role = ColorRole::Other)
      : context_(context), table_(table), lists_{&first, second}, role_(role) {}
  /// Parameters of a light.
  static TextureParameters of_light(Context& context, TextureTable& table,
                                    const ParameterList& list) {
    return {context, table, list, nullptr, ColorRole::Light};
  }

  /// A texture or a colour. `positive`: as for `color`.
  std::optional<desc::Value> find_spectrum(std::string_view name, bool positive = false) const;
  /// A texture or a number; in pbrt-v4 also a spectrum, for dispersion, of which the mean is taken.
  std::optional<desc::Value> find_number(std::string_view name) const;
  /// `positive`: lanes below 0 are taken as 0, with a warning.
  std::optional<desc::Rgb> color(std::string_view name, bool positive) const;
  std::optional<float> number(std::string_view name) const;
  std::optional<int> integer(std::string_view name) const;
  std::optional<Vec3> vector(std::string_view name) const;
  std::optional<Vec3> point(std::string_view name) const;
  std::optional<bool> flag(std::string_view name) const;
  std::optional<std::string> text(std::string_view name) const;
  std::vector<std::string> texts(std::string_view name) const;
  void accept(std::initializer_list<std::string_view> names) const;
  bool has_own_words() const;

  Context& context() const { return context_; }
  /// Colours, or textures of colours, multiplied: by a new texture if one of them is a texture.
  desc::Value product(const SourceLocation& where, const desc::Value& a,
                      const desc::Value& b) const;

 private:
  std::optional<float> mean_of_spectrum(const ParameterList& list, std::string_view name) const;
  /// Result of `get` for the first list that has it.
  template <typename Get>
  auto first_of(Get get) const -> decltype(get(std::declval<const ParameterList&>())) {
    for (const ParameterList* list : lists_) {
      if (list == nullptr) continue;
      if (auto value = get(*list)) return value;
    }
    return std::nullopt;
  }

  Context& context_;
  TextureTable& table_;
  const ParameterList* lists_[2];
  ColorRole role_;
};

}  // namespace ajar::pbrt
