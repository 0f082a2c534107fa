#pragma once
#include <optional>
#include <string>

#include "import/gltf/images.h"

namespace ajar::gltf {

/// Channels of an image that a material uses. Colours are sRGB-coded in glTF, single channels and
/// vectors are linear.
enum class Channel { Color, Red, Green, Blue, Alpha, Vector };

/// Makes textures for one material. A mesh has one set of texture coordinates: that of the
/// material's first texture; textures with another are left out, with a warning.
class Textures {
 public:
  Textures(Context& context, Images& images) : context_(context), images_(images) {}

  /// `factor` times the texture `name` of `holder`: a colour if there is no such texture.
  desc::Value color(const Element& holder, std::string_view name, const desc::Rgb& factor);
  /// A number from one channel.
  desc::Value number(const Element& holder, std::string_view name, float factor, Channel channel);

  /// The vectors of the texture `name` of `holder`, as they are in the image.
  std::optional<desc::TextureId> vectors(const Element& holder, std::string_view name) {
    return read(holder, name, Channel::Vector, 1.F);
  }

  /// Textures of textures; constants are computed.
  desc::Value product(const desc::Value& first, const desc::Value& second);
  /// 1 − `value`.
  desc::Value complement(const desc::Value& value);
  /// 1 where a number is at least `edge`, else 0.
  desc::TextureId threshold(const Element& user, const desc::Value& value, float edge);

  /// The n of TEXCOORD_n, if there are textures.
  std::optional<std::size_t> uv_set() const { return uv_set_; }

 private:
  std::optional<desc::TextureId> read(const Element& holder, std::string_view name, Channel channel,
                                      float scale);
  std::optional<Element> image_of(const Element& texture) const;
  void set_sampler(desc::Node& node, const Element& texture);
  bool has_usable_uvs(const Element& info);
  desc::TextureId add(const Element& user, desc::Node node);

  Context& context_;
  Images& images_;
  std::optional<std::size_t> uv_set_;
  SourceLocation where_;  ///< place of the last texture that was read
};

}  // namespace ajar::gltf
