#include "session/render/resolved_render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "integrator/make_filter.h"
#include "session/options/limits.h"
#include "session/scenes/catalog.h"
#include "session/scenes/scene_file.h"

namespace ajar {

namespace {

constexpr const char* kDefaultIntegrator = "selective";
/// Default in files of other renderers: no explicit choice.
constexpr const char* kPlain = "pt";

bool is_integrator(const std::string& name) {
  const auto& all = integrators();
  return std::any_of(all.begin(), all.end(),
                     [&](const IntegratorInfo& info) { return info.name == name; });
}

bool declares(const IntegratorInfo& info, const std::string& parameter) {
  return std::any_of(info.parameters.begin(), info.parameters.end(),
                     [&](const ParameterSpec& spec) { return spec.name == parameter; });
}

void choose_integrator(const RenderSpec& spec, const desc::RenderHints& hints,
                       ResolvedRender& setup) {
  if (!spec.integrator.empty()) {
    setup.integrator = &find_integrator(spec.integrator);
  } else if (hints.integrator == kPlain) {
    setup.integrator = &find_integrator(kDefaultIntegrator);
    setup.notes.push_back(fmt::format(
        "integrator {}, which finds more light than the path tracing that the scene asks for "
        "(--integrator {})",
        kDefaultIntegrator, kPlain));
  } else if (is_integrator(hints.integrator)) {
    setup.integrator = &find_integrator(hints.integrator);
    if (hints.integrator != kDefaultIntegrator) {
      setup.notes.push_back(
          fmt::format("integrator {} (the scene asks for it; --integrator {} is what others get)",
                      hints.integrator, kDefaultIntegrator));
    }
  } else {
    setup.integrator = &find_integrator(kDefaultIntegrator);
    setup.notes.push_back(
        hints.integrator.empty()
            ? fmt::format("integrator {} (the scene asks for none)", kDefaultIntegrator)
            : fmt::format("integrator {} (the scene asks for {}, which does not "
                          "exist here)",
                          kDefaultIntegrator, hints.integrator));
  }
}

/// Other renderers' names of the parameters of chains.
std::string our_name(const std::string& name) {
  if (name == "bootstrapsamples") return "bootstrap";
  if (name == "largestepprobability") return "large-step";
  return name;
}

/// Takes a parameter from the scene if it is of use here; a scene made for another renderer is no
/// reason to refuse.
void take_hint(const std::string& name, const std::string& value, ResolvedRender& setup) {
  const IntegratorInfo& info = *setup.integrator;
  if (!declares(info, name)) return;
  try {
    const Parameters refuses_nonsense(info.parameters, {{name, value}});
    setup.parameters[name] = value;
  } catch (const UsageError& error) {
    setup.notes.push_back(fmt::format("ignored what the scene asks for: {}", error.what()));
  }
}

void choose_parameters(const RenderSpec& spec, const desc::RenderHints& hints,
                       ResolvedRender& setup) {
  const IntegratorInfo& info = *setup.integrator;
  if (hints.integrator == info.name) {
    for (const auto& [name, value] : hints.parameters) {
      take_hint(our_name(name), value, setup);
      // Only Gaussian steps have a width.
      if (name == "sigma") take_hint("mutation", "gaussian", setup);
    }
  }
  if (hints.sampler && declares(info, "sampler")) setup.parameters["sampler"] = *hints.sampler;
  for (const auto& [name, value] : spec.parameters) setup.parameters[name] = value;
}

void choose_budget(const RenderSpec& spec, const desc::RenderHints& hints, ResolvedRender& setup) {
  setup.budget = spec.budget();
  Budget& budget = setup.budget;
  if (!budget.samples_per_pixel && !budget.seconds && !budget.target_error) {
    const int samples = hints.samples_per_pixel.value_or(ResolvedRender::kDefaultSamples);
    budget.samples_per_pixel = static_cast<std::uint64_t>(std::max(1, samples));
  }
  setup.settings.replicates = ResolvedRender::kReplicates;
  if (budget.samples_per_pixel && *budget.samples_per_pixel < ResolvedRender::kReplicates) {
    setup.settings.replicates = static_cast<int>(*budget.samples_per_pixel);
  }
  check_budget(budget, setup.settings.replicates);
}

void choose_depth(const RenderSpec& spec, const desc::RenderHints& hints, ResolvedRender& setup) {
  RenderSettings& settings = setup.settings;
  settings.min_depth = spec.min_depth.value_or(1);
  settings.max_depth =
      spec.max_depth.value_or(hints.max_depth.value_or(desc::RenderHints::kDefaultMaxDepth));
  if (settings.min_depth > settings.max_depth) {
    throw UsageError(fmt::format("--depth: the minimum {} is above the maximum {}{}",
                                 settings.min_depth, settings.max_depth,
                                 spec.max_depth ? "" : " of the scene; give both, MIN:MAX"));
  }
}

std::optional<CropWindow> crop_of(const RenderSpec& spec) {
  if (!spec.crop) return spec.crop_window;
  CropWindow window{.fractions = false};
  std::copy(spec.crop->begin(), spec.crop->end(), window.values.begin());
  return window;
}

void choose_pixels(const RenderSpec& spec, const desc::Film& film, ResolvedRender& setup) {
  Vec2i& resolution = setup.resolution;
  resolution = film.resolution;
  if (const auto& size = spec.resolution) resolution = {size->at(0), size->at(1)};
  if (spec.scale) {
    if (!(*spec.scale > 0.0) || !std::isfinite(*spec.scale)) {
      throw UsageError("--scale must be above zero");
    }
    const auto scaled = [&](int size) {
      return static_cast<int>(
          std::clamp(std::round(size * *spec.scale), 1.0, 2.0 * kMaxResolution));
    };
    resolution = {scaled(film.resolution.x), scaled(film.resolution.y)};
  }
  if (resolution.x < 1 || resolution.y < 1 || resolution.x > kMaxResolution ||
      resolution.y > kMaxResolution) {
    const std::string message =
        fmt::format("a picture of {}x{} pixels is not possible (1 to {} each)", resolution.x,
                    resolution.y, kMaxResolution);
    if (spec.scale) throw UsageError("--scale: " + message);
    throw SceneError(film.where, message);
  }
  if (const auto crop = crop_of(spec)) {
    setup.crop = crop_pixels("crop", *crop, resolution);
  } else {
    const CropWindow window{{film.crop[0], film.crop[2], film.crop[1], film.crop[3]}, true};
    try {
      setup.crop = crop_pixels("crop window", window, resolution);
    } catch (const UsageError& error) {
      throw SceneError(film.where, error.what());
    }
  }
}

}  // namespace

ResolvedRender resolve_render(const RenderSpec& spec, const desc::RenderHints& hints,
                              const desc::Film& film) {
  ResolvedRender setup;
  choose_integrator(spec, hints, setup);
  choose_parameters(spec, hints, setup);
  choose_budget(spec, hints, setup);
  choose_depth(spec, hints, setup);
  choose_pixels(spec, film, setup);
  setup.settings.seed = spec.seed;
  setup.settings.resolution = setup.resolution;
  setup.settings.crop = setup.crop;
  setup.aovs = checked_aovs(spec.layers);
  for (const std::string& name : setup.aovs) {
    if (find_aov(name)->made_by_method) setup.settings.aovs.push_back(name);
  }
  return setup;
}

void check_budget(const Budget& budget, int replicates) {
  if (!budget.target_error) return;
  if (!(*budget.target_error > 0.0)) throw UsageError("--target-error must be above zero");
  if (replicates < 2) {
    throw UsageError("--target-error needs at least --spp 2: one sample has no spread");
  }
}

ResolvedRender setup_of(const RenderRecord& record, const Budget& budget) {
  ResolvedRender setup;
  setup.integrator = &find_integrator(record.integrator);
  setup.parameters = record.given;
  setup.budget = budget;
  setup.settings = record.settings;
  setup.aovs = record.spec.layers;
  setup.resolution = record.settings.resolution;
  setup.crop = record.settings.crop;
  check_budget(budget, setup.settings.replicates);
  return setup;
}

RenderRecord record_of(const ResolvedRender& setup, const Parameters& parameters,
                       const std::string& scene, RenderSpec spec) {
  RenderRecord record;
  record.scene = absolute_scene(scene);
  record.integrator = setup.integrator->name;
  for (const ParameterSpec& of : setup.integrator->parameters) {
    if (parameters.matters(of)) record.parameters[of.name] = parameters.values().at(of.name);
  }
  record.given = parameters.given();
  record.settings = setup.settings;
  record.spec = std::move(spec);
  record.spec.set_budget(setup.budget);
  record.spec.layers = setup.aovs;
  return record;
}

RenderSettings settings_for(const Scene& scene) {
  RenderSettings settings;
  settings.resolution = scene.camera().resolution();
  settings.crop = Box2i(Vec2i(0, 0), settings.resolution - Vec2i(1, 1));
  return settings;
}

Film film_for(const Scene& scene, const RenderSettings& settings, const Integrator& integrator) {
  return {settings.resolution, settings.crop, make_filter(scene.film().filter), settings.replicates,
          integrator.layers()};
}

void check_layers(const ResolvedRender& setup, const std::vector<LayerSpec>& layers) {
  for (const std::string& name : setup.settings.aovs) {
    // An AOV is a layer, or a group of layers whose names begin with it, or made with another.
    const AovInfo* const info = find_aov(name);
    const std::string sought = info != nullptr && !info->made_with.empty() ? info->made_with : name;
    const bool made = std::any_of(layers.begin(), layers.end(), [&](const LayerSpec& layer) {
      return layer.name == sought || layer.name.starts_with(sought + ".");
    });
    if (!made) {
      throw UsageError(setup.integrator->name + " does not make the AOV \"" + name +
                       "\"; with \"all\" you get what it makes");
    }
  }
}

}  // namespace ajar
