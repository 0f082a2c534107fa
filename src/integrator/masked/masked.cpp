#include "integrator/masked/masked.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/inactive_parameters.h"
#include "core/random.h"
#include "core/random_use.h"
#include "image/statistics.h"
#include "integrator/division.h"
#include "integrator/make_filter.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/chain_moves.h"
#include "integrator/metropolis/erpt.h"
#include "integrator/metropolis/metropolis.h"
#include "integrator/metropolis/mlt.h"
#include "integrator/montecarlo/path_family.h"
#include "integrator/regions/impulse_noise.h"
#include "integrator/regions/region_layers.h"
#include "integrator/regions/region_map.h"
#include "integrator/regions/surface_edges.h"
#include "integrator/regions/surface_pilot.h"
#include "integrator/regions/user_regions.h"

namespace ajar {

namespace {

// ---------------------------------------------------------------- parameters

std::vector<ParameterSpec> parameters_of_chain(const std::string& chain) {
  if (chain == "mlt") return mlt_parameters();
  if (chain == "erpt") return erpt_parameters();
  return metropolis_parameters(chain == "pssmlt" ? ChainSpace::Pssmlt : ChainSpace::Mmlt);
}

/// Parameters that are passed on to the chains, and which chains have them.
struct PassedOn {
  const char* name;
  std::vector<std::string> chains;
};
const std::vector<PassedOn>& passed_on() {
  static const std::vector<PassedOn> kPassedOn = {
      {"mutation", {"mmlt", "pssmlt"}},   {"sigma", {"mmlt", "pssmlt"}},
      {"large-step", {"mmlt", "pssmlt"}}, {"chains", {"mmlt", "pssmlt", "mlt"}},
      {"chain-length", {"erpt"}},         {"bootstrap", {"mmlt", "pssmlt", "mlt", "erpt"}}};
  return kPassedOn;
}

std::vector<ParameterSpec> own_parameters() {
  return {
      choice_parameter("chain", {"mmlt", "pssmlt", "mlt", "erpt"},
                       "method of Markov chains that makes the indirect light of masked regions"),
      {.name = "omc",
       .type = ParameterType::Text,
       .default_value = "ibpt",
       .unit = "",
       .help = "techniques of ordinary Monte Carlo (published: ibpt and lt)",
       .choices = {}},
      {.name = "pilot-samples",
       .type = ParameterType::Int,
       .default_value = "16",
       .unit = "samples",
       .help = "camera samples per pixel that the mask is made from (published: 16 to 64)",
       .choices = {},
       .minimum = 1,
       .maximum = 4096},
      choice_parameter("pilot", {"discard", "keep"},
                       "samples that the mask is made from: discard, or keep them in the picture, "
                       "as published, which is biased"),
      number_parameter("threshold", "0.5", "impulse noise from which on a region is masked (T)",
                       1.0),
      number_parameter("epsilon", "0.1",
                       "mask of the other regions (ε): above 0 it ties chains to the whole picture",
                       1.0),
      {.name = "window",
       .type = ParameterType::Int,
       .default_value = "3",
       .unit = "pixels",
       .help = "window of the median that noise is measured against: 3 or 5",
       .choices = {},
       .minimum = 3,
       .maximum = 5},
      choice_parameter(
          "choice", {"mix", "exclusive"},
          "the picture is the mix of both methods by the mask, or each pixel is of one "
          "of them alone"),
      choice_parameter("lambertian", {"mask", "omc"},
                       "regions of Lambertian materials: by the mask, or left to ordinary Monte "
                       "Carlo (published with omc=lt)"),
      UserRegions::parameter(),
      choice_parameter("edges", {"none", "antialias"},
                       "smooth the stairs that the mask leaves at the edges of objects, in .png "
                       "and .jpg"),
      {.name = "mutations",
       .type = ParameterType::Int,
       .default_value = "1",
       .unit = "",
       .help = "mutations per pixel for each camera sample",
       .choices = {},
       .minimum = 1,
       .maximum = 1000}};
}

/// The parameters of the chains' own method.
Parameters chain_parameters(const Parameters& parameters) {
  std::map<std::string, std::string> given;
  for (const PassedOn& passed : passed_on()) {
    if (parameters.given().contains(passed.name)) {
      given[passed.name] = parameters.given().at(passed.name);
    }
  }
  return {parameters_of_chain(parameters.get_text("chain")), given};
}

// ---------------------------------------------------------------- the method

/// Color = D + I_omc · (1 − σ) + I_mlt,σ
///
///     RunOMC(direct → image1, indirect → image2)
///     σ = AggregateAndSpread(EstimateNoise(image2))
///     image1 += image2 · (1 − σ)                                 if the pilot is kept
///     loop: RunOMC(direct + indirect · (1 − σ) → image1); RunMLT(indirect → image2, target I · σ)
///
/// The layers "direct" and kWeakLayer are image1, "indirect" is image2.
class MaskedIntegrator final : public Integrator {
 public:
  MaskedIntegrator(const Scene& scene, const RenderSettings& settings,
                   const Parameters& parameters);

  PreparationRound begin_preparation(int round) override;
  void prepare_item(int round, std::uint64_t item, Counters& counters) override;
  void skip_preparation(PreparationCut of) override;
  Findings findings() const override;

  std::vector<LayerSpec> layers() const override;
  std::uint64_t items_in_round() const override { return omc_items() + chain_items(); }
  void begin_pass(std::uint64_t first_sample, std::uint64_t samples, Film& film) override;
  void run_item(std::uint64_t item, std::uint64_t first_sample, std::uint64_t samples, Film& film,
                Counters& counters) override;
  bool is_of_chains(std::uint64_t item) const override { return item >= omc_items(); }
  DevelopScale develop_scale(const LayerSpec& layer, std::uint64_t samples,
                             std::optional<int> replicate) const override;
  MethodReport report() const override;

  bool keeps_state() const override { return chains_ && chains_->keeps_state(); }
  void save_state(OutputArchive& archive) const override;
  void load_state(InputArchive& archive, std::uint64_t samples) override;
  void export_delta(OutputArchive& archive, const WorkSlice& slice) override;
  void import_delta(InputArchive& archive, const WorkSlice& slice) override;
  std::uint64_t memory_bytes() const override { return chains_ ? chains_->memory_bytes() : 0; }

 private:
  /// Rounds of the preparation; those of the chains follow.
  enum Round : int { kFindRegions, kRunPilot, kSeedChains };

  Parameters omc_parameters() const {
    return {path_family_parameters(path_family_defaults(parameters_.get_text("omc"))), {}};
  }
  void begin_pilot();
  void make_mask();
  std::vector<float> mask_of_regions(const std::vector<RegionNoise>& noise) const;
  void make_omc(const Divisions* mask);
  void make_chains();
  Plane importance() const;
  double chain_effort() const;
  std::uint64_t omc_items() const { return omc_->items_in_round(); }
  std::uint64_t chain_items() const { return chains_ ? chains_->items_in_round() : 0; }
  /// Camera samples per pixel after `samples` samples of the render.
  std::uint64_t omc_samples(std::uint64_t samples) const { return kept_ + samples; }
  std::uint64_t mutations(std::uint64_t samples) const { return samples * mutations_; }
  /// Share of the chains' items, which come after the others in a pass.
  WorkSlice slice_of_chains(const WorkSlice& slice) const {
    return {(slice.index + slice.count - omc_items() % slice.count) % slice.count, slice.count};
  }

  const Scene& scene_;
  RenderSettings settings_;
  Parameters parameters_;
  UserRegions user_;
  RegionMapSettings map_;
  std::uint64_t pilot_samples_;
  std::uint64_t mutations_;
  ImportanceMap uniform_;

  std::unique_ptr<SurfacePilot> surface_pilot_;
  std::unique_ptr<Integrator> pilot_;
  std::unique_ptr<Film> pilot_film_;
  std::optional<Divisions> everything_;  ///< the pilot's: all light is of ordinary Monte Carlo
  Surfaces surfaces_;
  std::optional<Plane> noise_;
  std::vector<double> region_noise_;
  std::optional<Divisions> mask_;  ///< σ
  std::uint64_t kept_ = 0;         ///< camera samples per pixel of a pilot that is kept
  std::optional<PreparationCut> preparation_cut_;

  std::unique_ptr<Integrator> omc_;
  std::unique_ptr<Integrator> chains_;  ///< null: all light is of ordinary Monte Carlo
};

MaskedIntegrator::MaskedIntegrator(const Scene& scene, const RenderSettings& settings,
                                   const Parameters& parameters)
    : scene_(scene),
      settings_(settings),
      parameters_(parameters),
      user_(UserRegions::read(parameters.get_text("regions"), scene, settings)),
      map_{parameters.get_int("window"), static_cast<float>(parameters.get_float("threshold")),
           static_cast<float>(parameters.get_float("epsilon"))},
      pilot_samples_(static_cast<std::uint64_t>(parameters.get_int("pilot-samples"))),
      mutations_(static_cast<std::uint64_t>(parameters.get_int("mutations"))) {
  refuse_inactive(masked_parameters(), parameters);
  if (map_.window == 4) throw UsageError("window: 3 or 5 pixels, not 4");
  // Replicates have as many samples each.
  const auto replicates = static_cast<std::uint64_t>(settings.replicates);
  pilot_samples_ = (pilot_samples_ + replicates - 1) / replicates * replicates;
  make_omc(nullptr);
}

// ---------------------------------------------------------------- preparation

PreparationRound MaskedIntegrator::begin_preparation(int round) {
  if (settings_.max_depth <= Division::kDirectDepth) return {};
  const bool keeps = parameters_.get_text("pilot") == "keep";
  const auto samples = static_cast<double>(pilot_samples_);
  if (round == kFindRegions) {
    surface_pilot_ = std::make_unique<SurfacePilot>(scene_, beside_chains(settings_));
    return {.items = surface_pilot_->begin(),
            .effort = surface_pilot_->effort(),
            .later_effort = samples + chain_effort(),
            .later_kept_effort = keeps ? samples : 0.0};
  }
  if (round == kRunPilot) {
    surface_pilot_->end();
    surfaces_ = surface_pilot_->take();
    surface_pilot_.reset();
    begin_pilot();
    return {.items = pilot_->items_in_round(),
            .effort = samples,
            .later_effort = chain_effort(),
            .stays = keeps};
  }
  if (round == kSeedChains) {
    make_mask();
    make_omc(&*mask_);
    make_chains();
  }
  return chains_->begin_preparation(round - kSeedChains);
}

void MaskedIntegrator::prepare_item(int round, std::uint64_t item, Counters& counters) {
  if (round == kFindRegions) {
    surface_pilot_->run(item, counters);
  } else if (round == kRunPilot) {
    Counters own;
    pilot_->run_item(item, 0, pilot_samples_, *pilot_film_, own);
    counters.add_rays(own);
  } else {
    chains_->prepare_item(round - kSeedChains, item, counters);
  }
}

void MaskedIntegrator::skip_preparation(PreparationCut of) {
  preparation_cut_ = of;
  kept_ = 0;
  mask_.reset();
  noise_.reset();
  pilot_film_.reset();
  chains_.reset();
  make_omc(nullptr);
}

double MaskedIntegrator::chain_effort() const {
  const Vec2i size = settings_.crop.size() + Vec2i(1, 1);
  return static_cast<double>(parameters_.get_int("bootstrap")) /
         (static_cast<double>(size.x) * static_cast<double>(size.y));
}

void MaskedIntegrator::make_omc(const Divisions* mask) {
  omc_ =
      make_path_integrator(scene_, beside_chains(settings_), omc_parameters(), {.divisions = mask});
}

/// RunOMC(direct → image1, indirect → image2)
void MaskedIntegrator::begin_pilot() {
  RenderSettings own = beside_chains(settings_);
  if (parameters_.get_text("pilot") == "discard") {
    own.seed = hash_numbers(own.seed, RandomUse::DivisionPilot);
    own.aovs.clear();
  }
  everything_.emplace(Division(
      own.crop, {{.threshold = 0.F, .target_scale = 0.F, .deposit_scale = 0.F}}, uniform_));
  pilot_ = make_path_integrator(scene_, own, omc_parameters(), {.divisions = &*everything_});
  pilot_film_ = std::make_unique<Film>(own.resolution, own.crop, make_filter(scene_.film().filter),
                                       own.replicates, pilot_->layers());
}

/// σ = AggregateAndSpread(EstimateNoise(image2))
void MaskedIntegrator::make_mask() {
  const std::vector<float> indirect = pilot_film_->develop(
      pilot_film_->layer(kWeakLayer), 1.0 / static_cast<double>(pilot_samples_));
  const Regions& regions = surfaces_.regions;
  noise_ = impulse_noise(regions.size, indirect, map_.window);
  const std::vector<RegionNoise> noise = aggregate_noise(*noise_, regions, map_.threshold);
  for (const RegionNoise& region : noise) {
    region_noise_.push_back(static_cast<double>(region.fill()));
  }
  const std::vector<float> sigma = mask_of_regions(noise);
  std::vector<PixelDivision> pixels;
  for (std::size_t i = 0; i < regions.labels.size(); ++i) {
    const float weight = user_.painted.empty() ? sigma[regions.labels[i]] : user_.painted[i];
    const bool is_exclusive = parameters_.get_text("choice") == "exclusive";
    const float whole = weight > map_.epsilon ? 1.F : 0.F;
    pixels.push_back(
        {.threshold = 0.F, .target_scale = weight, .deposit_scale = is_exclusive ? whole : weight});
  }
  mask_.emplace(Division(settings_.crop, std::move(pixels), uniform_));
  if (parameters_.get_text("pilot") == "keep") {
    kept_ = pilot_samples_;
  } else {
    pilot_film_.reset();
  }
  pilot_.reset();
}

std::vector<float> MaskedIntegrator::mask_of_regions(const std::vector<RegionNoise>& noise) const {
  std::vector<float> sigma = threshold_map(noise, map_);
  const Regions& regions = surfaces_.regions;
  const auto fixed = user_.fixed_weights(regions, scene_, map_.epsilon);
  for (std::size_t r = 0; r < sigma.size(); ++r) {
    const std::uint32_t material = regions.identities[r].material;
    const bool is_lambertian =
        material > 0 && scene_.material(static_cast<desc::MaterialId>(material - 1)).is_diffuse();
    if (is_lambertian && parameters_.get_text("lambertian") == "omc") sigma[r] = map_.epsilon;
    sigma[r] = fixed[r].value_or(sigma[r]);
  }
  return sigma;
}

void MaskedIntegrator::make_chains() {
  RenderSettings own = settings_;
  own.min_depth = std::max(own.min_depth, Division::kDirectDepth + 1);
  std::erase_if(own.aovs, [](const std::string& name) { return !is_chain_layer(name); });
  const Parameters parameters = chain_parameters(parameters_);
  const std::string& chain = parameters_.get_text("chain");
  const ChainWeight* sigma = &mask_->of(0);
  if (chain == "mlt") {
    chains_ = make_mlt_integrator(scene_, own, parameters, sigma);
  } else if (chain == "erpt") {
    chains_ = make_erpt_integrator(scene_, own, parameters, sigma);
  } else {
    chains_ = make_metropolis_integrator(chain == "pssmlt" ? ChainSpace::Pssmlt : ChainSpace::Mmlt,
                                         scene_, own, parameters, sigma);
  }
}

// ---------------------------------------------------------------- render

std::vector<LayerSpec> MaskedIntegrator::layers() const {
  std::vector<LayerSpec> specs = omc_->layers();
  if (!chains_) {
    add_chain_layers(specs, settings_.aovs);
    return specs;
  }
  for (const LayerSpec& of_chains : chains_->layers()) {
    if (is_chain_layer(of_chains.name)) specs.push_back(of_chains);
    for (LayerSpec& spec : specs) {
      const bool is_indirect = spec.name == "indirect" || spec.box_of == "indirect";
      if (is_indirect && spec.name == of_chains.name) spec.magnitude = of_chains.magnitude;
    }
  }
  return specs;
}

/// image1 += image2 · (1 − σ), and the rest to the layer that filters take instead of the chains'.
void MaskedIntegrator::begin_pass(std::uint64_t first_sample, std::uint64_t samples, Film& film) {
  if (chains_) chains_->begin_pass(mutations(first_sample), mutations(samples), film);
  if (!pilot_film_) return;
  std::vector<std::string> divided;
  std::vector<std::string> not_added;
  for (const LayerSpec& spec : pilot_film_->layers()) {
    const std::string& light = spec.box_of.empty() ? spec.name : spec.box_of;
    if (light == kWeakLayer) divided.push_back(spec.name);
    if (light == kWeakLayer || light == "indirect") not_added.push_back(spec.name);
  }
  film.add_layers(*pilot_film_, not_added);
  const Vec2i first = settings_.crop.min;
  for (const std::string& name : divided) {
    const LayerSpec& spec =
        pilot_film_->layers()[static_cast<std::size_t>(pilot_film_->layer(name))];
    const auto strong =
        std::find_if(film.layers().begin(), film.layers().end(), [&](const LayerSpec& other) {
          return spec.box_of.empty() ? other.name == kStrongLayer : other.box_of == kStrongLayer;
        });
    for (int replicate = 0; replicate < film.replicates(); ++replicate) {
      const std::vector<float> sums =
          pilot_film_->develop_replicate(pilot_film_->layer(name), replicate, 1.0);
      for (std::size_t i = 0; 3 * i < sums.size(); ++i) {
        const int index = static_cast<int>(i);
        const Vec2i pixel = first + Vec2i(index % film.width(), index / film.width());
        const float kept = mask_->of(0).at(Vec2(pixel) + Vec2(0.5F, 0.5F)).deposit_scale;
        const Spectrum sum(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]);
        film.add(film.layer(name), replicate, pixel, sum * (1.F - kept));
        if (strong != film.layers().end()) {
          film.add(film.layer(strong->name), replicate, pixel, sum * kept);
        }
      }
    }
  }
  pilot_film_.reset();
}

/// RunOMC(direct + indirect · (1 − σ) → image1); RunMLT(indirect → image2, target I · σ)
void MaskedIntegrator::run_item(std::uint64_t item, std::uint64_t first_sample,
                                std::uint64_t samples, Film& film, Counters& counters) {
  if (item < omc_items()) {
    omc_->run_item(item, omc_samples(first_sample), samples, film, counters);
  } else {
    chains_->run_item(item - omc_items(), mutations(first_sample), mutations(samples), film,
                      counters);
  }
}

DevelopScale MaskedIntegrator::develop_scale(const LayerSpec& layer, std::uint64_t samples,
                                             std::optional<int> replicate) const {
  const bool is_of_chains = chains_ && (layer.name == "indirect" || layer.box_of == "indirect" ||
                                        is_chain_layer(layer.name));
  return is_of_chains ? chains_->develop_scale(layer, mutations(samples), replicate)
                      : omc_->develop_scale(layer, omc_samples(samples), replicate);
}

// ---------------------------------------------------------------- report, state

/// σ of each pixel as the picture has it.
Plane MaskedIntegrator::importance() const {
  Plane plane(surfaces_.regions.size);
  for (int y = 0; y < plane.size.y; ++y) {
    for (int x = 0; x < plane.size.x; ++x) {
      const Vec2 middle = Vec2(settings_.crop.min + Vec2i(x, y)) + Vec2(0.5F, 0.5F);
      plane.at(x, y) = mask_->of(0).at(middle).deposit_scale;
    }
  }
  return plane;
}

Findings MaskedIntegrator::findings() const {
  Findings found = omc_->findings();
  if (!chains_) {
    found.maps = black_region_layers(settings_.aovs, settings_.crop);
    if (preparation_cut_) {
      const char* missing = *preparation_cut_ == PreparationCut::Time ? "time" : "samples";
      found.notes = {std::string("too little ") + missing +
                     " for the mask: rendered by ordinary Monte Carlo; for Markov chains, begin "
                     "anew with more " +
                     missing};
    }
    return found;
  }
  Findings of_chains = chains_->findings();
  found.concerns.insert(found.concerns.end(), of_chains.concerns.begin(), of_chains.concerns.end());
  found.misses_light = found.misses_light || of_chains.misses_light;
  const Plane sigma = importance();
  found.maps = region_layers(settings_.aovs, surfaces_, *noise_, sigma);
  if (parameters_.get_text("edges") == "antialias") {
    found.antialias_mask = edges_of_map(surfaces_.edges, sigma);
  }
  return found;
}

MethodReport MaskedIntegrator::report() const {
  if (!chains_) return omc_->report();
  MethodReport report = chains_->report();
  report["masked"] = {
      {"pilot_samples_per_pixel", pilot_samples_},
      {"pilot_stays", kept_ > 0},
      {"mutations_per_sample", mutations_},
      {"region_count", surfaces_.regions.count()},
      {"regions", report_regions(scene_, surfaces_.regions, region_noise_, importance())}};
  return report;
}

void MaskedIntegrator::save_state(OutputArchive& archive) const {
  if (chains_) chains_->save_state(archive);
}

void MaskedIntegrator::load_state(InputArchive& archive, std::uint64_t samples) {
  pilot_film_.reset();
  if (chains_) chains_->load_state(archive, mutations(samples));
}

void MaskedIntegrator::export_delta(OutputArchive& archive, const WorkSlice& slice) {
  if (chains_) chains_->export_delta(archive, slice_of_chains(slice));
}

void MaskedIntegrator::import_delta(InputArchive& archive, const WorkSlice& slice) {
  if (chains_) chains_->import_delta(archive, slice_of_chains(slice));
}

}  // namespace

std::vector<ParameterSpec> masked_parameters() {
  std::vector<ParameterSpec> specs = own_parameters();
  mark_experts(specs,
               {"chain", "omc", "pilot-samples", "threshold", "epsilon", "regions", "edges"});
  for (const PassedOn& passed : passed_on()) {
    for (ParameterSpec& spec : parameters_of_chain(passed.chains.front())) {
      if (spec.name != passed.name) continue;
      // The choices that all of these chains have.
      if (spec.name == "mutation") spec = ChainMoves::parameters({}).front();
      spec.expert = true;
      spec.depends_on = "chain";
      spec.matters_for = passed.chains;
      specs.push_back(std::move(spec));
    }
  }
  return specs;
}

std::unique_ptr<Integrator> make_masked_integrator(const Scene& scene,
                                                   const RenderSettings& settings,
                                                   const Parameters& parameters) {
  return std::make_unique<MaskedIntegrator>(scene, settings, parameters);
}

}  // namespace ajar
