#include "integrator/montecarlo/g_buffer.h"

#include <algorithm>
#include <string_view>

namespace ajar {

namespace {
Spectrum to_spectrum(const Vec3& v) { return {v.x, v.y, v.z}; }

constexpr const char* kObjectIds = "object-id";
constexpr const char* kInstanceIds = "instance-id";
constexpr const char* kMaterialIds = "material-id";
}  // namespace

std::span<const std::string> GBuffer::names() {
  // The first ones in the order of `Layer`.
  static const std::vector<std::string> kNames = {
      "albedo",   "normal", "geometric-normal", "depth",      "position",
      "coverage", "alpha",  kObjectIds,         kInstanceIds, kMaterialIds};
  return kNames;
}

std::vector<LayerSpec> GBuffer::layers(std::span<const std::string> asked_for, float scene_size) {
  std::vector<LayerSpec> specs;
  for (std::size_t i = 0; i < names().size(); ++i) {
    const std::string& name = names()[i];
    const auto is_asked_for = [&](std::string_view wanted) {
      return std::find(asked_for.begin(), asked_for.end(), wanted) != asked_for.end();
    };
    const bool divides = (i == kCoverage || i == kAlpha) && is_asked_for("divided");
    if (!divides && !is_asked_for(name)) continue;
    if (i >= kCount) {
      for (LayerSpec& spec : IdentityLayers::specs(name)) specs.push_back(std::move(spec));
      continue;
    }
    const bool metric = i == kDepth || i == kPosition;
    specs.push_back({.name = name,
                     .has_replicates = false,
                     .magnitude = metric ? static_cast<double>(scene_size) : 1.0});
  }
  return specs;
}

GBuffer::GBuffer(const Film& film)
    : object_ids_(film, kObjectIds),
      instance_ids_(film, kInstanceIds),
      material_ids_(film, kMaterialIds) {
  std::transform(names().begin(), names().begin() + kCount, index_.begin(),
                 [&](const std::string& name) { return film.layer(name); });
  empty_ = object_ids_.empty() && instance_ids_.empty() && material_ids_.empty() &&
           std::all_of(index_.begin(), index_.end(), [](int index) { return index < 0; });
}

void GBuffer::add(Film& film, Vec2i pixel, float weight, std::uint64_t sample, float distance,
                  const PathVertex& vertex, const Hit* hit) const {
  const auto put = [&](Layer layer, const Spectrum& value) {
    const int index = index_[layer];
    if (index >= 0) film.add(index, 0, pixel, value);
  };
  put(kAlpha, Spectrum(weight));
  put(kDepth, Spectrum(weight * distance));
  put(kPosition, weight * to_spectrum(vertex.p));
  // 0 is "nothing there".
  object_ids_.add(film, pixel, sample, hit == nullptr ? 0 : hit->object_id + 1);
  instance_ids_.add(film, pixel, sample, hit == nullptr ? 0 : hit->instance_id);
  material_ids_.add(film, pixel, sample, hit == nullptr ? 0 : hit->material_id + 1);
  if (hit == nullptr) return;
  put(kCoverage, Spectrum(weight));
  if (index_[kAlbedo] >= 0) put(kAlbedo, weight * vertex.bsdf.albedo(vertex.wo));
  put(kNormal, weight * to_spectrum(face_forward(vertex.bsdf.ns(), vertex.wo)));
  put(kGeometricNormal, weight * to_spectrum(face_forward(vertex.bsdf.ng(), vertex.wo)));
}

void GBuffer::add_nothing(Film& film, Vec2i pixel, std::uint64_t sample) const {
  object_ids_.add(film, pixel, sample, 0);
  instance_ids_.add(film, pixel, sample, 0);
  material_ids_.add(film, pixel, sample, 0);
}

}  // namespace ajar
