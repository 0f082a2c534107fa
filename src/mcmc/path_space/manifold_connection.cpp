#include "mcmc/path_space/manifold_connection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/frame.h"
#include "mcmc/path_space/heuristics.h"
#include "mcmc/path_space/inverse_probability.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/path_space/perturbation_law.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/heuristics.h"

namespace ajar {

namespace {

/// By how much a ray from a light may miss where it is meant to pass: far from the origin, and from
/// where those come that come from beyond the scene, this is more than the tolerance of walks.
double rounding_of_rays(const Scene& scene, const ChainEnd& light, const Vec3& end) {
  constexpr double kRounding = 1e-6;  // rounding of coordinates: 16 times half an ulp
  const auto size = [](const Vec3d& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  };
  const BoundingSphere& sphere = scene.bounding_sphere();
  const double border = size(Vec3d(sphere.center)) + 2.0 * double{sphere.radius};
  const double start = light.at_infinity ? border : std::min(border, size(light.p));
  return kRounding * std::max(start, size(Vec3d(end)));
}

/// A random place around `center` as seen from another, at angles up to the scene's extent from
/// there. In double precision, since from afar floats cannot resolve places in the scene.
Vec3d guess_beside(const Vec3d& center, const Vec3d& from, const BoundingSphere& sphere,
                   const Vec2& u) {
  const double away = (from - Vec3d(sphere.center)).length();
  const double radius = sphere.radius;
  const double largest = away > radius ? 2.0 * std::asin(radius / away) : std::numbers::pi;
  const PerturbationLaw law{PathSpaceHeuristics::kSmallestGuess * largest / std::numbers::pi,
                            largest};
  const double angle = law.size(static_cast<double>(u.x));
  const double around = 2.0 * std::numbers::pi * static_cast<double>(u.y);
  const Vec3d toward = center - from;
  const Vec3 across = Frame::around(Vec3(toward.normalized()))
                          .to_world({static_cast<float>(std::cos(around)),
                                     static_cast<float>(std::sin(around)), 0.F});
  return from + toward * std::cos(angle) + Vec3d(across) * (toward.length() * std::sin(angle));
}

/// A clear chain, and its distance to others between the same ends.
class KnownChain {
 public:
  KnownChain(const Scene& scene, const ChainEnd& light, std::span<const InnerVertex> chain,
             const Vec3& end)
      : chain_(chain) {
    SpecularChain linear(scene);
    if (!linear.set(light, chain, {Vec3d(end), Vec3d(0.0), false})) return;
    is_mirrored_ = linear.is_mirrored();
    double length = light.at_infinity ? 0.0 : way_in(scene, light, Vec3d(chain.front().p()));
    shortest_ = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Vec3& next = i + 1 < chain.size() ? chain[i + 1].p() : end;
      const double edge = (Vec3d(next) - Vec3d(chain[i].p())).length();
      length += edge;
      shortest_ = std::min(shortest_, edge);
    }
    uncertainty_ = (PathHeuristics::kWalkTolerance * length + rounding_of_rays(scene, light, end)) *
                   linear.largest_move();
  }

  bool is_clear(double share) const {
    return shortest_ > 0.0 && 2.0 * uncertainty_ <= share * shortest_;
  }
  /// True if a walk arrived at it.
  bool is(const ManifoldWalk& walk) const {
    const auto other = walk.vertices();
    if (other.size() != chain_.size() || walk.is_mirrored() != is_mirrored_) return false;
    const double reach =
        std::max(PathSpaceHeuristics::kSeparationTolerance * shortest_, 2.0 * uncertainty_);
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      if (other[i].event != chain_[i].event ||
          (Vec3d(other[i].p()) - Vec3d(chain_[i].p())).length() > reach) {
        return false;
      }
    }
    return true;
  }

 private:
  std::span<const InnerVertex> chain_;
  bool is_mirrored_ = false;
  double shortest_ = 0.0;  ///< edge after the first
  double uncertainty_ = 0.0;
};

}  // namespace

Vec3d ManifoldConnection::choose_place(const Ends& ends, SampleSource& source) const {
  const auto number = [&](Slot slot) { return source.get({Stream::Light, 0, slot}); };
  const Vec2 u = source.get_pair({Stream::Light, 0, kEmissionDirection});
  Vec3 center = ends.seen.p();
  if (number(Slot::LightChoice) < PathSpaceHeuristics::kGuessesByPhotons) {
    const auto first = photons_.near(ends.light, center, number(Slot::LightPrimitive));
    center = first.value_or(center);
  }
  const BoundingSphere& sphere = scene_.bounding_sphere();
  if (!ends.light.at_infinity()) {
    return guess_beside(Vec3d(center), Vec3d(ends.point.surface.p), sphere, u);
  }
  const double diameter = 2.0 * double{sphere.radius};
  const PerturbationLaw law{PathSpaceHeuristics::kSmallestGuess * diameter / std::numbers::pi,
                            diameter};
  const Vec2 beside = law.in_plane(u);
  return Vec3d(center + Frame::around(ends.point.toward).to_world({beside.x, beside.y, 0.F}));
}

bool ManifoldConnection::find(const Ends& ends, std::uint64_t key) {
  BootstrapSource source(key, 0);
  const ChainStart start = chain_start(ends.light, ends.point);
  if (!walk_.set_off(start, choose_place(ends, source), ends.most, source)) return false;
  auto guess = walk_.vertices();
  if (ends.seen.in_medium) {
    // The connection may be between any two of them.
    const float u = source.get({Stream::Light, 0, Slot::Roulette});
    guess = guess.first(1 + static_cast<std::size_t>(u * static_cast<float>(guess.size())));
  }
  guessed_.assign(guess.begin(), guess.end());
  return walk_.walk(start, guessed_, ends.seen.p());
}

double ManifoldConnection::inverse_chance(const Ends& ends, std::span<const InnerVertex> chain,
                                          double discount, std::uint64_t key) {
  const KnownChain known(scene_, chain_start(ends.light, ends.point).end, chain, ends.seen.p());
  const auto finds_it = [&](std::uint64_t guess) {
    return find(ends, hash_numbers(key, guess)) && known.is(walk_);
  };
  return inverse_probability(finds_it, discount,
                             {PathSpaceHeuristics::kSureGuesses, PathSpaceHeuristics::kGuessesGoOn},
                             hash_numbers(key, 0));
}

bool ManifoldConnection::is_clear(const Scene& scene, const Path& path, int seen) {
  return KnownChain(scene, chain_end(path, 0), chain_from_light(path, 0, seen),
                    path.vertex(seen).p())
      .is_clear(path.light->discrete_position() ? PathSpaceHeuristics::kClearOfPoints
                                                : PathSpaceHeuristics::kSeparationTolerance);
}

}  // namespace ajar
