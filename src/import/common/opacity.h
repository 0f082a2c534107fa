#pragma once
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Lets all light pass straight on: what is no surface, where it is a part of a mix.
desc::Node clear_material();

/// The material `id` as a part of a mix: what is nothing but a boundary between media would let no
/// light pass there, and is a clear material instead.
desc::MaterialId part_of_mix(desc::SceneDesc& scene, desc::MaterialId id);

/// A surface of which not all is there.
struct PartlyClear {
  desc::MaterialId material = desc::kNone;
  desc::TextureId alpha = desc::kNone;  ///< of the shape; none if nowhere all is cut away
};
/// `visible` by the share `opacity`, a number, a colour or a texture; the rest is clear. The
/// materials that it takes are called and placed as `like`. Where a texture is 0, the mix alone
/// would let light pass, too, but not shadow rays.
PartlyClear with_opacity(desc::SceneDesc& scene, const desc::Material& like,
                         desc::MaterialId visible, const desc::Value& opacity);

}  // namespace ajar
