#include "integrator/g_buffer.h"

#include <algorithm>

namespace ajar {

namespace {
Spectrum to_spectrum(const Vec3& v) { return {v.x, v.y, v.z}; }
}  // namespace

std::span<const std::string> GBuffer::names() {
  static const std::vector<std::string> kNames = {
      "albedo", "normal", "geometric-normal", "depth", "position", "object-id", "material-id"};
  return kNames;
}

std::vector<LayerSpec> GBuffer::layers(std::span<const std::string> asked_for, float scene_size) {
  std::vector<LayerSpec> specs;
  for (std::size_t i = 0; i < names().size(); ++i) {
    const std::string& name = names()[i];
    if (std::find(asked_for.begin(), asked_for.end(), name) == asked_for.end()) continue;
    const bool metric = i == kDepth || i == kPosition;
    const bool identifier = i == kObjectId || i == kMaterialId;
    specs.push_back({.name = name,
                     .has_replicates = false,
                     .magnitude = metric ? static_cast<double>(scene_size) : 1.0,
                     .per_sample = !identifier});
  }
  return specs;
}

GBuffer::GBuffer(const Film& film) {
  for (std::size_t i = 0; i < names().size(); ++i) {
    index_[i] = film.layer(names()[i]);
    empty_ = empty_ && index_[i] < 0;
  }
}

void GBuffer::add(Film& film, Vec2i pixel, float weight, bool first_sample, float distance,
                  const PathVertex& vertex, const Hit* hit) const {
  const auto put = [&](Layer layer, const Spectrum& value) {
    const int index = index_[layer];
    if (index >= 0) film.add(index, 0, pixel, value);
  };
  put(kDepth, Spectrum(weight * distance));
  put(kPosition, weight * to_spectrum(vertex.p));
  if (hit == nullptr) return;
  if (index_[kAlbedo] >= 0) put(kAlbedo, weight * vertex.bsdf.albedo(vertex.wo));
  put(kNormal, weight * to_spectrum(face_forward(vertex.bsdf.ns(), vertex.wo)));
  put(kGeometricNormal, weight * to_spectrum(face_forward(vertex.bsdf.ng(), vertex.wo)));
  if (!first_sample) return;
  // 0 is "nothing there".
  put(kObjectId, Spectrum(static_cast<float>(hit->object_id + 1)));
  put(kMaterialId, Spectrum(static_cast<float>(hit->material_id + 1)));
}

}  // namespace ajar
