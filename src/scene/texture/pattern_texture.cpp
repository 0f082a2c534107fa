// Textures that are simple functions of two texture coordinates (and the solid checkerboard).
// Source: pbrt-v3, sections 10.3.3, 10.5 and 10.6.2.
#include "core/floor_to_int.h"
#include "core/perlin_noise.h"
#include "scene/texture/inputs.h"
#include "scene/texture/mapping.h"

namespace ajar {

namespace {

class BilinearTexture final : public Texture {
 public:
  explicit BilinearTexture(const TextureInputs& in)
      : mapping_(in.node()),
        v00_(in.color("v00")),
        v01_(in.color("v01")),
        v10_(in.color("v10")),
        v11_(in.color("v11")) {}
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
  explicit UvTexture(const TextureInputs& in) : mapping_(in.node()) {}
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

std::vector<ParameterSpec> squares() {
  return {declare::textured_color("first", "1", "what is at the origin"),
          declare::textured_color("second", "0", "what is beside it")};
}

}  // namespace

TextureModel bilinear_texture() {
  return {{.name = "bilinear",
           .summary = "four corners with blends between them",
           .source = "Pharr et al. 2016, section 10.3.3",
           .parameters = declare::joined({declare::color("v00", "0", "value at u = 0, v = 0"),
                                          declare::color("v01", "1", "value at u = 0, v = 1"),
                                          declare::color("v10", "0", "value at u = 1, v = 0"),
                                          declare::color("v11", "1", "value at u = 1, v = 1")},
                                         mapping_parameters())},
          make_texture<BilinearTexture>};
}

TextureModel checkerboard_texture() {
  return {{.name = "checkerboard",
           .summary = "squares of two textures by turns",
           .source = "Pharr et al. 2016, section 10.5.1",
           .parameters = declare::joined(squares(), mapping_parameters())},
          [](const TextureInputs& in) {
            return choose(InEvenSquare{TextureMapping(in.node())}, in.slot("first"),
                          in.slot("second"));
          },
          true};
}

TextureModel solid_checkerboard_texture() {
  return {{.name = "solid_checkerboard",
           .summary = "cubes of two textures by turns",
           .source = "Pharr et al. 2016, section 10.5.2",
           .parameters = declare::joined(squares(), {texture_space()})},
          [](const TextureInputs& in) {
            return choose(InEvenCube{in.node().transform("world_to_texture")}, in.slot("first"),
                          in.slot("second"));
          },
          true};
}

TextureModel dots_texture() {
  return {{.name = "dots",
           .summary = "dots, strewn at random",
           .source = "Pharr et al. 2016, section 10.6.2",
           .parameters =
               declare::joined({declare::textured_color("inside", "1", "what the dots are"),
                                declare::textured_color("outside", "0", "what is between them")},
                               mapping_parameters())},
          [](const TextureInputs& in) {
            return choose(InDot{TextureMapping(in.node())}, in.slot("inside"), in.slot("outside"));
          },
          true};
}

TextureModel uv_texture() {
  return {{.name = "uv",
           .summary = "shows the coordinates of a mapping as red and green",
           .source = "Pharr et al. 2016, section 10.5",
           .parameters = mapping_parameters()},
          make_texture<UvTexture>};
}

}  // namespace ajar
