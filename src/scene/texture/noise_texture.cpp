// Solid textures made of noise. Source: pbrt-v3, sections 10.6.3 – 10.6.6. Octaves are not reduced
// with the footprint of a pixel: supersampling filters them.
#include <algorithm>
#include <array>

#include "core/perlin_noise.h"
#include "scene/texture/inputs.h"
#include "scene/texture/mapping.h"

namespace ajar {

namespace {

/// A gray value from the point in texture space.
template <typename Function>
class SolidTexture final : public Texture {
 public:
  SolidTexture(const Mat4& world_to_texture, Function function)
      : world_to_texture_(world_to_texture), function_(function) {}
  Spectrum eval(const SurfacePoint& at) const override { return Spectrum(eval_float(at)); }
  float eval_float(const SurfacePoint& at) const override {
    return function_(transform_point(world_to_texture_, at.p));
  }

 private:
  Mat4 world_to_texture_;
  Function function_;
};

template <typename Function>
std::unique_ptr<const Texture> make_solid(const TextureInputs& in, Function function) {
  return std::make_unique<SolidTexture<Function>>(in.node().transform("world_to_texture"),
                                                  function);
}

/// Parameters of noise of several octaves.
std::vector<ParameterSpec> noise_parameters() {
  return {declare::integer("octaves", "8", "octaves of noise, each of twice the frequency", 0, 64),
          declare::number("roughness", "0.5", "strength of each octave relative to the one before"),
          texture_space()};
}

class MarbleTexture final : public Texture {
 public:
  explicit MarbleTexture(const TextureInputs& in)
      : octaves_(in.node().integer("octaves")),
        roughness_(in.node().number("roughness")),
        scale_(in.node().number("scale")),
        variation_(in.node().number("variation")),
        world_to_texture_(in.node().transform("world_to_texture")) {}
  Spectrum eval(const SurfacePoint& at) const override {
    const Vec3 p = transform_point(world_to_texture_, at.p) * scale_;
    const float layers = p.y + variation_ * fbm(p, roughness_, octaves_);
    return vein_color(0.5F + 0.5F * std::sin(layers));
  }

 private:
  /// Cubic Bézier segments over overlapping groups of four colours; `t` in [0, 1]. All segments are
  /// used as pbrt's text says; the code of pbrt-v3 stays in the second and extrapolates it far
  /// beyond white.
  static Spectrum vein_color(float t) {
    static const std::array<Spectrum, 9> kColors = {
        Spectrum(.58F, .58F, .6F), Spectrum(.58F, .58F, .6F), Spectrum(.58F, .58F, .6F),
        Spectrum(.5F, .5F, .5F),   Spectrum(.6F, .59F, .58F), Spectrum(.58F, .58F, .6F),
        Spectrum(.58F, .58F, .6F), Spectrum(.2F, .2F, .33F),  Spectrum(.58F, .58F, .6F)};
    constexpr int kSegments = 6;
    const float scaled = t * static_cast<float>(kSegments);
    const int first = std::clamp(static_cast<int>(scaled), 0, kSegments - 1);
    const float x = scaled - static_cast<float>(first);
    const float y = 1.F - x;
    const Spectrum* c = &kColors[static_cast<std::size_t>(first)];
    const Spectrum bezier = c[0] * (y * y * y) + c[1] * (3.F * y * y * x) +
                            c[2] * (3.F * y * x * x) + c[3] * (x * x * x);
    return bezier * 1.5F;
  }

  int octaves_;
  float roughness_, scale_, variation_;
  Mat4 world_to_texture_;
};

}  // namespace

TextureModel fbm_texture() {
  return {{.name = "fbm",
           .summary = "fractal noise around 0 (fractional Brownian motion)",
           .source = "Pharr et al. 2016, section 10.6.3",
           .parameters = noise_parameters()},
          [](const TextureInputs& in) {
            return make_solid(in, [roughness = in.node().number("roughness"),
                                   octaves = in.node().integer("octaves")](const Vec3& p) {
              return fbm(p, roughness, octaves);
            });
          }};
}

TextureModel wrinkled_texture() {
  return {{.name = "wrinkled",
           .summary = "fractal noise above 0 with creases (turbulence)",
           .source = "Pharr et al. 2016, section 10.6.4",
           .parameters = noise_parameters()},
          [](const TextureInputs& in) {
            return make_solid(in, [roughness = in.node().number("roughness"),
                                   octaves = in.node().integer("octaves")](const Vec3& p) {
              return turbulence(p, roughness, octaves);
            });
          }};
}

TextureModel windy_texture() {
  return {{.name = "windy",
           .summary = "waves on water, where gusts of wind touch it",
           .source = "Pharr et al. 2016, section 10.6.5",
           .parameters = {texture_space()}},
          [](const TextureInputs& in) {
            return make_solid(in, [](const Vec3& p) {
              const float wind = fbm(p * 0.1F, 0.5F, 3);
              const float waves = fbm(p, 0.5F, 6);
              return std::abs(wind) * waves;
            });
          }};
}

TextureModel marble_texture() {
  return {{.name = "marble",
           .summary = "layers of stone with veins",
           .source = "Pharr et al. 2016, section 10.6.6",
           .parameters = declare::joined(
               noise_parameters(),
               {declare::number("scale", "1", "layers per 2 pi of the texture's space"),
                declare::number("variation", "0.2", "strength of the noise that bends them")})},
          make_texture<MarbleTexture>};
}

}  // namespace ajar
