#pragma once
#include <memory>

#include "scene/texture/image_cache.h"
#include "scene/texture/texture.h"

/// One builder per family of textures. Textures they refer to are already built.
namespace ajar {

/// A reference to a texture, or `fallback` where the description leaves it out.
TextureSlot texture_slot(desc::TextureId id, const TextureList& textures, float fallback);

std::unique_ptr<const Texture> make_texture(const desc::ConstantTexture& node);
std::unique_ptr<const Texture> make_texture(const desc::ScaleTexture& node,
                                            const TextureList& textures);
std::unique_ptr<const Texture> make_texture(const desc::MixTexture& node,
                                            const TextureList& textures);
std::unique_ptr<const Texture> make_texture(const desc::BilerpTexture& node);
/// `image` may be null: then the texture is magenta.
std::unique_ptr<const Texture> make_texture(const desc::ImageTexture& node,
                                            std::shared_ptr<const TexelImage> image);
std::unique_ptr<const Texture> make_texture(const desc::CheckerboardTexture& node,
                                            const TextureList& textures);
std::unique_ptr<const Texture> make_texture(const desc::DotsTexture& node,
                                            const TextureList& textures);
std::unique_ptr<const Texture> make_texture(const desc::UvTexture& node);
std::unique_ptr<const Texture> make_texture(const desc::FbmTexture& node);
std::unique_ptr<const Texture> make_texture(const desc::WrinkledTexture& node);
std::unique_ptr<const Texture> make_texture(const desc::WindyTexture& node);
std::unique_ptr<const Texture> make_texture(const desc::MarbleTexture& node);

}  // namespace ajar
