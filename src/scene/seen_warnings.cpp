#include "scene/seen_warnings.h"

#include <algorithm>
#include <cmath>

namespace ajar {
namespace {

using desc::WarningIfSeen;

/// A surface that the camera sees.
struct Sight {
  desc::MaterialId material;
  bool is_from_behind;
  double depth;  ///< along the axis of the camera, in its own space
};

bool fits(const WarningIfSeen& candidate, const Sight& sight) {
  switch (candidate.condition) {
    case WarningIfSeen::If::FromBehind:
      return sight.is_from_behind &&
             (candidate.material == desc::kNone || candidate.material == sight.material);
    case WarningIfSeen::If::Nearer:
      return sight.depth < static_cast<double>(candidate.depth);
    case WarningIfSeen::If::Farther:
      break;
  }
  return sight.depth > static_cast<double>(candidate.depth);
}

/// `visit(sight)` of surfaces at a point of the picture.
template <typename Visit>
void look(const Scene& scene, const Mat4& to_camera, const Vec2& at, const Visit& visit) {
  constexpr int kMostSurfaces = 8;
  const auto sample = scene.camera().sample_emission({0.5F, Vec2(0.5F), at});
  if (!sample) return;
  Ray ray{sample->origin, sample->w};
  for (int i = 0; i < kMostSurfaces; ++i) {
    const std::optional<Hit> hit = scene.intersect(ray);
    if (!hit) return;
    Vec3d place;
    to_camera.multVecMatrix(Vec3d(hit->point.p), place);
    const bool is_interface = hit->cut_away || hit->is_interface();
    if (!is_interface) {
      visit({static_cast<desc::MaterialId>(hit->material_id),
             dot(ray.direction, hit->point.ng) > 0.F, std::abs(place.z)});
    }
    if (!is_interface && hit->material->bsdf(hit->point).connectible()) return;
    ray.origin = offset_ray_origin(hit->point.p, hit->point.ng, ray.direction);
  }
}

}  // namespace

void add_seen_warnings(const Scene& scene, const desc::Camera& camera,
                       const std::vector<WarningIfSeen>& candidates, Warnings& warnings) {
  if (candidates.empty()) return;
  // A part of the picture that is smaller is hardly looked at.
  constexpr int kColumns = 64;
  constexpr int kRows = 48;
  const Mat4 to_camera = camera.to_world.inverse();
  std::vector<const WarningIfSeen*> left;
  for (const WarningIfSeen& candidate : candidates) left.push_back(&candidate);
  for (int i = 0; i < kColumns * kRows && !left.empty(); ++i) {
    const Vec2 at((static_cast<float>(i % kColumns) + 0.5F) / kColumns,
                  (static_cast<float>(i / kColumns) + 0.5F) / kRows);
    look(scene, to_camera, at, [&](const Sight& sight) {
      std::erase_if(left, [&](const WarningIfSeen* candidate) {
        if (!fits(*candidate, sight)) return false;
        warnings.add(candidate->warning);
        return true;
      });
    });
  }
}

}  // namespace ajar
