#include "mcmc/path_space/constraint_perturbation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mcmc/path_space/chain_density.h"
#include "mcmc/path_space/heuristics.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/log_density.h"
#include "path/measure.h"

namespace ajar {

namespace {

/// Offset normals of a chain among those of all; none if it is specular.
std::span<const OffsetNormal> offsets_of(std::span<const InnerVertex> chain,
                                         std::span<const OffsetNormal> all) {
  const bool is_specular =
      std::ranges::all_of(chain, [](const InnerVertex& vertex) { return vertex.event.specular(); });
  return is_specular ? std::span<const OffsetNormal>() : all.first(chain.size());
}

bool is_rough(const Path& path, int vertex) { return !path.vertex(vertex).event.specular(); }

}  // namespace

ConstraintPerturbation::ConstraintPerturbation(const Scene& scene, const RasterArea& area)
    : scene_(scene),
      area_(area),
      raster_(raster_law(scene.camera().resolution())),
      growing_(scene, area),
      walk_(scene),
      old_chain_(scene) {}

bool ConstraintPerturbation::suitable(const Path& path) const {
  const auto span = span_of(path);
  return span && std::ranges::all_of(chain_from_light(path, span->fixed, span->moved), &can_hold);
}

std::optional<OffsetNormal> ConstraintPerturbation::offset_of(const Path& path, int vertex) const {
  return offset_normal(path.vertex(vertex), Vec3d(path.toward_camera(scene_, vertex)),
                       Vec3d(path.toward_light(scene_, vertex)));
}

std::optional<PerturbationLaw> ConstraintPerturbation::offset_law(const Path& path,
                                                                  int vertex) const {
  const Vec3 a = path.toward_camera(scene_, vertex);
  const Vec3 b = path.toward_light(scene_, vertex);
  const InnerVertex& at = path.vertex(vertex);
  const double area = offset_change(at, Vec3d(a), Vec3d(b)) / at.pdf(a, b);
  if (!(area > 0.0) || !std::isfinite(area)) return std::nullopt;
  const double radius = std::sqrt(area / std::numbers::pi);
  return PerturbationLaw{PathSpaceHeuristics::kSmallestOffsetMove * radius,
                         PathSpaceHeuristics::kLargestOffsetMove * radius};
}

bool ConstraintPerturbation::move_offsets(const Path& x, const Span& span, SampleSource& source) {
  old_offsets_.clear();
  new_offsets_.clear();
  for (int vertex = span.fixed + 1; vertex < x.depth(); ++vertex) {
    OffsetNormal& old = old_offsets_.emplace_back();
    OffsetNormal& moved = new_offsets_.emplace_back();
    if (vertex == span.moved || !is_rough(x, vertex)) continue;
    const auto offset = offset_of(x, vertex);
    const auto law = offset_law(x, vertex);
    if (!offset || !law) return false;
    old = *offset;
    const Vec2 by = law->in_plane(source.get_pair({Stream::Camera, vertex, Slot::BsdfDirectionX}));
    moved = {old.x + double{by.x}, old.y + double{by.y}};
  }
  return true;
}

bool ConstraintPerturbation::look(const Path& x, int moved, const Vec2& raster,
                                  SampleSource& source) {
  GrowingEnd& camera = growing_.camera;
  if (!growing_.look(raster)) return false;
  for (int vertex = x.depth() - 1; vertex > moved; --vertex) {
    if (!camera.arrive(source)) return false;
    const ScatterEvent& event = x.vertex(vertex).event;
    if (event.specular()) {
      if (!camera.follow(event)) return false;
      continue;
    }
    const InnerVertex& at = camera.vertices.back();
    if (at.in_medium || !at.connectible()) return false;
    const std::size_t from_end = static_cast<std::size_t>(x.depth() - vertex);
    const auto w = turn(at, event.transmission, new_offsets_[new_offsets_.size() - from_end],
                        Vec3d(camera.back()));
    if (!w) return false;
    camera.go(Vec3(*w));
  }
  return camera.arrive(source) && camera.vertices.back().connectible();
}

bool ConstraintPerturbation::leads_back(const Path& x, const Span& span, const InnerVertex& target,
                                        double uncertainty) {
  const auto old = chain_from_light(x, span.fixed, span.moved);
  const auto back = walk_.vertices();
  double step = 0.0;
  double shortest = std::numeric_limits<double>::infinity();
  double missed = 0.0;
  for (std::size_t i = 0; i < old.size(); ++i) {
    const bool is_last = i + 1 == old.size();
    const Vec3d p(old[i].p());
    const Vec3d q(chain_[i].p());
    const Vec3d after_p(x.position(span.fixed + static_cast<int>(i) + 2));
    const Vec3d after_q(is_last ? target.p() : chain_[i + 1].p());
    step = std::max(step, (q - p).length());
    missed = std::max(missed, (Vec3d(back[i].p()) - p).length());
    shortest = std::min({shortest, (after_p - p).length(), (after_q - q).length()});
  }
  const double room = std::min(step, shortest);
  const double vague = 2.0 * uncertainty;
  if (!(vague <= PathSpaceHeuristics::kConstraintTolerance * room) ||
      !(missed <= PathSpaceHeuristics::kReturnTolerance * room + vague)) {
    return false;
  }
  // At the border of a caustic the other chain is as near as one likes.
  return old_chain_.set(chain_end(x, span.fixed), old, chain_end(x, span.moved),
                        offsets_of(old, old_offsets_)) &&
         old_chain_.is_mirrored() == walk_.is_mirrored();
}

bool ConstraintPerturbation::walk(const Path& x, const Span& span, const InnerVertex& target) {
  const auto old = chain_from_light(x, span.fixed, span.moved);
  chain_.clear();
  if (old.empty()) return true;
  const ChainStart start = chain_start(x, span.fixed);
  walk_end_ = WalkEnd::Lost;
  if (!walk_.walk(start, old, target.p(), offsets_of(old, new_offsets_))) return false;
  chain_.assign(walk_.vertices().begin(), walk_.vertices().end());
  const double uncertainty = walk_.uncertainty();
  const bool back =
      walk_.walk(start, chain_, x.position(span.moved), offsets_of(old, old_offsets_)) &&
      leads_back(x, span, target, std::max(uncertainty, walk_.uncertainty()));
  walk_end_ = back ? WalkEnd::None : WalkEnd::OneWay;
  return back;
}

std::optional<Kept> ConstraintPerturbation::propose(const Path& x, std::uint64_t key, Path& y) {
  const Span span = *span_of(x);
  const Kept kept{span.fixed + 1, 1};
  walk_end_ = WalkEnd::None;
  BootstrapSource source(key, 0);
  const Vec2 raster =
      x.raster + raster_.in_plane(source.get_pair({Stream::Camera, 0, kEmissionDirection}));
  if (!area_.contains(raster) || !move_offsets(x, span, source)) return std::nullopt;
  growing_.begin(x, kept.light, kept.camera);
  const bool made = look(x, span.moved, raster, source) &&
                    walk(x, span, growing_.camera.vertices.back()) &&
                    growing_.finish_through(chain_, y);
  rays_ = growing_.ray_counts();
  rays_.add_rays(walk_.ray_counts());
  return made ? std::optional(kept) : std::nullopt;
}

double ConstraintPerturbation::log_offset_density(const Path& x, const Path& y, int vertex) const {
  const auto law = offset_law(x, vertex);
  const auto from = offset_of(x, vertex);
  const auto to = offset_of(y, vertex);
  if (!law || !from || !to) return kNever;
  const double distance = std::hypot(to->x - from->x, to->y - from->y);
  if (!law->reaches(distance)) return kNever;
  return law->log_density_in_plane(distance) +
         std::log(offset_change(y.vertex(vertex), Vec3d(y.toward_camera(scene_, vertex)),
                                Vec3d(y.toward_light(scene_, vertex))));
}

double ConstraintPerturbation::log_walk_density(const Path& path, const Span& span) const {
  if (span.moved == span.fixed + 1) return 0.0;
  Offsets offsets;
  for (int x = span.moved - 1; x > span.fixed; --x) {
    const auto offset = is_rough(path, x) ? offset_of(path, x) : OffsetNormal();
    if (!offset) return kNever;
    offsets.push_back(*offset);
  }
  return log_chain_density(scene_, path, span.fixed, span.moved, offsets);
}

double ConstraintPerturbation::log_density(const Path& x, const Path& y, const Kept& kept) const {
  const int k = y.depth();
  const auto span = span_of(y);
  const auto other = span_of(x);
  if (!span || !other || x.depth() != k || span->fixed != kept.light - 1 ||
      other->fixed != span->fixed || other->moved != span->moved) {
    return kNever;
  }
  LogDensity density;
  density += raster_.log_density_in_plane(static_cast<double>((y.raster - x.raster).length()));
  density *= image_area(scene_.camera().resolution());
  density *= camera_step_pdf(scene_, y, k - 1);
  for (int vertex = k - 1; vertex > span->fixed; --vertex) {
    if (vertex == span->moved) continue;
    if (x.vertex(vertex).event != y.vertex(vertex).event) return kNever;
    if (is_rough(y, vertex)) density += log_offset_density(x, y, vertex);
    if (vertex > span->moved) density *= arrival_pdf(scene_, y, vertex, vertex - 1);
  }
  return density.value() + log_walk_density(y, *span);
}

}  // namespace ajar
