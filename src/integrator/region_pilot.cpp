#include "integrator/region_pilot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/random.h"
#include "image/edges.h"
#include "image/identities.h"
#include "image/make_filter.h"
#include "integrator/chain_bootstrap.h"
#include "integrator/path_family.h"

namespace ajar {

namespace {

const std::vector<std::string> kSurfaceLayers = {"object-id", "material-id", "depth", "normal"};

/// Before anything is measured: chains land in clusters.
constexpr double kTypicalCorrelation = 5.0;

bool stays(const SelectiveSettings& settings) {
  return settings.pilot != SelectiveSettings::Pilot::Discard;
}

float share_of_lowest(const PixelShare& share, float lowest) {
  return share.threshold > 0.F ? share.kept * lowest / share.threshold : share.kept;
}

}  // namespace

/// Puts strong light on the pilot's film, where the noise is looked for, keeps it to be divided
/// anew, and offers it to chains.
class RegionPilot::Sink final : public StrongPathSink {
 public:
  Sink(const RegionPilot& pilot, Film& film, Counters& counters)
      : pilot_(pilot),
        film_(film),
        counters_(counters),
        layer_(film.layer("indirect")),
        recruits_(pilot.recruits_ != nullptr ? pilot.recruits_->make(film, counters) : nullptr) {}
  ~Sink() override {
    const std::lock_guard lock(pilot_.mutex_);
    pilot_.found_.insert(pilot_.found_.end(), found_.begin(), found_.end());
  }
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;

  bool spread(SampleSource& numbers, StrongPath& path) override {
    if (!film_.splat(layer_, path.replicate, path.raster, path.value)) {
      ++counters_.discarded_infinite;
      return true;
    }
    StrongPath offered = path;
    const bool taken =
        !recruits_ || !pilot_.offers(path.replicate) || recruits_->spread(numbers, offered);
    if (taken) {
      keep(path);
    } else {
      keep_whole(offered);
    }
    return true;
  }

 private:
  void keep_whole(const StrongPath& path) {
    found_.push_back(
        {path.raster, path.replicate, path.strength, path.value, 0.0, 1.0, path.key, true});
  }

  /// Of paths that carry little, only some: the others stand behind them.
  void keep(const StrongPath& path) {
    const PixelShare& share = pilot_.plan_.splits->of(path.replicate).at(path.raster);
    const auto above = static_cast<double>(LightSplit::above(path.strength, share.threshold));
    FoundLight light{path.raster, path.replicate, path.strength, path.value, path.energy / above,
                     1.0,         path.key};
    const double carried = std::abs(path.energy);
    if (carried < pilot_.grain_) {
      const auto u = static_cast<double>(
          to_unit_float(static_cast<std::uint32_t>(hash_numbers(path.key, 0xf09dULL) >> 32U)));
      if (!(u * pilot_.grain_ < carried)) return;
      light.weight = pilot_.grain_ / carried;
      light.value *= static_cast<float>(light.weight);
    }
    found_.push_back(light);
  }

  const RegionPilot& pilot_;
  Film& film_;
  Counters& counters_;
  int layer_;
  std::unique_ptr<StrongPathSink> recruits_;
  std::vector<FoundLight> found_;
};

std::uint64_t RegionPilot::begin() {
  if (!(plan_.brightness > 0.0)) return 0;
  if (!plan_.splits) plan_.splits.emplace(LightSplit(0.0, plan_.view.importance));
  const SelectiveSettings& own = *plan_.selective;
  RenderSettings settings = plan_.settings;
  constexpr int kReplicates = 4;
  if (!stays(own)) {
    settings.replicates = kReplicates;
    settings.seed = hash_numbers(settings.seed, 0x9e9107ULL);
    settings.aovs.clear();
  }
  const auto replicates = static_cast<std::uint64_t>(settings.replicates);
  samples_ =
      std::max<std::uint64_t>(1, (own.pilot_samples + replicates - 1) / replicates) * replicates;
  for (const std::string& name : kSurfaceLayers) {
    if (std::find(settings.aovs.begin(), settings.aovs.end(), name) == settings.aovs.end()) {
      settings.aovs.push_back(name);
    }
  }
  // So little that what is drawn by lot adds no noise that could be seen.
  constexpr double kGrain = 0.25;
  grain_ = kGrain * plan_.brightness;
  if (recruits_ != nullptr) {
    populations_ = make_populations(plan_);
    recruits_->expect_unknown(static_cast<double>(samples_));
  }
  omc_ = plan_.make_omc(settings, {settings.min_depth, settings.max_depth}, &*plan_.splits, this);
  film_ = std::make_unique<Film>(settings.resolution, settings.crop,
                                 make_filter(plan_.scene.film().filter), settings.replicates,
                                 omc_->layers());
  return omc_->items_in_pass();
}

void RegionPilot::run(std::uint64_t item, Counters& counters) {
  Counters own;
  omc_->run_item(item, 0, samples_, *film_, own);
  rays_ += own.rays;
  counters.rays += own.rays;
}

std::unique_ptr<StrongPathSink> RegionPilot::make(Film& film, Counters& counters) const {
  return std::make_unique<Sink>(*this, film, counters);
}

bool RegionPilot::offers(int replicate) const {
  // If the pilot does not stay, one half is for the map and the other for chains.
  return stays(*plan_.selective) || replicate % 2 == 1;
}

std::vector<int> RegionPilot::seen_by(std::size_t half) const {
  const SelectiveSettings::Pilot pilot = plan_.selective->pilot;
  std::vector<int> seen;
  for (int r = 0; r < film_->replicates(); ++r) {
    const bool is_odd = r % 2 == 1;
    const bool sees = pilot == SelectiveSettings::Pilot::Keep ||
                      (pilot == SelectiveSettings::Pilot::Cross && is_odd == (half == 0)) ||
                      (pilot == SelectiveSettings::Pilot::Discard && !is_odd);
    if (sees) seen.push_back(r);
  }
  return seen;
}

LightSplit RegionPilot::split_of(const RegionChoice& choice) const {
  std::vector<PixelShare> shares;
  shares.reserve(regions_.labels.size());
  for (const std::uint32_t label : regions_.labels) shares.push_back(choice.shares[label]);
  const std::vector<float>& painted = plan_.selective->painted;
  for (std::size_t i = 0; i < painted.size(); ++i) {
    shares[i].target = painted[i];
    shares[i].kept = plan_.selective->exclusive ? std::round(painted[i]) : painted[i];
  }
  return {plan_.settings.crop, std::move(shares), plan_.view.importance};
}

void RegionPilot::end() {
  if (!film_) return;
  rays_per_sample_ =
      static_cast<double>(rays_.load()) / static_cast<double>(samples_ * plan_.pixels());
  // Threads have found them in any order.
  std::sort(found_.begin(), found_.end(),
            [](const FoundLight& a, const FoundLight& b) { return a.key < b.key; });
  const std::vector<PixelIdentity> identities = majority_identities(*film_);
  const Vec2i size(film_->width(), film_->height());
  regions_ = connected_regions(size, identities);
  check_region_rules(plan_.selective->rules, plan_.scene.object_names(),
                     plan_.scene.material_names());
  const auto view = [&](std::vector<int> replicates) {
    return PilotView{plan_,
                     regions_,
                     *film_,
                     *omc_,
                     samples_,
                     rays_per_sample_,
                     found_,
                     std::move(replicates),
                     kTypicalCorrelation};
  };
  const bool halves = plan_.selective->pilot == SelectiveSettings::Pilot::Cross;
  for (std::size_t half = 0; half < (halves ? 2U : 1U); ++half) {
    choices_.push_back(choose_regions(view(seen_by(half))));
  }
  std::vector<int> all(static_cast<std::size_t>(film_->replicates()));
  std::iota(all.begin(), all.end(), 0);
  noise_ = pilot_noise(view(all));
  find_edges(identities);

  const LightSplits before = *plan_.splits;
  if (halves) {
    plan_.splits.emplace(split_of(choices_[0]), split_of(choices_[1]));
  } else {
    plan_.splits.emplace(split_of(choices_[0]));
  }
  plan_.mutations = 0.0;
  bool off = plan_.selective->painted.empty();
  for (const RegionChoice& choice : choices_) {
    off = off && choice.off;
    plan_.mutations += choice.mutations / static_cast<double>(choices_.size());
  }
  plan_.standby = off;
  plan_.mutations = off && !plan_.split_at ? 0.0 : ChainPlan::clamp_mutations(plan_.mutations);
  join(before);
  if (stays(*plan_.selective)) {
    plan_.pilot_kept = samples_;
  } else {
    found_ = {};
    film_.reset();
  }
  omc_.reset();
}

void RegionPilot::join(const LightSplits& before) {
  if (recruits_ == nullptr) return;
  recruits_->divide_anew(before);
  const std::uint64_t camera_samples = samples_ * plan_.pixels();
  plan_.scouted = camera_samples;
  if (stays(*plan_.selective)) {
    recruits_->join(populations_, 0, samples_);
  } else {
    // Half of the samples were for the map.
    recruits_->join_scattered(populations_, static_cast<double>(camera_samples) / 2.0);
  }
}

void RegionPilot::find_edges(const std::vector<PixelIdentity>& identities) {
  const auto layer = [&](const char* name) {
    return film_->develop(film_->layer(name), 1.0 / static_cast<double>(samples_));
  };
  const std::vector<float> triples = layer("depth");
  std::vector<float> depths;
  depths.reserve(triples.size() / 3);
  for (std::size_t i = 0; i < triples.size(); i += 3) depths.push_back(triples[i]);
  edges_ = surface_edges({.size = regions_.size,
                          .identities = identities,
                          .depths = depths,
                          .normals = layer("normal")});
}

void RegionPilot::hand_over(Film& film) {
  if (!film_) return;
  film.add_layers(*film_, std::array<std::string, 1>{"indirect"});
  const int weak = film.layer(kWeakLayer);
  const auto lowest = plan_.split_at ? static_cast<float>(*plan_.split_at * plan_.brightness) : 0.F;
  for (const FoundLight& found : found_) {
    const LightSplit& split = plan_.splits->of(found.replicate);
    // Beside the share below the lowest threshold, which is on the film already.
    const float above = LightSplit::above(found.strength, lowest);
    const float left =
        found.whole ? 1.F : (above - 1.F + split.omc_share(found.strength, found.raster)) / above;
    film.splat(weak, found.replicate, found.raster, found.value * left);
  }
  found_ = {};
  film_.reset();
}

Plane RegionPilot::importance() const {
  Plane plane(regions_.size);
  const auto lowest = plan_.split_at ? static_cast<float>(*plan_.split_at * plan_.brightness) : 0.F;
  const int width = regions_.size.x;
  for (std::size_t i = 0; i < plane.values.size(); ++i) {
    const Vec2i pixel =
        plan_.settings.crop.min + Vec2i(static_cast<int>(i) % width, static_cast<int>(i) / width);
    const Vec2 middle = Vec2(pixel) + Vec2(0.5F, 0.5F);
    const float even = share_of_lowest(plan_.splits->of(0).at(middle), lowest);
    const float odd = share_of_lowest(plan_.splits->of(1).at(middle), lowest);
    plane.values[i] = 0.5F * (even + odd);
  }
  return plane;
}

std::vector<std::pair<std::string, Plane>> RegionPilot::maps() const {
  std::vector<std::pair<std::string, Plane>> planes;
  if (!noise_) return planes;
  const auto wanted = [&](const std::string& name) {
    const auto& aovs = plan_.settings.aovs;
    return std::find(aovs.begin(), aovs.end(), name) != aovs.end();
  };
  if (wanted("noise")) planes.emplace_back("noise", *noise_);
  if (wanted("regions")) {
    std::vector<float> numbers(regions_.count());
    std::iota(numbers.begin(), numbers.end(), 1.F);
    planes.emplace_back("regions", fill_regions(regions_, numbers));
  }
  if (wanted("importance")) planes.emplace_back("importance", importance());
  if (wanted("edges")) planes.emplace_back("edges", *edges_);
  return planes;
}

std::optional<Plane> RegionPilot::antialias_mask() const {
  if (!plan_.selective->antialias || !edges_) return std::nullopt;
  return edges_of_map(*edges_, importance());
}

std::vector<SelectiveReport::Region> RegionPilot::report() const {
  std::vector<SelectiveReport::Region> rows;
  const auto lowest = plan_.split_at ? static_cast<float>(*plan_.split_at * plan_.brightness) : 0.F;
  for (std::size_t r = 0; r < regions_.count(); ++r) {
    const PixelIdentity& shown = regions_.identities[r];
    SelectiveReport::Region row;
    row.number = r + 1;
    row.pixels = regions_.pixel_counts[r];
    if (shown.object > 0) row.object = plan_.scene.object_names()[shown.object - 1];
    if (shown.material > 0) row.material = plan_.scene.material_names()[shown.material - 1];
    for (const RegionChoice& choice : choices_) {
      const auto count = static_cast<double>(choices_.size());
      row.noise += static_cast<double>(choice.noise[r]) / count;
      row.importance += static_cast<double>(share_of_lowest(choice.shares[r], lowest)) / count;
    }
    rows.push_back(std::move(row));
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.pixels > b.pixels; });
  return rows;
}

}  // namespace ajar
