#include <tbb/parallel_for.h>

#include "core/distribution.h"
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
    tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
      const float probability = by_area_.probability(i);
      if (!(probability > 0.F)) return;
      densities_[i] = static_cast<float>(double{probability} /
                                         mesh.triangle_area(static_cast<std::uint32_t>(i)));
    });
  }
  float area() const override { return static_cast<float>(by_area_.total()); }
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

 private:
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
  tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
    areas[i] = static_cast<float>(mesh.triangle_area(static_cast<std::uint32_t>(i)));
  });
  auto sampler = std::make_unique<MeshSampler>(mesh, areas);
  if (!(sampler->area() > 0.F)) return nullptr;
  return sampler;
}

}  // namespace ajar
