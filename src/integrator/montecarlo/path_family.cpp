#include "integrator/montecarlo/path_family.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "core/archive.h"
#include "core/milestones.h"
#include "core/random_use.h"
#include "image/statistics.h"
#include "integrator/make_filter.h"
#include "integrator/montecarlo/blind_spots.h"
#include "integrator/montecarlo/g_buffer.h"
#include "integrator/montecarlo/heuristics.h"
#include "integrator/montecarlo/path_parameters.h"
#include "integrator/montecarlo/sample_sink.h"
#include "integrator/montecarlo/technique_layers.h"
#include "integrator/montecarlo/weighted_errors.h"
#include "transport/sources.h"

namespace ajar {

namespace {

constexpr int kTileSize = 16;
constexpr int kMaxPathEdges = 60000;  // vertex numbers are 16 bits wide

class PathIntegrator final : public Integrator {
 public:
  PathIntegrator(const Scene& scene, const RenderSettings& settings, const Parameters& parameters,
                 const PathIntegratorContext& context)
      : scene_(scene),
        settings_(settings),
        divisions_(context.divisions),
        strong_(context.strong),
        joins_by_manifolds_(context.joins_by_manifolds),
        is_undecided_(context.is_undecided),
        sampler_settings_(sampler_settings(settings, parameters)),
        sobol_(parameters.get_text("sampler") == "sobol"),
        light_alone_(light_alone(sampler_settings_.techniques)),
        scale_(context.scale ? *context.scale : measure_scale()),
        roulette_(context.roulette) {
    const Vec2i size = settings.crop.size() + Vec2i(1, 1);
    tiles_ = {(size.x + kTileSize - 1) / kTileSize, (size.y + kTileSize - 1) / kTileSize};
    cull_below_ = parameters.get_float("cull") * scale_.median_of_means;
    // Without replicates, nobody knows the noise.
    if (roulette_ == nullptr && parameters.get_text("roulette") == "efficient" &&
        settings.replicates > 1) {
      own_roulette_ =
          std::make_unique<EfficientRoulette>(scene.bounds(), settings.crop, scale_.mean);
      roulette_ = own_roulette_.get();
    }
    if (roulette_ != nullptr) {
      sampler_settings_.cells = &roulette_->cells();
      sampler_settings_.light_cells = &roulette_->light_cells();
    }
  }
  const PictureScale& scale() const { return scale_; }
  Findings findings() const override;

  std::vector<LayerSpec> layers() const override {
    std::vector<LayerSpec> specs = light_layers(scale_.mean);
    if (divisions_ != nullptr) {
      specs.push_back({.name = kWeakLayer, .magnitude = scale_.mean, .part_of = "indirect"});
      // Where chains make nothing, there is no other estimate, which would cost filters their time.
      if (settings_.for_filters && !divisions_->take_nothing()) {
        specs.push_back({.name = kStrongLayer, .magnitude = scale_.mean, .instead_of = "indirect"});
      }
    }
    if (settings_.for_filters) add_box_layers(specs, make_filter(scene_.film().filter));
    for (LayerSpec& spec : GBuffer::layers(settings_.aovs, 2.F * scene_.bounding_sphere().radius)) {
      specs.push_back(std::move(spec));
    }
    const std::vector<std::string>& wanted = settings_.aovs;
    if (std::find(wanted.begin(), wanted.end(), TechniqueLayers::aov_name()) != wanted.end()) {
      for (LayerSpec& spec : TechniqueLayers::specs(sampler_settings_, scale_.mean)) {
        specs.push_back(std::move(spec));
      }
    }
    return specs;
  }

  void begin_pass(std::uint64_t first_sample, std::uint64_t /*samples*/, Film& film) override {
    if (!own_roulette_) return;
    const std::uint64_t doubling = last_doubling(first_sample, replicates());
    if (doubling <= doubled_at_) return;
    doubled_at_ = doubling;
    end_round(first_sample, film);
  }

  bool keeps_state() const override { return own_roulette_ != nullptr; }
  void save_state(OutputArchive& archive) const override {
    if (!own_roulette_) return;
    archive(doubled_at_);
    own_roulette_->save_state(archive);
  }
  void load_state(InputArchive& archive, std::uint64_t samples) override {
    if (!own_roulette_) return;
    archive(doubled_at_);
    if (doubled_at_ > samples) throw std::runtime_error("corrupt checkpoint: wrong pass");
    own_roulette_->load_state(archive);
  }
  void export_delta(OutputArchive& archive, const WorkSlice& /*slice*/) override {
    if (own_roulette_) own_roulette_->export_delta(archive);
  }
  void import_delta(InputArchive& archive, const WorkSlice& /*slice*/) override {
    if (own_roulette_) own_roulette_->import_delta(archive);
  }
  std::uint64_t memory_bytes() const override {
    return own_roulette_ ? own_roulette_->memory_bytes() : 0;
  }

  std::uint64_t items_in_round() const override {
    return static_cast<std::uint64_t>(tiles_.x) * static_cast<std::uint64_t>(tiles_.y);
  }

  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override {
    const auto columns = static_cast<std::uint64_t>(tiles_.x);
    const Vec2i tile(static_cast<int>(item % columns), static_cast<int>(item / columns));
    const Vec2i low = settings_.crop.min + tile * kTileSize;
    const Vec2i high(std::min(low.x + kTileSize - 1, settings_.crop.max.x),
                     std::min(low.y + kTileSize - 1, settings_.crop.max.y));
    const GBuffer g_buffer(film);
    const TechniqueLayers techniques(film);
    SampleSink sink(film, divisions_, roulette_, cull_below_, g_buffer, techniques, settings_.seed,
                    counters);
    PathSampler sampler(scene_, sampler_settings_);
    const auto strong = strong_ != nullptr ? strong_->make(film, counters) : nullptr;
    if (strong) sink.keep_strong_for(*strong);
    if (is_undecided_) sink.learn_from_all();
    std::uint64_t own_samples = 0;
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        for (std::uint64_t i = first_sample; i < first_sample + samples; ++i) {
          sample_pixel({x, y}, i, film, sampler, sink, strong.get());
        }
        sink.end_pixel(samples);
        own_samples += samples;
      }
    }
    sink.end();
    counters.samples += own_samples;
    counters.add_rays(sampler.ray_counts());
    if (roulette_ != nullptr) roulette_->count(sampler.rays(), own_samples);
  }

  DevelopScale develop_scale(const LayerSpec& /*layer*/, std::uint64_t samples,
                             std::optional<int> replicate) const override {
    if (samples == 0) return 0.0;
    if (!replicate) return 1.0 / static_cast<double>(samples);
    const auto count = static_cast<std::uint64_t>(settings_.replicates);
    const auto index = static_cast<std::uint64_t>(*replicate);
    const std::uint64_t own = samples / count + (samples % count > index ? 1 : 0);
    return own == 0 ? 0.0 : 1.0 / static_cast<double>(own);
  }

 private:
  /// The picture's samples take turns: number i belongs to replicate i mod R and is number i / R of
  /// those there.
  std::uint64_t replicates() const { return static_cast<std::uint64_t>(settings_.replicates); }

  /// Number within the image of a pixel's sample number `index`.
  std::uint64_t number_in_image(Vec2i pixel, std::uint64_t index) const {
    const Vec2i size = settings_.crop.size() + Vec2i(1, 1);
    const auto pixel_number = static_cast<std::uint64_t>(pixel.y - settings_.crop.min.y) *
                                  static_cast<std::uint64_t>(size.x) +
                              static_cast<std::uint64_t>(pixel.x - settings_.crop.min.x);
    const auto pixels = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
    return index * pixels + pixel_number;
  }

  /// The light's sequence is cut where its 32-bit index would overflow; each part has its own
  /// scrambling.
  std::uint64_t light_seed(std::uint64_t replicate, std::uint64_t light_number) const {
    return hash_numbers(settings_.seed, replicate, RandomUse::LightSubpaths, light_number >> 32U);
  }

  SampleIdentity camera_identity(Vec2i pixel, std::uint64_t replicate, std::uint64_t index) const {
    const std::uint64_t number = number_in_image(pixel, index);
    return {.camera_seed = hash_numbers(settings_.seed, replicate, pixel.x, pixel.y),
            .camera_index = static_cast<std::uint32_t>(index),
            .light_seed = light_seed(replicate, number),
            .light_index = static_cast<std::uint32_t>(number)};
  }

  /// Identity of a light subpath that belongs to no camera path; it makes its connections by
  /// numbers of its own, too.
  SampleIdentity light_identity(std::uint64_t replicate, std::uint64_t light_number) const {
    const std::uint64_t seed = light_seed(replicate, light_number);
    const auto index = static_cast<std::uint32_t>(light_number);
    return {hash_numbers(seed, RandomUse::LightScramble), index, seed, index};
  }

  template <typename Use>
  void with_source(const SampleIdentity& identity, const Use& use) const {
    if (sobol_) {
      SobolSource source(identity);
      use(source);
    } else {
      IndependentSource source(identity);
      use(source);
    }
  }

  /// Sample number `i` of a pixel, and the light subpaths that belong to it.
  void sample_pixel(Vec2i pixel, std::uint64_t i, const Film& film, PathSampler& sampler,
                    SampleSink& sink, OutlierSink* strong) const {
    const std::uint64_t replicate = i % replicates();
    const std::uint64_t index = i / replicates();
    sink.begin_pixel(pixel, static_cast<int>(replicate));
    with_source(camera_identity(pixel, replicate, index), [&](SampleSource& source) {
      const FilterSample filtered =
          film.filter().sample(source.get_pair({Stream::Camera, 0, kEmissionDirection}));
      const Vec2 raster = Vec2(pixel) + Vec2(0.5F, 0.5F) + filtered.offset;
      sink.begin_sample(raster, filtered.weight, i);
      if (strong != nullptr) {
        sink.begin_paths(
            hash_numbers(settings_.seed, RandomUse::StrongCameraPath, pixel.x, pixel.y, i));
      }
      sampler.sample(source, raster, sink);
      if (strong != nullptr) sink.hand_over(*strong, source);
    });
    sink.end_sample();
    if (light_alone_) sample_light(replicate, number_in_image(pixel, index), sampler, sink, strong);
  }

  /// The light subpaths that belong to number `number` of the picture's camera samples.
  void sample_light(std::uint64_t replicate, std::uint64_t number, PathSampler& sampler,
                    SampleSink& sink, OutlierSink* strong) const {
    const auto [first, last] = light_numbers(number);
    for (std::uint64_t n = first; n < last; ++n) {
      with_source(light_identity(replicate, n), [&](SampleSource& source) {
        if (strong != nullptr) {
          sink.begin_paths(hash_numbers(light_seed(replicate, n), RandomUse::StrongLightPath, n));
        }
        sampler.sample_light(source, sink);
        if (strong != nullptr) sink.hand_over(*strong, source);
      });
    }
  }

  /// Evenly spread, and one gapless sequence.
  std::pair<std::uint64_t, std::uint64_t> light_numbers(std::uint64_t number) const {
    const auto upto = [&](std::uint64_t n) {
      return static_cast<std::uint64_t>(static_cast<double>(n) * sampler_settings_.light_subpaths);
    };
    return {upto(number), upto(number + 1)};
  }

  PictureScale measure_scale() const;
  /// Own roulette learns from what was rendered so far.
  void end_round(std::uint64_t samples, const Film& film);

  const Scene& scene_;
  RenderSettings settings_;
  const Divisions* divisions_;
  const OutlierSinkFactory* strong_;
  bool joins_by_manifolds_;
  bool is_undecided_;
  PathSamplerSettings sampler_settings_;
  bool sobol_;
  bool light_alone_;
  PictureScale scale_;  ///< by its mean the fixed-point sums are scaled
  double cull_below_;   ///< light that is worth a ray, unless roulette knows better
  std::unique_ptr<EfficientRoulette> own_roulette_;
  EfficientRoulette* roulette_;   ///< null if roulette follows the throughput alone
  std::uint64_t doubled_at_ = 0;  ///< samples per pixel
  Vec2i tiles_;
  mutable std::once_flag looked_around_;
  mutable std::vector<Warning> concerns_;
};

Findings PathIntegrator::findings() const {
  std::call_once(looked_around_, [this] {
    concerns_ = blind_spots(scene_, settings_, sampler_settings_, joins_by_manifolds_);
  });
  Findings found;
  found.concerns = concerns_;
  found.misses_light = !concerns_.empty();
  return found;
}

void PathIntegrator::end_round(std::uint64_t samples, const Film& film) {
  const Replicates pictures = develop_layers(film, *this, samples, {"direct", "indirect"});
  const ImportanceMap importance = relative_importance(pictures, settings_.crop);
  own_roulette_->end_round(
      importance, weighted_errors(pictures, settings_.crop, importance).of_sample(samples));
}

class MeanSink final : public PathSink {
 public:
  void add(const Contribution& contribution) override {
    if (contribution.value.is_finite()) sum += static_cast<double>(contribution.value.max());
  }
  double sum = 0.0;
};

PictureScale PathIntegrator::measure_scale() const {
  constexpr std::size_t kGroups = MonteCarloHeuristics::kScaleGroups;
  constexpr std::uint32_t kGroupSize = MonteCarloHeuristics::kScaleGroupSize;
  PathSampler sampler(scene_, sampler_settings_);
  const Vec2 low(settings_.crop.min);
  const Vec2 size(settings_.crop.size() + Vec2i(1, 1));
  const std::uint64_t seed = hash_numbers(settings_.seed, RandomUse::PictureScale);
  std::array<double, kGroups> means{};
  double mean = 0.0;
  for (std::uint32_t group = 0; group < kGroups; ++group) {
    MeanSink camera;
    MeanSink light;
    for (std::uint32_t i = group * kGroupSize; i < (group + 1) * kGroupSize; ++i) {
      SobolSource source({seed, i, seed, i});
      const Vec2 u = source.get_pair({Stream::Camera, 0, kEmissionDirection});
      if (light_alone_) sampler.sample_light(source, light);
      sampler.sample(source, low + u * size, camera);
    }
    means[group] = (camera.sum + light.sum * sampler_settings_.light_subpaths) / kGroupSize;
    mean += means[group] / kGroups;
  }
  std::nth_element(means.begin(), means.begin() + kGroups / 2, means.end());
  return {mean > 0.0 && std::isfinite(mean) ? mean : 1.0, means[kGroups / 2]};
}

}  // namespace

PathFamilyDefaults path_family_defaults(const std::string& techniques) {
  PathFamilyDefaults defaults{.techniques = techniques};
  // Light subpaths that keep the cost of a sample within 1.6 times that of path tracing.
  if (techniques == "ibpt") defaults.light_paths_per_pixel = 0.33;
  // Its light subpaths end anyway in techniques that share the path with others.
  if (techniques == "bdpt") defaults.roulette_start = 3;
  return defaults;
}

bool light_alone(const TechniqueSet& techniques) {
  return techniques.any(TechniqueClass::Light) && !techniques.any(TechniqueClass::Inner);
}

PathSamplerSettings sampler_settings(const RenderSettings& settings, const Parameters& parameters) {
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  const double pixels = static_cast<double>(settings.resolution.x) * settings.resolution.y;
  PathSamplerSettings result;
  result.techniques = TechniqueSet::parse(parameters.get_text("techniques"));
  result.heuristic = heuristic_of(parameters);
  result.min_depth = settings.min_depth;
  result.max_depth = std::min(settings.max_depth, kMaxPathEdges);
  result.counted = settings.counted;
  result.roulette_start = parameters.get_int("roulette-start");
  result.light_subpaths = parameters.get_float(kLightPathsPerPixel);
  result.light_paths_per_pixel =
      result.light_subpaths * static_cast<double>(size.x) * size.y / pixels;
  return result;
}

std::vector<ParameterSpec> path_family_parameters(const PathFamilyDefaults& defaults) {
  std::vector<ParameterSpec> specs = {
      techniques_parameter(defaults.techniques, ", each with an optional count (explicit*4)"),
      light_paths_parameter(defaults.light_paths_per_pixel,
                            "light subpaths per camera sample, where the techniques have any"),
      {.name = "cull",
       .type = ParameterType::Float,
       .default_value = "0.03",
       .unit = "",
       .help =
           "connections weaker than this share of the picture's mean are traced by chance only, "
           "in proportion to their strength (unbiased); 0 traces all",
       .choices = {},
       .minimum = 0.0,
       .maximum = 1.0},
      {.name = "sampler",
       .type = ParameterType::Choice,
       .default_value = "sobol",
       .unit = "",
       .help =
           "where the random numbers come from: Owen-scrambled Sobol' points, or independent ones",
       .choices = {"sobol", "independent"}},
      heuristic_parameter(),
      roulette_parameter("usual"),
      roulette_start_parameter(defaults.roulette_start)};
  mark_experts(specs, {"techniques", kLightPathsPerPixel, "sampler"});
  return specs;
}

std::unique_ptr<Integrator> make_path_integrator(const Scene& scene, const RenderSettings& settings,
                                                 const Parameters& parameters,
                                                 const PathIntegratorContext& context) {
  return std::make_unique<PathIntegrator>(scene, settings, parameters, context);
}

PictureScale measure_scale(const Scene& scene, const RenderSettings& settings,
                           const Parameters& parameters) {
  return PathIntegrator(scene, settings, parameters, {}).scale();
}

}  // namespace ajar
