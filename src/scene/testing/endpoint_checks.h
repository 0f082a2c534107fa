#pragma once
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "core/frame.h"
#include "core/random.h"
#include "scene/endpoint.h"
#include "scene/testing/statistics.h"

/// Invariants of every endpoint, light or camera.
namespace ajar::testing {

inline Vec2 next_pair(Rng& rng) {
  const float x = rng.next();
  return {x, rng.next()};
}
inline EmissionUniforms emission_uniforms(Rng& rng) {
  const float primitive = rng.next();
  const Vec2 position = next_pair(rng);
  return {primitive, position, next_pair(rng)};
}
inline ConnectionUniforms connection_uniforms(Rng& rng) {
  const float primitive = rng.next();
  return {primitive, next_pair(rng)};
}

inline bool near(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

/// Counts how many of `total` cases failed; a few may, where rounding crosses a border.
struct Violations {
  int weight = 0;
  int position = 0;
  int direction = 0;
  int total = 0;
  void expect_at_most(int allowed) const {
    ASSERT_GT(total, 0) << "nothing was emitted";
    EXPECT_LE(weight, allowed) << "of " << total;
    EXPECT_LE(position, allowed) << "of " << total;
    EXPECT_LE(direction, allowed) << "of " << total;
  }
};

/// Weight = emitted · cos / pdfs, and `emission_pdf` repeats the sample's own densities.
inline void check_emission(const Endpoint& endpoint, int samples = 20000, int allowed = 0) {
  Rng rng(7);
  Violations bad;
  for (int i = 0; i < samples; ++i) {
    const auto sample = endpoint.sample_emission(emission_uniforms(rng));
    if (!sample) continue;
    ++bad.total;
    ASSERT_NEAR(length(sample->w), 1.F, 1e-5F);
    ASSERT_TRUE(is_finite(sample->origin));
    ASSERT_TRUE(sample->weight.is_finite());
    ASSERT_GT(sample->position_pdf.value(), 0.F);
    ASSERT_GT(sample->departure_pdf.value(), 0.F);
    const EmissionPdf again = endpoint.emission_pdf(sample->point, sample->w);
    if (!near(again.position.value(), sample->position_pdf.value(), 1e-4)) ++bad.position;
    if (!near(again.departure.value(), sample->departure_pdf.value(), 1e-3)) ++bad.direction;
    const Vec3& ng = sample->point.surface.ng;
    const double cosine = length(ng) > 0.F ? abs_dot(ng, sample->w) : 1.0;
    const Spectrum emitted = endpoint.emitted(sample->point, sample->w);
    for (int lane = 0; lane < 3; ++lane) {
      const double expected = emitted[lane] * cosine /
                              (static_cast<double>(sample->position_pdf.value()) *
                               static_cast<double>(sample->departure_pdf.value()));
      if (!near(expected, sample->weight[lane], 2e-3)) ++bad.weight;
    }
  }
  bad.expect_at_most(allowed);
}

/// Weight = emitted · G / pdf, and `connection_pdf` repeats the sample's own density.
inline void check_connection(const Endpoint& endpoint, const std::vector<Vec3>& references,
                             int samples = 20000, int allowed = 0) {
  Rng rng(8);
  Violations bad;
  for (int i = 0; i < samples; ++i) {
    const Vec3& reference = references[static_cast<std::size_t>(i) % references.size()];
    const auto sample = endpoint.sample_connection(reference, connection_uniforms(rng));
    if (!sample) continue;
    ++bad.total;
    ASSERT_NEAR(length(sample->w), 1.F, 1e-5F);
    ASSERT_TRUE(sample->weight.is_finite());
    ASSERT_FALSE(sample->weight.is_black());
    const float pdf = endpoint.connection_pdf(reference, sample->point).value();
    if (!near(pdf, sample->pdf.value(), 1e-4)) ++bad.position;
    double geometry = 1.0;
    if (endpoint.at_infinity()) {
      ASSERT_LT(length(sample->w - sample->point.toward), 1e-5F);
    } else {
      const Vec3 d = sample->point.surface.p - reference;
      ASSERT_LT(length(sample->w - normalize(d)), 1e-5F);
      ASSERT_NEAR(sample->distance, length(d), 1e-5F * length(d));
      const Vec3& ng = sample->point.surface.ng;
      geometry = (length(ng) > 0.F ? abs_dot(ng, sample->w) : 1.0) / length_squared(d);
    }
    const Spectrum emitted = endpoint.emitted(sample->point, -sample->w);
    for (int lane = 0; lane < 3; ++lane) {
      if (!near(emitted[lane] * geometry / sample->pdf.value(), sample->weight[lane], 2e-3)) {
        ++bad.weight;
      }
    }
  }
  bad.expect_at_most(allowed);
}

/// A chart of (part of) a sphere of directions or a surface: square → point, measure per unit of
/// square, and back.
template <typename Point>
struct Chart {
  std::function<Point(const Vec2&)> point;
  std::function<double(const Vec2&)> measure;
  std::function<Vec2(const Point&)> back;
};

/// Directions within the cone around `axis` of which 1 − cos is `cap`; equal areas.
inline Chart<Vec3> cone_chart(const Vec3& axis, double cap = 2.0) {
  const Frame frame = Frame::around(normalize(axis));
  return {[=](const Vec2& s) {
            const double z = 1.0 - cap * s.x;
            const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
            const double phi = 2.0 * M_PI * s.y;
            return frame.to_world({static_cast<float>(r * std::cos(phi)),
                                   static_cast<float>(r * std::sin(phi)), static_cast<float>(z)});
          },
          [=](const Vec2&) { return 2.0 * M_PI * cap; },
          [=](const Vec3& w) {
            const Vec3 l = frame.to_local(w);
            const double sine = l.x * l.x + l.y * l.y;
            const double away = l.z > 0.F ? sine / (1.0 + l.z) : 1.0 - l.z;
            const double phi = std::atan2(l.y, l.x) / (2.0 * M_PI);
            return Vec2(static_cast<float>(away / cap),
                        static_cast<float>(phi < 0.0 ? phi + 1.0 : phi));
          }};
}

/// Area per unit of square of a chart, by differences.
inline std::function<double(const Vec2&)> numeric_measure(
    const std::function<Vec3(const Vec2&)>& point) {
  return [=](const Vec2& s) {
    constexpr float kStep = 1e-3F;
    const auto slope = [&](const Vec2& step) {
      const Vec2 a(std::max(s.x - step.x, 0.F), std::max(s.y - step.y, 0.F));
      const Vec2 b(std::min(s.x + step.x, 1.F), std::min(s.y + step.y, 1.F));
      return (point(b) - point(a)) / length(Vec3(b.x - a.x, b.y - a.y, 0.F));
    };
    return static_cast<double>(length(cross(slope({kStep, 0.F}), slope({0.F, kStep}))));
  };
}

/// Chi-square of samples against a density over a chart. `sample` is called `samples` times.
template <typename Point>
void check_density(const Chart<Point>& chart, const std::function<std::optional<Point>()>& sample,
                   const std::function<double(const Point&)>& pdf, int samples = 200000,
                   int columns = 16, int rows = 16, int subdivision = 24) {
  const auto cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  std::vector<double> counts(cells);
  std::vector<double> expected(cells);
  const auto cell = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  };
  int outside = 0;
  for (int i = 0; i < samples; ++i) {
    const std::optional<Point> p = sample();
    if (!p) continue;
    const Vec2 s = chart.back(*p);
    if (!(s.x > -1e-4F && s.x < 1.0001F && s.y > -1e-4F && s.y < 1.0001F)) {
      ++outside;
      continue;
    }
    const int x = std::clamp(static_cast<int>(s.x * static_cast<float>(columns)), 0, columns - 1);
    const int y = std::clamp(static_cast<int>(s.y * static_cast<float>(rows)), 0, rows - 1);
    counts[cell(x, y)] += 1.0;
  }
  EXPECT_EQ(outside, 0);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      double sum = 0.0;
      for (int j = 0; j < subdivision; ++j) {
        for (int i = 0; i < subdivision; ++i) {
          const Vec2 s(static_cast<float>((x + (i + 0.5) / subdivision) / columns),
                       static_cast<float>((y + (j + 0.5) / subdivision) / rows));
          sum += pdf(chart.point(s)) * chart.measure(s);
        }
      }
      expected[cell(x, y)] =
          sum * samples / (static_cast<double>(cells) * subdivision * subdivision);
    }
  }
  expect_fits(counts, expected);
}

/// Directions that leave one position of the endpoint, against `emission_pdf().departure`.
inline void check_departures(const Endpoint& endpoint, const Chart<Vec3>& chart, int columns = 16,
                             int rows = 16, int subdivision = 24) {
  Rng rng(9);
  EmissionUniforms fixed = emission_uniforms(rng);
  std::optional<EmissionSample> any;
  for (int i = 0; i < 1000 && !any; ++i) {
    fixed.direction = next_pair(rng);
    any = endpoint.sample_emission(fixed);
  }
  ASSERT_TRUE(any);
  check_density<Vec3>(
      chart,
      [&]() -> std::optional<Vec3> {
        EmissionUniforms u = fixed;
        u.direction = next_pair(rng);
        const auto sample = endpoint.sample_emission(u);
        if (!sample) return std::nullopt;
        return sample->w;
      },
      [&](const Vec3& w) {
        return static_cast<double>(endpoint.emission_pdf(any->point, w).departure.value());
      },
      200000, columns, rows, subdivision);
}

}  // namespace ajar::testing
