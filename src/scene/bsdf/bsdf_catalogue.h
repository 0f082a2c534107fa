#pragma once
#include <string>
#include <vector>

#include "core/random.h"
#include "scene/bsdf/bsdf.h"

/// BSDFs of every kind that the tests run through. Geometric normal +z in all of them.
namespace ajar::testing {

struct NamedBsdf {
  std::string name;
  Bsdf bsdf;
  bool conserves_energy = true;  ///< known to reflect no more than it gets
};

/// Shading frame whose normal is turned by `degrees` from +z, with a twist around it.
inline Frame tilted_frame(float degrees) {
  const float angle = degrees * kPi / 180.F;
  const Vec3 n(std::sin(angle) * 0.8F, std::sin(angle) * 0.6F, std::cos(angle));
  return Frame::around(n, Vec3(0.3F, -1.F, 0.2F));
}

inline std::vector<NamedBsdf> catalogue(float tilt_degrees) {
  std::vector<NamedBsdf> all;
  const auto begin = [&](const std::string& name) -> Bsdf& {
    all.push_back({name, Bsdf(tilted_frame(tilt_degrees), Vec3(0.F, 0.F, 1.F))});
    return all.back().bsdf;
  };
  const auto ggx = [](float x, float y) { return Microfacets(FacetModel::Ggx, x, y); };
  const auto beckmann = [](float x, float y) { return Microfacets(FacetModel::Beckmann, x, y); };
  const PackedSpectrum white(Spectrum(1.F));
  const ConductorFresnel gold({0.143F, 0.375F, 1.442F}, {3.983F, 2.386F, 1.603F});
  const Spectrum tint(0.9F, 0.5F, 0.2F);

  begin("lambert").add(Lambert{}, tint);
  begin("lambert transmission").add(LambertTransmission{}, tint);
  begin("oren-nayar").add(OrenNayar(0.5F), tint);
  begin("ggx 0.1").add(Conductor{ggx(0.1F, 0.1F), gold});
  begin("ggx 0.5").add(Conductor{ggx(0.5F, 0.5F), gold});
  begin("ggx 1").add(Conductor{ggx(1.F, 1.F), gold});
  begin("ggx 0.1 × 0.6").add(Conductor{ggx(0.1F, 0.6F), gold});
  begin("beckmann 0.15").add(Conductor{beckmann(0.15F, 0.15F), gold});
  begin("beckmann 0.5").add(Conductor{beckmann(0.5F, 0.5F), gold});
  begin("beckmann 0.7 × 0.2").add(Conductor{beckmann(0.7F, 0.2F), gold});
  begin("coat").add(DielectricReflection{ggx(0.2F, 0.2F), {1.5F}});
  begin("inverted coat").add(DielectricReflection{ggx(0.2F, 0.2F), {1.F / 1.5F}}, tint);
  begin("rough glass 0.15").add(RoughDielectric{ggx(0.15F, 0.15F), white, white, 1.5F});
  begin("rough glass 0.5").add(RoughDielectric{ggx(0.5F, 0.5F), white, white, 1.5F});
  begin("rough diamond 0.2 × 0.5").add(RoughDielectric{ggx(0.2F, 0.5F), white, white, 2.4F});
  begin("rough bubble 0.3").add(RoughDielectric{ggx(0.3F, 0.3F), white, white, 0.75F});
  begin("rough beckmann glass").add(RoughDielectric{beckmann(0.3F, 0.3F), white, white, 1.5F});
  begin("rough transmission only")
      .add(RoughDielectric{ggx(0.3F, 0.3F), {}, PackedSpectrum(tint), 1.5F});
  begin("substrate 0.1")
      .add(FresnelBlend{ggx(0.1F, 0.1F), PackedSpectrum(tint), PackedSpectrum(Spectrum(0.04F))});
  begin("substrate 0.2 × 0.5")
      .add(FresnelBlend{ggx(0.2F, 0.5F), PackedSpectrum(tint), PackedSpectrum(Spectrum(0.5F))});
  begin("disney diffuse")
      .add(DisneyDiffuse{
          PackedSpectrum(tint), PackedSpectrum(Spectrum(0.3F)), {0.6F, 0.4F, 0.8F}, 0.4F});
  // Burley's diffuse lobe gains up to a tenth at grazing angles.
  all.back().conserves_energy = false;
  begin("disney specular")
      .add(DisneySpecular{{FacetModel::GgxSeparable, 0.2F, 0.4F}, {PackedSpectrum(tint), 0.5F}});
  begin("disney specular of glass")
      .add(DisneyGlassSpecular{{FacetModel::GgxSeparable, 0.2F, 0.4F},
                               {{PackedSpectrum(tint), 0.5F, 1.5F, 0.5F}, 0.4F}});
  begin("sheet 0.3 × 0.1")
      .add(SheetTransmission{{FacetModel::GgxSeparable, 0.3F, 0.1F}, 1.5F}, tint);
  begin("sheet of air").add(SheetTransmission{ggx(0.4F, 0.4F), 0.75F});
  begin("disney clearcoat").add(DisneyClearcoat{0.1F});
  begin("flat clearcoat").add(DisneyClearcoat{0.05F, false, true});
  begin("mirror").add(Mirror{}, tint);
  begin("smooth glass").add(SmoothDielectric{white, white, 1.5F});
  begin("tinted smooth glass").add(SmoothDielectric{white, PackedSpectrum(tint), 0.7F});
  begin("pane").add(ThinDielectric{white, white, 1.5F});
  begin("pane that absorbs").add(ThinDielectric{white, PackedSpectrum(tint), 1.5F, true, true});
  begin("specular reflection").add(SpecularReflection{1.5F});
  begin("specular transmission").add(SpecularTransmission{1.5F});
  begin("pass-through").add(PassThrough{}, tint);

  begin("smooth metal").add(SmoothConductor{gold});
  begin("smooth coat").add(SmoothCoat{{1.5F}}, tint);
  begin("rough coat").add(RoughCoat{ggx(0.2F, 0.2F), {1.5F}});
  begin("diffuse under a smooth coat").add(CoatedDiffuse(Spectrum(1.F), {1.5F, 0.F}));
  begin("diffuse under a rough coat").add(CoatedDiffuse(tint, {1.8F, 0.4F}));
  begin("metal under a smooth coat").add(CoatedConductor{ggx(0.2F, 0.2F), gold, {1.5F, 0.F}});
  begin("metal under a rough coat").add(CoatedConductor{ggx(0.1F, 0.3F), gold, {1.3F, 0.3F}});
  begin("echo under a coat")
      .add(CoatedConductorEcho(CoatedConductor{beckmann(0.4F, 0.4F), gold, {1.5F, 0.F}}));
  begin("smooth metal under a smooth coat").add(SmoothCoatedConductor{{gold, {1.5F, 0.F}, {}}});

  begin("diffuse under an amber coat")
      .add(CoatedDiffuse(tint, Coat(1.5F, 0.F, FacetModel::Ggx, CoatPass::Whole, 2),
                         {Spectrum(0.1F, 0.3F, 1.F)}));
  begin("diffuse under straight amber")
      .add(CoatedDiffuse(tint, {1.5F, 0.F}, {Spectrum(0.1F, 0.3F, 1.F), true}));
  begin("full oren-nayar").add(FullOrenNayar(tint, 0.5F));
  for (const float alpha : {0.F, 0.3F}) {
    // White: the varnish's reflection must be missing below.
    Bsdf& varnished = begin("varnished mirror " + std::to_string(alpha));
    if (alpha > 0.F) {
      varnished.add(RoughCoat{ggx(alpha, alpha), {kVarnishIndex}}, Spectrum(0.7F));
    } else {
      varnished.add(SmoothCoat{{kVarnishIndex}}, Spectrum(0.7F));
    }
    varnished.add(CoatAttenuated<DisneySpecular>{
        {{FacetModel::GgxSeparable, 0.2F, 0.4F}, {white, 1.F}}, {alpha, 0.7F}});
  }
  for (const auto& [alpha, base] :
       {std::pair(0.1F, white), {0.25F, PackedSpectrum(tint)}, {1.F, white}}) {
    const Gloss gloss{1.5F, alpha, 0.9F};
    const DisneySpecular above{{FacetModel::GgxSeparable, alpha, alpha},
                               {PackedSpectrum(), 0.F, 1.5F, 0.9F}};
    const std::string name = std::to_string(alpha);
    Bsdf& layers = begin("base under gloss " + name);
    layers.add(CoatAttenuated<UnderGloss<SheenOverLambert>>{{{base.unpack(), Spectrum(0.F)}, gloss},
                                                            {0.F, 0.F}});
    layers.add(above);
    Bsdf& sheet = begin("varnished lampshade " + name);
    sheet.add(SmoothCoat{{kVarnishIndex}}, Spectrum(0.8F));
    sheet.add(CoatAttenuated<DisneySpecular>{above, {0.F, 0.8F}});
    sheet.add(CoatAttenuated<UnderGloss<SheenOverLambert>>{
        {{base.unpack() * 0.5F, Spectrum(0.7F)}, gloss}, {0.F, 0.8F}});
    sheet.add(CoatAttenuated<UnderGloss<LambertTransmission>>{{{}, gloss}, {0.F, 0.8F}},
              Spectrum(0.5F));
  }
  for (const float alpha : {0.15F, 0.6F}) {
    Bsdf& white_wall = begin("white under a coat of " + std::to_string(alpha));
    white_wall.add(RoughCoat{ggx(alpha, alpha), {1.5F}});
    white_wall.add(CoatedDiffuse(Spectrum(1.F), {1.5F, alpha}));
    Bsdf& silver = begin("silver under a coat of " + std::to_string(alpha));
    const ConductorFresnel ideal(Spectrum(1e-4F), Spectrum(1e4F));
    silver.add(RoughCoat{ggx(alpha, alpha), {1.5F}});
    silver.add(CoatedConductor{ggx(0.2F, 0.2F), ideal, {1.5F, alpha}});
  }
  for (const CoatPass pass : {CoatPass::Single, CoatPass::Lossy}) {
    const Coat coat(1.45F, 0.3F, FacetModel::BeckmannSeparable, pass);
    const Microfacets facets(FacetModel::BeckmannSeparable, 0.3F, 0.3F);
    Bsdf& paint = begin("paint under facets of kind " + std::to_string(static_cast<int>(pass)));
    paint.add(RoughCoat{facets, {1.45F}});
    paint.add(CoatedDiffuse(Spectrum(1.F), coat), Spectrum(0.5F));
    paint.add(CoatedConductor{facets, gold, coat}, Spectrum(0.5F));
  }
  Bsdf& varnish = begin("varnish");
  varnish.add(SmoothCoat{{1.5F}});
  varnish.add(CoatedDiffuse(tint, {1.5F, 0.F}));
  for (const float alpha : {0.02F, 0.2F, 0.6F}) {
    Bsdf& lacquer = begin("lacquered metal of " + std::to_string(alpha));
    const CoatedConductor under{
        ggx(alpha, alpha),
        alpha == 0.2F ? gold : ConductorFresnel(Spectrum(1e-4F), Spectrum(1e4F)),
        {1.5F, 0.F}};
    lacquer.add(SmoothCoat{{1.5F}});
    lacquer.add(under);
    lacquer.add(CoatedConductorEcho(under));
  }

  Bsdf& plastic = begin("plastic");
  plastic.add(Lambert{}, tint * 0.5F);
  plastic.add(DielectricReflection{ggx(0.15F, 0.15F), {1.F / 1.5F}}, Spectrum(0.5F));
  Bsdf& uber = begin("uber");
  uber.add(PassThrough{}, Spectrum(0.2F, 0.1F, 0.05F));
  uber.add(Lambert{}, tint * 0.3F);
  uber.add(DielectricReflection{ggx(0.3F, 0.1F), {1.5F}}, Spectrum(0.2F));
  uber.add(SpecularReflection{1.5F}, Spectrum(0.1F));
  uber.add(SpecularTransmission{1.5F}, Spectrum(0.2F));
  Bsdf& translucent = begin("translucent");
  translucent.add(Lambert{}, tint * 0.3F);
  translucent.add(LambertTransmission{}, tint * 0.2F);
  translucent.add(RoughDielectric{ggx(0.2F, 0.2F), PackedSpectrum(tint), white, 1.5F},
                  Spectrum(0.5F));
  Bsdf& disney = begin("disney");
  disney.add(DisneyDiffuse{PackedSpectrum(tint), {}, {}, 0.4F}, Spectrum(0.5F));
  disney.add(DisneySpecular{{FacetModel::GgxSeparable, 0.16F, 0.16F}, {white, 0.2F}});
  disney.add(DisneyClearcoat{0.1F}, Spectrum(0.7F));
  disney.add(RoughDielectric{{FacetModel::GgxSeparable, 0.16F, 0.16F}, {}, white, 1.5F},
             Spectrum(0.4F));
  disney.add(LambertTransmission{}, tint * 0.1F);
  // Disney's model adds its parts without coupling them.
  all.back().conserves_energy = false;
  Bsdf& milky = begin("disney, with an inside");
  milky.add(DisneyDiffuse{PackedSpectrum(tint * 0.5F), {}, {}, 0.4F, true});
  milky.add(DisneyGlassSpecular{{FacetModel::GgxSeparable, 0.16F, 0.16F},
                                {{PackedSpectrum(), 0.F, 1.5F, 1.F}, 0.4F}});
  milky.add(DisneyClearcoat{0.1F, true}, Spectrum(0.1F));
  milky.add(RoughDielectric{{FacetModel::GgxSeparable, 0.16F, 0.16F}, {}, white, 1.5F},
            Spectrum(0.4F));
  return all;
}

inline BsdfUniforms random_uniforms(Rng& rng) {
  const float lobe = rng.next();
  const float x = rng.next();
  return {lobe, {x, rng.next()}};
}
inline Vec3 random_direction(Rng& rng) {
  const float x = rng.next();
  return warp::uniform_sphere({x, rng.next()});
}
inline Vec3 direction(float theta_degrees, float phi_degrees) {
  const float theta = theta_degrees * kPi / 180.F;
  const float phi = phi_degrees * kPi / 180.F;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace ajar::testing
