#include "mcmc/path_space/half_vector_perturbation.h"

#include <cstdint>

#include "core/frame.h"

namespace ajar {

namespace {

/// Role of a path's vertex in this mutation.
enum class Role : std::uint8_t { Specular, Glossy, Other };

Role role_of(const Scene& scene, const Path& path, int x) {
  const InnerVertex& vertex = path.vertex(x);
  if (vertex.event.specular()) return Role::Specular;
  if (vertex.in_medium) return Role::Other;
  const Vec3 a = path.toward_camera(scene, x);
  const Vec3 b = path.toward_light(scene, x);
  // No diffuse surface has more.
  const bool is_dense = vertex.pdf(a, b) > double{kInvPi} * (1.0 + 1e-6);
  return is_dense && offset_normal(vertex, Vec3d(a), Vec3d(b)) ? Role::Glossy : Role::Other;
}

}  // namespace

std::optional<ConstraintPerturbation::Span> HalfVectorPerturbation::span_of(
    const Path& path) const {
  int glossy = 0;
  int first_rough = 0;
  int moved = 0;
  int fixed = 0;
  for (int x = path.depth() - 1; x > 0 && fixed == 0; --x) {
    const Role role = role_of(scene_, path, x);
    if (role == Role::Glossy) ++glossy;
    if (role != Role::Specular && first_rough == 0) first_rough = x;
    if (role != Role::Other) continue;
    (moved == 0 ? moved : fixed) = x;
  }
  if (moved == 0) {
    // The first of them is free.
    moved = first_rough;
    --glossy;
  }
  if (moved == 0 || glossy < 1) return std::nullopt;
  return Span{fixed, moved};
}

}  // namespace ajar
