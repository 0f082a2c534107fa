#include "scene/light/inputs.h"

#include <cmath>
#include <string>
#include <utility>

namespace ajar {
namespace {

constexpr WarningKind kNotTurned{Effect::Light,
                                 "lights have transforms that cannot be inverted in single "
                                 "precision: their rotation is ignored"};

constexpr WarningKind kNothingToScale{
    Effect::Light, "lights have black images, which cannot be scaled to a given strength"};

constexpr WarningKind kNotSquare{
    Effect::Light,
    "lights have equal-area images that are not square: they count as images of latitudes"};

}  // namespace

LightInputs::LightInputs(const desc::Light& description, const LightSurroundings& surroundings,
                         Warnings& warnings)
    : description_(description),
      surroundings_(surroundings),
      warnings_(warnings),
      at_{transform_point(description.to_world, Vec3(0.F)), DirectionMap()} {
  if (DirectionMap::invertible(description.to_world)) {
    at_.directions = DirectionMap(description.to_world);
  } else {
    warnings.add(kNotTurned, description.where,
                 "the transform of the light cannot be inverted in single precision; its rotation "
                 "is ignored");
  }
}

std::optional<Map> LightInputs::map(std::string_view name, MapEdge edge, MapFilter filter,
                                    std::optional<float> decoding_exponent) const {
  const std::string& path = node().text(name);
  if (path.empty()) return std::nullopt;
  return load_map(path, edge, description_.where, warnings_, filter, surroundings_.embedded,
                  decoding_exponent);
}

std::optional<SphereMap> LightInputs::sphere_map(const TexelTreatment& texels) const {
  const auto load = [&](const SphereProjection& projection) {
    const MapFilter filter = texels.nearest ? MapFilter::Nearest : projection.filter;
    std::optional<Map> image = map("image", projection.edge, filter, texels.decoding_exponent);
    if (image && texels.gray) image->make_gray();
    if (image && texels.rows_at_edges) image->put_rows_at_edges();
    return image;
  };
  const SphereProjection& wanted = sphere_projection(node().text("projection"));
  std::optional<Map> image = load(wanted);
  if (!image) return std::nullopt;
  const SphereProjection& latitudes = sphere_projection("longitude_latitude");
  const bool is_square = image->width() == image->height();
  if (is_square || wanted.to_uv == latitudes.to_uv) return SphereMap(std::move(*image), wanted);
  warnings_.add(kNotSquare, description_.where,
                "the image of this light is " + std::to_string(image->width()) + " × " +
                    std::to_string(image->height()) +
                    ", though equal-area images are square: it counts as one of latitudes");
  return SphereMap(*load(latitudes), latitudes);
}

std::optional<float> LightInputs::decoding_exponent() const {
  const float* exponent = std::get_if<float>(&node().get("decoding_exponent"));
  return exponent == nullptr ? std::nullopt : std::optional(*exponent);
}

float LightInputs::scale_to(std::string_view name, float actual) const {
  const float* wanted = std::get_if<float>(&node().get(name));
  if (wanted == nullptr) return 1.F;
  const float scale = *wanted / actual;
  if (std::isfinite(scale)) return scale;
  warnings_.add(kNothingToScale, description_.where,
                "\"" + std::string(name) + "\" cannot be reached: the light's image is black");
  return 1.F;
}

namespace declare {

ParameterSpec target(std::string name, std::string unit, std::string help) {
  ParameterSpec spec = number(std::move(name), "", std::move(help), std::move(unit));
  spec.minimum = 0.0;
  return spec;
}

ParameterSpec decoding() {
  ParameterSpec spec = number("decoding_exponent", "",
                              "exponent that decodes integers of the image; without it, sRGB");
  spec.minimum = 0.0;
  return spec;
}

}  // namespace declare

}  // namespace ajar
