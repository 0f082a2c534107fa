// Textures that are simple functions of two texture coordinates (and the solid checkerboard).
// Source: pbrt-v3, sections 10.3.3, 10.5 and 10.6.2.
#include "scene/texture/mapping.h"
#include "scene/texture/noise.h"
#include "scene/texture/texture_builders.h"

namespace ajar {

namespace {

class BilerpTexture final : public Texture {
 public:
  explicit BilerpTexture(const desc::BilerpTexture& node)
      : mapping_(node.mapping),
        v00_(rgb_spectrum(node.v00)),
        v01_(rgb_spectrum(node.v01)),
        v10_(rgb_spectrum(node.v10)),
        v11_(rgb_spectrum(node.v11)) {}
  Spectrum eval(const SurfacePoint& at) const override {
    const Vec2 st = mapping_.map(at);
    return v00_ * ((1.F - st.x) * (1.F - st.y)) + v01_ * ((1.F - st.x) * st.y) +
           v10_ * (st.x * (1.F - st.y)) + v11_ * (st.x * st.y);
  }

 private:
  TextureMapping mapping_;
  Spectrum v00_;
  Spectrum v01_;
  Spectrum v10_;
  Spectrum v11_;
};

/// Chooses one of two textures by a condition on the point.
template <typename Condition>
class ChoiceTexture final : public Texture {
 public:
  ChoiceTexture(Condition condition, const TextureSlot& if_true, const TextureSlot& if_false)
      : condition_(std::move(condition)), if_true_(if_true), if_false_(if_false) {}
  Spectrum eval(const SurfacePoint& at) const override {
    return condition_(at) ? if_true_.eval(at) : if_false_.eval(at);
  }
  float eval_float(const SurfacePoint& at) const override {
    return condition_(at) ? if_true_.eval_float(at) : if_false_.eval_float(at);
  }

 private:
  Condition condition_;
  TextureSlot if_true_;
  TextureSlot if_false_;
};

bool is_even(int i) { return (i & 1) == 0; }

struct InEvenSquare {
  TextureMapping mapping;
  bool operator()(const SurfacePoint& at) const {
    const Vec2 st = mapping.map(at);
    return is_even(floor_to_int(st.x) ^ floor_to_int(st.y));
  }
};

struct InEvenCube {
  Mat4 world_to_texture;
  bool operator()(const SurfacePoint& at) const {
    const Vec3 p = transform_point(world_to_texture, at.p);
    return is_even(floor_to_int(p.x) ^ floor_to_int(p.y) ^ floor_to_int(p.z));
  }
};

struct InDot {
  TextureMapping mapping;
  bool operator()(const SurfacePoint& at) const {
    constexpr float kRadius = 0.35F;
    constexpr float kMaxShift = 0.5F - kRadius;
    const auto random = [](float x, float y) { return noise({x, y, 0.5F}); };
    const Vec2 st = mapping.map(at);
    const Vec2 cell(std::floor(st.x + 0.5F), std::floor(st.y + 0.5F));
    if (!(random(cell.x + 0.5F, cell.y + 0.5F) > 0.F)) return false;
    const Vec2 center(cell.x + kMaxShift * random(cell.x + 1.5F, cell.y + 2.8F),
                      cell.y + kMaxShift * random(cell.x + 4.5F, cell.y + 9.8F));
    return (st - center).length2() < kRadius * kRadius;
  }
};

class UvTexture final : public Texture {
 public:
  explicit UvTexture(const desc::UvTexture& node) : mapping_(node.mapping) {}
  Spectrum eval(const SurfacePoint& at) const override {
    const Vec2 st = mapping_.map(at);
    return {st.x - std::floor(st.x), st.y - std::floor(st.y), 0.F};
  }

 private:
  TextureMapping mapping_;
};

template <typename Condition>
std::unique_ptr<const Texture> choose(Condition condition, const TextureSlot& if_true,
                                      const TextureSlot& if_false) {
  return std::make_unique<ChoiceTexture<Condition>>(std::move(condition), if_true, if_false);
}

}  // namespace

std::unique_ptr<const Texture> make_texture(const desc::BilerpTexture& node) {
  return std::make_unique<BilerpTexture>(node);
}

std::unique_ptr<const Texture> make_texture(const desc::CheckerboardTexture& node,
                                            const TextureList& textures) {
  const TextureSlot a = texture_slot(node.a, textures, 1.F);
  const TextureSlot b = texture_slot(node.b, textures, 0.F);
  if (node.dimension == 3) return choose(InEvenCube{node.world_to_texture}, a, b);
  return choose(InEvenSquare{TextureMapping(node.mapping)}, a, b);
}

std::unique_ptr<const Texture> make_texture(const desc::DotsTexture& node,
                                            const TextureList& textures) {
  return choose(InDot{TextureMapping(node.mapping)}, texture_slot(node.inside, textures, 1.F),
                texture_slot(node.outside, textures, 0.F));
}

std::unique_ptr<const Texture> make_texture(const desc::UvTexture& node) {
  return std::make_unique<UvTexture>(node);
}

}  // namespace ajar
