// Solid textures made of noise. Source: pbrt-v3, sections 10.6.3 – 10.6.6. Octaves are not reduced
// with the footprint of a pixel: supersampling filters them.
#include <algorithm>
#include <array>

#include "scene/texture/noise.h"
#include "scene/texture/texture_builders.h"

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
std::unique_ptr<const Texture> make_solid(const Mat4& world_to_texture, Function function) {
  return std::make_unique<SolidTexture<Function>>(world_to_texture, function);
}

class MarbleTexture final : public Texture {
 public:
  explicit MarbleTexture(const desc::MarbleTexture& node) : node_(node) {}
  Spectrum eval(const SurfacePoint& at) const override {
    const Vec3 p = transform_point(node_.world_to_texture, at.p) * node_.scale;
    const float layers = p.y + node_.variation * fbm(p, node_.roughness, node_.octaves);
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

  desc::MarbleTexture node_;
};

}  // namespace

std::unique_ptr<const Texture> make_texture(const desc::FbmTexture& node) {
  return make_solid(node.world_to_texture,
                    [roughness = node.roughness, octaves = node.octaves](const Vec3& p) {
                      return fbm(p, roughness, octaves);
                    });
}

std::unique_ptr<const Texture> make_texture(const desc::WrinkledTexture& node) {
  return make_solid(node.world_to_texture,
                    [roughness = node.roughness, octaves = node.octaves](const Vec3& p) {
                      return turbulence(p, roughness, octaves);
                    });
}

std::unique_ptr<const Texture> make_texture(const desc::WindyTexture& node) {
  return make_solid(node.world_to_texture, [](const Vec3& p) {
    const float wind = fbm(p * 0.1F, 0.5F, 3);
    const float waves = fbm(p, 0.5F, 6);
    return std::abs(wind) * waves;
  });
}

std::unique_ptr<const Texture> make_texture(const desc::MarbleTexture& node) {
  return std::make_unique<MarbleTexture>(node);
}

}  // namespace ajar
