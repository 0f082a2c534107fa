#include "measuring/variant.h"

#include <map>
#include <sstream>
#include <utility>

#include "core/error.h"
#include "session/options/option_values.h"

namespace ajar::bench {

namespace {

std::vector<std::string> split_settings(const std::string& text) {
  std::vector<std::string> settings;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, ',');) {
    if (piece.find('=') != std::string::npos || settings.empty()) {
      settings.push_back(piece);
    } else {
      settings.back() += "," + piece;
    }
  }
  return settings;
}

}  // namespace

RenderRequest order_of(const Variant& variant, desc::SceneDesc description,
                       const RenderSettings& settings, double seconds) {
  RenderRequest order;
  order.scene = description.source;
  order.loaded = std::make_shared<LoadedScene>(std::move(description));
  RenderSpec& spec = order.spec;
  spec.integrator = variant.integrator->name;
  spec.parameters = variant.parameters.given();
  spec.seconds = seconds;
  spec.min_depth = settings.min_depth;
  spec.max_depth = settings.max_depth;
  spec.resolution = {settings.resolution.x, settings.resolution.y};
  spec.crop_window = CropWindow{{0.0, 0.0, 1.0, 1.0}, true};
  spec.seed = settings.seed;
  return order;
}

Variant parse_variant(const std::string& text) {
  const std::size_t colon = text.find(':');
  const IntegratorInfo& integrator = find_integrator(text.substr(0, colon));
  std::map<std::string, std::string> given;
  if (colon != std::string::npos) {
    const std::vector<std::string> settings = split_settings(text.substr(colon + 1));
    if (settings.empty()) throw UsageError("the variant \"" + text + "\" has no settings after :");
    given = parse_assignments("the variant \"" + text + "\"", settings);
  }
  return {text, &integrator, integrator.read(given)};
}

std::vector<Variant> parse_variants(const std::vector<std::string>& texts) {
  std::vector<Variant> variants;
  variants.reserve(texts.size());
  for (const std::string& text : texts) variants.push_back(parse_variant(text));
  return variants;
}

}  // namespace ajar::bench
