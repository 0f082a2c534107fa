#include "mcmc/path_space/lens_subpath_mutation.h"

#include <array>
#include <cmath>

#include "mcmc/path_space/path_form.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/log_density.h"
#include "path/measure.h"

namespace ajar {

namespace {

/// The specular events that light coming from `from` may meet with at a vertex.
class SpecularEvents {
 public:
  SpecularEvents(const InnerVertex& vertex, const Vec3& from) {
    if (vertex.in_medium) return;
    for (std::int8_t lobe = 0; lobe < Bsdf::kMaxLobes; ++lobe) {
      for (const bool transmission : {false, true}) {
        const ScatterEvent event{lobe, transmission};
        const auto sample = vertex.bsdf.specular(from, event, TransportMode::Radiance);
        if (sample) add(event, static_cast<double>(sample->pdf.value()));
      }
    }
    // One that cannot be joined must be gone on from.
    share_ = vertex.connectible() ? 1.0 : 1.0 / total_;
  }

  /// Probability of the event by which the subpath continues.
  double probability(const ScatterEvent& event) const {
    for (std::size_t i = 0; i < count_; ++i) {
      if (events_[i] == event) return probabilities_[i] * share_;
    }
    return 0.0;
  }
  double probability_to_stop() const { return share_ == 1.0 ? 1.0 - total_ : 0.0; }
  /// Empty: it stops.
  std::optional<ScatterEvent> choose(double u) const {
    for (std::size_t i = 0; i < count_; ++i) {
      u -= probabilities_[i] * share_;
      if (u < 0.0) return events_[i];
    }
    return std::nullopt;
  }

 private:
  void add(const ScatterEvent& event, double probability) {
    events_[count_] = event;
    probabilities_[count_] = probability;
    total_ += probability;
    ++count_;
  }

  std::array<ScatterEvent, 2 * Bsdf::kMaxLobes> events_;
  std::array<double, 2 * Bsdf::kMaxLobes> probabilities_{};
  std::size_t count_ = 0;
  double total_ = 0.0;
  double share_ = 1.0;
};

}  // namespace

LensSubpathMutation::LensSubpathMutation(const Scene& scene, const RasterArea& area, int min_depth,
                                         int max_depth)
    : scene_(scene),
      area_(area),
      min_depth_(min_depth),
      max_depth_(max_depth),
      growing_(scene, area) {}

bool LensSubpathMutation::suitable(const Path& path) const {
  const int rough = first_rough_from_camera(path);
  return rough > 0 && can_join(path, rough);
}

std::optional<Kept> LensSubpathMutation::propose(const Path& x, std::uint64_t key, Path& y) {
  const Kept kept{first_rough_from_camera(x), 0};
  BootstrapSource source(key, 0);
  growing_.begin(x, kept.light, kept.camera);
  growing_.choose_lens(source);
  GrowingEnd& camera = growing_.camera;
  const bool made = [&] {
    if (!growing_.look(area_.raster(source.get_pair({Stream::Camera, 0, kEmissionDirection})))) {
      return false;
    }
    while (camera.arrive(source)) {
      const auto u =
          static_cast<double>(source.get({Stream::Camera, camera.size() - 1, Slot::BsdfLobe}));
      const auto event = SpecularEvents(camera.vertices.back(), camera.back()).choose(u);
      if (!event) {
        const int depth = kept.light + camera.size() - 1;
        return depth >= min_depth_ && growing_.finish(y);
      }
      if (kept.light + camera.size() > max_depth_ || !camera.follow(*event)) return false;
    }
    return false;
  }();
  rays_ = growing_.ray_counts();
  return made ? std::optional(kept) : std::nullopt;
}

double LensSubpathMutation::log_density(const Path& /*x*/, const Path& y, const Kept& kept) const {
  const int k = y.depth();
  const int rough = kept.light;
  if (first_rough_from_camera(y) != rough || !can_join(y, rough)) return kNever;
  LogDensity density;
  density *= camera_step_pdf(scene_, y, k);
  density *= camera_step_pdf(scene_, y, k - 1);
  density *= image_area(scene_.camera().resolution()) / area_.area();
  for (int vertex = k - 1; vertex >= rough; --vertex) {
    const SpecularEvents events(y.vertex(vertex), y.toward_camera(scene_, vertex));
    if (vertex == rough) return density.value() + std::log(events.probability_to_stop());
    density *= events.probability(y.vertex(vertex).event);
    density *= arrival_pdf(scene_, y, vertex, vertex - 1);
  }
  return kNever;
}

}  // namespace ajar
