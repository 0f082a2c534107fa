#include <algorithm>

#include "image/relative_error.h"
#include "integrator/masked/masked.h"
#include "integrator/metropolis/erpt.h"
#include "integrator/metropolis/metropolis.h"
#include "integrator/metropolis/mlt.h"
#include "integrator/montecarlo/g_buffer.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/renamed.h"
#include "integrator/selective/config.h"
#include "integrator/selective/selective.h"

namespace ajar {

namespace {
/// Defaults named like the member where it does not say otherwise.
IntegratorInfo path_family_member(const PathFamilyDefaults& defaults, std::string summary,
                                  std::string source) {
  return {
      .name = defaults.techniques,
      .summary = std::move(summary),
      .source = std::move(source),
      .parameters = path_family_parameters(defaults),
      .make = [](const Scene& scene, const RenderSettings& settings, const Parameters& parameters) {
        return make_path_integrator(scene, settings, parameters);
      }};
}

IntegratorInfo metropolis(ChainSpace kind, std::string name, std::string summary,
                          std::string source) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .parameters = metropolis_parameters(kind),
          .make = [kind](const Scene& scene, const RenderSettings& settings,
                         const Parameters& parameters) {
            return make_metropolis_integrator(kind, scene, settings, parameters);
          }};
}

}  // namespace

const std::vector<IntegratorInfo>& integrators() {
  static const std::vector<IntegratorInfo> kIntegrators = {
      path_family_member(
          path_family_defaults("bdpt"),
          "bidirectional path tracing: every way to join a camera path and a light path",
          "Lafortune & Willems 1993; Veach & Guibas 1995"),
      {.name = "erpt",
       .summary =
           "energy redistribution path tracing: bidirectional samples, each spread over short "
           "chains that start from it",
       .source = "Cline, Talbot & Egbert 2005",
       .parameters = erpt_parameters(),
       .make =
           [](const Scene& scene, const RenderSettings& settings, const Parameters& parameters) {
             return make_erpt_integrator(scene, settings, parameters);
           }},
      path_family_member(
          path_family_defaults("ibpt"),
          "path tracing and light tracing combined: most of bdpt's strength at little cost",
          "Bogolepov et al. 2013"),
      path_family_member(path_family_defaults("lt"),
                         "light tracing: paths from the lights, joined to the lens; blind to what "
                         "only mirrors show",
                         "Dutré et al. 1993"),
      {.name = "mlt",
       .summary =
           "Metropolis light transport in path space, as published: chains of paths that are "
           "changed vertex by vertex",
       .source = "Veach & Guibas 1997",
       .parameters = mlt_parameters(),
       .make =
           [](const Scene& scene, const RenderSettings& settings, const Parameters& parameters) {
             return make_mlt_integrator(scene, settings, parameters);
           }},
      {.name = "masked",
       .summary = "selective Metropolis as published: chains make the indirect light of the "
                  "picture's noisy "
                  "regions, by a mask",
       .source = "Frolov",
       .parameters = masked_parameters(),
       .make = make_masked_integrator},
      metropolis(
          ChainSpace::Mmlt, "mmlt",
          "multiplexed Metropolis light transport, as published: chains of paths of one depth that "
          "choose the technique as they go",
          "Hachisuka, Kaplanyan & Dachsbacher 2014"),
      metropolis(
          ChainSpace::Pssmlt, "pssmlt",
          "primary sample space Metropolis light transport, as published: chains whose states are "
          "all connections of two subpaths",
          "Kelemen et al. 2002"),
      path_family_member(
          {.techniques = "pt"},
          "path tracing: camera paths that run into lights or are lit by sampled ones",
          "Kajiya 1986; Veach & Guibas 1995"),
      {.name = "selective",
       .summary =
           "ordinary Monte Carlo where it works, Markov chains where it fails: divides the light "
           "path by path",
       .source = "after Frolov; Bitterli & Jarosz 2019; Kelemen et al. 2002",
       .parameters = SelectiveConfig::parameters(),
       .make = make_selective_integrator,
       .check = refuse_renamed_parameters},
  };
  return kIntegrators;
}

const IntegratorInfo& find_integrator(const std::string& name) {
  std::vector<std::string> names;
  for (const IntegratorInfo& info : integrators()) {
    if (info.name == name) return info;
    names.push_back(info.name);
  }
  refuse_renamed_integrator(name);
  throw UsageError(unknown_name_message("integrator", name, names));
}

const std::vector<AovInfo>& aovs() {
  static const std::vector<AovInfo> kAovs = {
      {.name = "direct",
       .summary = "light of paths with at most two edges (always written)",
       .made_by_method = false},
      {.name = "indirect",
       .summary = "light of longer paths (always written)",
       .made_by_method = false},
      {.name = "albedo", .summary = "reflectance of the first surface"},
      {.name = "normal",
       .summary = "shading normal of the first surface, world space, facing the camera"},
      {.name = "geometric-normal",
       .summary = "geometric normal of the first surface, world space, facing the camera"},
      {.name = "depth",
       .summary = "distance from the camera to the first surface, scene units",
       .value = LayerValue::Number},
      {.name = "position", .summary = "place of the first surface, world space"},
      {.name = "coverage",
       .summary = "share of the pixel's samples that hit a surface",
       .value = LayerValue::Number},
      {.name = "alpha",
       .summary = "share of the pixel's samples that meet anything but the sky, fog included: "
                  "channel A of the picture, which is multiplied by it where there is no sky",
       .part_of_all = false,
       .value = LayerValue::Number},
      {.name = "divided",
       .summary = "beside each of the layers of surfaces its mean over what is there alone, not "
                  "multiplied by the share of it in pixels at edges: depth.divided and so on",
       .part_of_all = false,
       .made_with = "alpha",
       .pictures = 5},
      {.name = "object-id",
       .summary = "number of the shape that most of the first nine samples hit, from 1; 0 for "
                  "none"},
      {.name = "instance-id",
       .summary = "number of the instance that most of the first nine samples hit, from 1; 0 for "
                  "none"},
      {.name = "material-id",
       .summary = "number of the material that most of the first nine samples hit, from 1; 0 for "
                  "none"},
      {.name = "samples", .summary = "samples per pixel", .made_by_method = false, .pictures = 1},
      {.name = "techniques",
       .summary = "what each technique contributes, weighted and alone, for paths of up to six "
                  "edges (many layers)",
       .part_of_all = false},
      {.name = "density",
       .summary = "visits of the chains per pixel and mutation per pixel: where they spend their "
                  "time (methods with chains)",
       .part_of_all = false,
       .value = LayerValue::Number},
      {.name = "acceptance",
       .summary = "mean acceptance probability of steps that begin in a pixel (methods with "
                  "chains)",
       .part_of_all = false,
       .value = LayerValue::Mean},
      {.name = "noise",
       .summary = "impulse noise of the pilot's indirect light (selective)",
       .part_of_all = false},
      {.name = "regions",
       .summary = "number of the region of a pixel, from 1 (selective)",
       .part_of_all = false},
      {.name = "importance",
       .summary = "what chains make of paths that bring as much as their whole pixel, of the most "
                  "they might (selective)",
       .part_of_all = false},
      {.name = "edges",
       .summary = "edges between surfaces, as the pilot saw them (selective)",
       .part_of_all = false},
      {.name = "standard-error",
       .summary = "standard error of each pixel, from four replicates: Student's t with 3 degrees "
                  "of freedom, so that 86 % of the pixels are within 2 of it",
       .made_by_method = false,
       .pictures = 1},
      {.name = "standard-error-by-scale",
       .summary = "standard error of the picture after a Gaussian of 1, 2, 4 and 8 pixels, as "
                  "standard-error.1 to .8: what no filter can take away",
       .part_of_all = false,
       .made_by_method = false,
       .pictures = static_cast<int>(kErrorScales.size())},
      {.name = "replicates",
       .summary =
           "the independent estimates whose mean is the picture: lets ajar compare test for bias",
       .part_of_all = false,
       .made_by_method = false,
       .pictures = AovInfo::kPerReplicate},
  };
  return kAovs;
}

const AovInfo* find_aov(const std::string& name) {
  const auto found = std::find_if(aovs().begin(), aovs().end(),
                                  [&](const AovInfo& info) { return info.name == name; });
  return found == aovs().end() ? nullptr : &*found;
}

}  // namespace ajar
