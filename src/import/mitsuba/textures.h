#pragma once
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "import/mitsuba/arguments.h"
#include "scene/desc/models.h"

namespace ajar::mitsuba {

/// The exponent that decodes the integers of a bitmap: 1 if they are linear, nothing if they are as
/// their file says.
std::optional<float> decoding_exponent(Arguments& bitmap);

/// The textures of the scene, each made once however often it is referred to.
class TextureTable {
 public:
  explicit TextureTable(Context& context) : context_(context) {}

  /// The colour or the texture that `name` is of a plugin; nothing if it is not given.
  std::optional<desc::Value> find_color(Arguments& arguments, std::string_view name);
  desc::Value color(Arguments& arguments, std::string_view name, const desc::Rgb& fallback);
  /// A texture or a number. A colour's number is its mean in Mitsuba 0.x, its luminance in later
  /// ones.
  std::optional<desc::Value> find_number(Arguments& arguments, std::string_view name);
  desc::Value number(Arguments& arguments, std::string_view name, float fallback);

  /// `factor` times a colour or a texture.
  desc::Value scaled(const SourceLocation& where, const desc::Value& value,
                     const desc::Rgb& factor);
  /// `factor` times a number or a texture.
  desc::Value scaled(const SourceLocation& where, const desc::Value& value, float factor);

  /// Adds a constant texture.
  desc::TextureId add_constant(const SourceLocation& where, const desc::Rgb& color);
  /// An image file as it is, without decoding.
  desc::TextureId add_vectors(const SourceLocation& where, const std::string& file);

  /// A texture of colours. Raises SceneError for textures that refer to themselves.
  desc::TextureId make(const Element& element) { return make(element, Role::Color); }
  /// One of heights, of which all versions take the luminance.
  desc::TextureId make_height(const Element& element) { return make(element, Role::Luminance); }

 private:
  enum class Role { Color, Mean, Luminance };
  /// Role of a single number.
  Role number_role() const;
  desc::TextureId make(const Element& element, Role role);
  desc::Node read(const Element& element, Role role);
  desc::Node bitmap(Arguments& arguments, Role role);
  desc::Node checkerboard(Arguments& arguments, Role role);
  desc::Node scale(Arguments& arguments, Role role);
  desc::Node stand_in(Arguments& arguments);

  Context& context_;
  std::map<std::pair<const Element*, Role>, desc::TextureId> made_;
};

}  // namespace ajar::mitsuba
