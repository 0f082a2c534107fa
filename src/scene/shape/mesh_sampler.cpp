#include <algorithm>

#include "core/distribution.h"
#include "core/parallel_for.h"
#include "core/warp.h"
#include "scene/shape/make_surface_sampler.h"

namespace ajar {

namespace {

class MeshSampler final : public SurfaceSampler {
 public:
  MeshSampler(const TriangleMesh& mesh, const std::vector<float>& areas)
      : mesh_(mesh), by_area_(areas), densities_(areas.size()) {
    // The probability is that of the table, rounded as it is, so that sampling and density agree
    // exactly.
    parallel_for(areas.size(), [&](std::size_t i) {
      const float probability = by_area_.probability(i);
      if (!(probability > 0.F)) return;
      densities_[i] = static_cast<float>(double{probability} /
                                         mesh.triangle_area(static_cast<std::uint32_t>(i)));
    });
  }
  float area() const override { return static_cast<float>(by_area_.total()); }
  std::uint32_t primitives() const override {
    return static_cast<std::uint32_t>(densities_.size());
  }
  SurfaceExtent extent() const override {
    SurfaceExtent extent;
    Vec3d mean(0.0);
    for_each_corner([&](const SurfacePoint& corner, float probability) {
      extent.box.extendBy(corner.p);
      mean += Vec3d(corner.ng) * static_cast<double>(probability);
    });
    extent.normals = DirectionCone::whole_sphere();
    const double size = mean.length();
    if (!(size > 1e-3)) return extent;
    const Vec3 axis(mean / size);
    float angle = 0.F;
    for_each_corner([&](const SurfacePoint& corner, float) {
      angle = std::max(angle, angle_between(axis, corner.ng));
    });
    extent.normals = {axis, std::min(angle, kPi)};
    return extent;
  }
  SurfaceSample sample(const SurfaceUniforms& u) const override {
    SurfaceSample result;
    sample(u, result);
    return result;
  }
  std::optional<SurfaceSample> sample_toward(const Vec3& /*reference*/,
                                             const SurfaceUniforms& u) const override {
    std::optional<SurfaceSample> result(std::in_place);
    sample(u, *result);
    return result;
  }
  Pdf<Area> pdf(const SurfacePoint& point) const override {
    return Pdf<Area>(densities_[point.primitive]);
  }
  std::optional<SurfaceUniforms> invert(const SurfacePoint& point,
                                        const SurfaceUniforms& fresh) const override {
    if (!(by_area_.probability(point.primitive) > 0.F)) return std::nullopt;
    return SurfaceUniforms{
        by_area_.invert(point.primitive, fresh.primitive),
        warp::uniform_triangle_inverse(mesh_.barycentric(point.primitive, point.p))};
  }

 private:
  /// `visit(point, probability)` for the corners of all triangles that can be sampled. Authored
  /// normals may put `ng` on different sides at different corners.
  template <typename Visit>
  void for_each_corner(const Visit& visit) const {
    for (std::uint32_t i = 0; i < densities_.size(); ++i) {
      const float probability = by_area_.probability(i);
      if (!(probability > 0.F)) continue;
      for (int corner = 0; corner < 3; ++corner) {
        SurfacePoint point;
        mesh_.plain_point(i, corner == 1 ? 1.F : 0.F, corner == 2 ? 1.F : 0.F, point);
        visit(point, probability);
      }
    }
  }
  void sample(const SurfaceUniforms& u, SurfaceSample& result) const {
    const Distribution1D::Choice choice = by_area_.choose(u.primitive);
    const Vec2 b = warp::uniform_triangle(u.position);
    const auto triangle = static_cast<std::uint32_t>(choice.index);
    mesh_.plain_point(triangle, b.x, b.y, result.point);
    result.pdf = Pdf<Area>(densities_[triangle]);
  }

  const TriangleMesh& mesh_;
  Distribution1D by_area_;
  std::vector<float> densities_;
};

}  // namespace

std::unique_ptr<SurfaceSampler> make_surface_sampler(const TriangleMesh& mesh) {
  std::vector<float> areas(mesh.triangle_count());
  parallel_for(areas.size(), [&](std::size_t i) {
    areas[i] = static_cast<float>(mesh.triangle_area(static_cast<std::uint32_t>(i)));
  });
  auto sampler = std::make_unique<MeshSampler>(mesh, areas);
  if (!(sampler->area() > 0.F)) return nullptr;
  return sampler;
}

}  // namespace ajar
