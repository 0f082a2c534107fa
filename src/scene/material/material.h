#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/warnings.h"
#include "scene/bsdf/bsdf.h"
#include "scene/desc/scene_desc.h"
#include "scene/material/relief.h"
#include "scene/texture/texture.h"

namespace ajar {

/// Turns textures into a BSDF at a point. Immutable, thread-safe.
class Material {
 public:
  virtual ~Material() = default;
  /// Appends this material's lobes, each scaled by `scale`, to `bsdf` (mixes call this
  /// recursively).
  virtual void add_lobes(const SurfacePoint& at, const Spectrum& scale, Bsdf& bsdf) const = 0;
  /// The most lobes that `add_lobes` can append, anywhere.
  virtual int max_lobes() const = 0;
  /// The BSDF at `at`, around the normal that the relief makes of its own.
  void bsdf(const SurfacePoint& at, Bsdf& result) const;
  Bsdf bsdf(const SurfacePoint& at) const {
    Bsdf result;
    bsdf(at, result);
    return result;
  }
  /// True if it only spreads light over a hemisphere, whatever its textures.
  virtual bool is_diffuse() const { return false; }
  /// No surface: rays pass straight through and only the medium changes.
  virtual bool is_interface() const { return false; }

  /// True if `bsdf` reads the derivatives of a surface point.
  bool needs_derivatives() const { return !relief.is_flat() || needs_tangent; }

  std::string name;
  Relief relief;
  /// True if the x axis of the shading frame must follow dp/du (anisotropic roughness).
  bool needs_tangent = false;
  /// True if its index of refraction is not the same everywhere.
  bool index_varies = false;
  /// True if some light passes straight on without adding to the depth of its path.
  bool passes_uncounted = false;
  /// True if crossing the interface adds an edge to the depth of a path.
  bool adds_edge = false;
};

using MaterialList = std::vector<std::unique_ptr<const Material>>;

/// One material; `made` are those before it. Raises SceneError if the description has no model.
std::unique_ptr<Material> make_material(const desc::Material& description,
                                        const TextureList& textures, const MaterialList& made,
                                        Warnings& warnings);
/// Builds all materials; entry i is material id i. Reflectances are clamped to [0, 1] wherever they
/// are evaluated.
MaterialList build_materials(const desc::SceneDesc& scene, const TextureList& textures,
                             Warnings& warnings);

}  // namespace ajar
