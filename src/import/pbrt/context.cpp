#include "import/pbrt/context.h"

#include <algorithm>
#include <array>

#include "import/common/printable.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {

/// Words that only pbrt-v4 has.
constexpr std::array<std::string_view, 22> kPbrt4Words = {"Option",
                                                          "ColorSpace",
                                                          "Attribute",
                                                          "rgb",
                                                          "gbuffer",
                                                          "spectral",
                                                          "diffuse",
                                                          "conductor",
                                                          "dielectric",
                                                          "coateddiffuse",
                                                          "coatedconductor",
                                                          "thindielectric",
                                                          "diffusetransmission",
                                                          "measured",
                                                          "interface",
                                                          "bilinearmesh",
                                                          "independent",
                                                          "zsobol",
                                                          "pmj02bn",
                                                          "spherical",
                                                          "directionmix",
                                                          "ptex"};

}  // namespace

void fail_unknown(const SourceLocation& where, std::string_view what, std::string_view name,
                  const std::vector<std::string>& valid) {
  std::string message = unknown_name_message(what, printable(name), valid);
  if (std::find(kPbrt4Words.begin(), kPbrt4Words.end(), name) != kPbrt4Words.end()) {
    message =
        std::string(what) + " \"" + std::string(name) +
        "\" belongs to pbrt-v4: this looks like a pbrt-v4 scene, but only pbrt-v3 can be read";
  }
  throw SceneError(where, message);
}

}  // namespace ajar::pbrt
