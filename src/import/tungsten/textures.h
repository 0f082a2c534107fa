#pragma once
#include <optional>
#include <string>

#include "import/tungsten/object_reader.h"

namespace ajar::tungsten {

/// An image file as a texture or a light refers to it.
struct Bitmap {
  std::string file;  ///< resolved
  bool gamma_correct = true;
  bool interpolate = true;
  bool clamp = false;
  float scale = 1.F;

  /// Exponent that decodes its integers as colours.
  float decoding_exponent() const { return gamma_correct ? 2.2F : 1.F; }
};

/// Textures, which Tungsten writes in place of the value that they vary: a number, an array, the
/// name of an image, or an object with a type.
class TextureReader {
 public:
  explicit TextureReader(Context& context) : context_(context) {}

  /// A colour (Vec3) or a texture (TextureRef).
  desc::Value color(const LocatedJson& json);
  /// A number (float) or a texture (TextureRef). An image's number is the mean of the colours as
  /// they are stored: Tungsten decodes colours only.
  desc::Value number(const LocatedJson& json) { return number(json, NumberRole::Number); }
  /// Opacity: the alpha channel of an image that has one; PNG and JPEG files always do.
  desc::Value opacity(const LocatedJson& json) { return number(json, NumberRole::Opacity); }
  /// The member of an object as one of these; `fallback` without one.
  desc::Value color(const ObjectReader& object, std::initializer_list<std::string_view> names,
                    const Vec3& fallback);
  desc::Value number(const ObjectReader& object, std::initializer_list<std::string_view> names,
                     float fallback);

  /// The image, if `json` is one and nothing else.
  std::optional<Bitmap> bitmap(const LocatedJson& json);

  /// A texture times a colour; a colour times a colour.
  desc::Value product(const desc::Value& color, const Vec3& factor);
  /// Product of numbers.
  desc::Value product(const desc::Value& number, float factor);

 private:
  desc::TextureRef add(const SourceLocation& where, desc::Node node);
  desc::Value of_object(const LocatedJson& json);
  enum class NumberRole { Number, Opacity };
  desc::Value number(const LocatedJson& json, NumberRole role);
  desc::TextureRef add_image(const SourceLocation& where, const Bitmap& image,
                             float decoding_exponent, const std::string& channel);
  std::string resolve(const LocatedJson& name);

  Context& context_;
};

/// A constant colour, or `mean` in place of a texture.
Vec3 constant_or(const desc::Value& color, const Vec3& mean);

/// Warns of members that a texture of a known type does not have, without making one.
void check_texture(const Context& context, const LocatedJson& json);

/// `color` with lanes below 0 as 0, which is a warning at `where`.
Vec3 not_negative(const Context& context, const SourceLocation& where, const Vec3& color);

}  // namespace ajar::tungsten
