#pragma once
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Counting of cut-outs as edges in the depth of a path.
enum class Passing { Counted, Uncounted };

/// True if cut-outs have to be counted, which costs time, where paths have no more than this many
/// edges: longer ones than 32 carry next to no light.
inline bool must_count_cut_outs(int max_depth) { return max_depth <= 32; }

/// Transmits all light straight on: an interface as a part of a mix.
desc::Node clear_material(Passing passing = Passing::Counted);

/// The material `id` as a part of a mix: an interface between media would transmit no light there,
/// and is replaced by a clear material.
desc::MaterialId part_of_mix(desc::SceneDesc& scene, desc::MaterialId id,
                             Passing passing = Passing::Counted);

/// A surface of which not all is there.
struct PartlyClear {
  desc::MaterialId material = desc::kNone;
  desc::TextureId alpha = desc::kNone;  ///< opacity of the shape; none if nothing is cut away
};
/// `visible` by the share `opacity`, a number, a colour or a texture; the rest is clear. The
/// materials that it takes are called and placed as `like`. Where a texture is 0, the mix alone
/// would let light pass, too, but not shadow rays.
PartlyClear with_opacity(desc::SceneDesc& scene, const desc::Material& like,
                         desc::MaterialId visible, const desc::Value& opacity,
                         Passing passing = Passing::Counted);

}  // namespace ajar
