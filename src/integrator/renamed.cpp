#include "integrator/renamed.h"

#include <array>
#include <string_view>

#include "core/error.h"

namespace ajar {

namespace {

constexpr std::string_view kMasked = "the same of masked, the method as published";
constexpr std::string_view kMmlt = "the same of mmlt";
constexpr std::string_view kMutations = "the same of mlt; selective has all mutations";

struct Renamed {
  std::string_view name;
  std::string_view value;  ///< empty: any
  std::string_view now;
};

constexpr std::array kParameters = std::to_array<Renamed>({
    {"division", "everywhere", "mmlt, or selective with split=T"},
    {"division", "regions", "nothing: selective always divides regions"},
    {"preset", "published", "--integrator masked, with pilot=keep"},
    {"preset", "lambertian-out", "--integrator masked, with lambertian=omc and omc=lt"},
    {"preset", "mmlt+", "mmlt, or selective with split=T"},
    {"preset", "pssmlt+", "pssmlt"},
    {"preset", "none", "nothing: there are no presets"},
    {"chain", "pssmlt", "--integrator masked, with chain=pssmlt"},
    {"chain", "erpt", "--integrator masked, with chain=erpt"},
    {"omc", "", "techniques; or the same of masked, the method as published"},
    {"map", "binary", "--integrator masked"},
    {"map", "optimal", "nothing: selective has no other"},
    {"choice", "", kMasked},
    {"pilot", "keep", "--integrator masked, with pilot=keep"},
    {"pilot-samples", "", kMasked},
    {"threshold", "", kMasked},
    {"epsilon", "", kMasked},
    {"window", "", kMasked},
    {"mutation", "", kMmlt},
    {"sigma", "", kMmlt},
    {"large-step", "", kMmlt},
    {"mis-large-steps", "", kMmlt},
    {"fine-steps", "", "nothing: it is as it was by default"},
    {"raster-steps", "", "nothing: it is as it was by default"},
    {"camera-steps", "", kMmlt},
    {"light-steps", "", kMmlt},
    {"multi-try", "", kMmlt},
    {"step", "", kMmlt},
    {"rule", "", kMmlt},
    {"m1", "", kMmlt},
    {"k1", "", kMmlt},
    {"k2", "", kMmlt},
    {"lambda1", "", kMmlt},
    {"lambda2", "", kMmlt},
    {"w", "", kMmlt},
    {"seeds", "", kMmlt},
    {"seed-spread", "", kMmlt},
    {"heuristic", "", "the same of bdpt and mmlt"},
    {"bootstrap", "", "the same of mmlt and masked; selective needs none"},
    {"chains", "", "the same of mmlt and masked; selective has as many as suit the picture"},
    {"direct", "", "mmlt, whose chains make all light"},
    {"split", "0", "mmlt, whose chains make all light"},
    {"omc-samples", "", "nothing: effort is shared by what errors show"},
    {"samples", "", "nothing: all pixels have as many camera samples"},
    {"bidirectional", "", kMutations},
    {"lens-subpath", "", kMutations},
    {"lens", "", kMutations},
    {"caustic", "", kMutations},
    {"multi-chain", "", kMutations},
    {"manifold", "", kMutations},
    {"half-vector", "", kMutations},
    {"roulette-start", "", "the same of bdpt"},
});

[[noreturn]] void refuse(const std::string& what, std::string_view now) {
  throw UsageError(what + " is of version 0.2; now: " + std::string(now) +
                   " (CHANGELOG.md, \"Upgrading from 0.2\")");
}

}  // namespace

void refuse_renamed_integrator(const std::string& name) {
  if (name == "mmlt+") refuse("integrator mmlt+", "mmlt, or selective with split=T");
  if (name == "pssmlt+") refuse("integrator pssmlt+", "pssmlt");
}

void refuse_renamed_parameters(const std::map<std::string, std::string>& given) {
  for (const Renamed& parameter : kParameters) {
    const auto value = given.find(std::string(parameter.name));
    if (value == given.end()) continue;
    if (parameter.value.empty()) {
      refuse("selective: " + std::string(parameter.name), parameter.now);
    }
    if (value->second == parameter.value) {
      refuse("selective: " + value->first + "=" + value->second, parameter.now);
    }
  }
}

}  // namespace ajar
