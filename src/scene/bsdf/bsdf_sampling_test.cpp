#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scene/bsdf/bsdf_catalogue.h"

namespace ajar {
namespace {
using testing::catalogue;
using testing::direction;
using testing::NamedBsdf;
using testing::random_direction;
using testing::random_uniforms;

constexpr int kCosines = 40;  // even: a bin edge lies in the plane of ng
constexpr int kAngles = 32;
constexpr int kDirectionBins = kCosines * kAngles;

int bin_of(const Vec3& w) {
  const int c = std::min(static_cast<int>((w.z + 1.F) * 0.5F * kCosines), kCosines - 1);
  const float phi = std::atan2(w.y, w.x) / (2.F * kPi);
  const float turn = phi < 0.F ? phi + 1.F : phi;
  return c * kAngles + std::min(static_cast<int>(turn * kAngles), kAngles - 1);
}

/// ∫ pdf over each bin by the midpoint rule; one more entry: the probability of "no direction in
/// any bin", i.e. of specular and empty samples.
std::vector<double> expected_probabilities(const Bsdf& bsdf, const Vec3& wo) {
  constexpr int kFine = 10;
  constexpr int kFinePole = 60;  // next to the poles a narrow lobe is narrower still in cos θ
  std::vector<double> p(kDirectionBins + 1, 0.0);
  for (int c = 0; c < kCosines; ++c) {
    const bool pole = c == 0 || c == kCosines - 1;
    const int rows = pole ? kFinePole : kFine;
    for (int row = 0; row < rows; ++row) {
      const double t = (row + 0.5) / rows;
      // Uniform in cos θ, or at the poles in θ.
      const double step = pole ? t * t : t;
      const double z =
          c == kCosines - 1 ? 1.0 - 2.0 * step / kCosines : -1.0 + 2.0 * (c + step) / kCosines;
      const double cell =
          (pole ? 2.0 * t : 1.0) * 4.0 * kPi / (1.0 * kDirectionBins * rows * kFine);
      const double r = std::sqrt(1.0 - z * z);
      for (int a = 0; a < kAngles * kFine; ++a) {
        const double phi = 2.0 * kPi * (a + 0.5) / (kAngles * kFine);
        const Vec3 wi(static_cast<float>(r * std::cos(phi)), static_cast<float>(r * std::sin(phi)),
                      static_cast<float>(z));
        p[c * kAngles + a / kFine] += bsdf.pdf(wo, wi).value() * cell;
      }
    }
  }
  double sum = 0.0;
  for (int k = 0; k < kDirectionBins; ++k) sum += p[k];
  p[kDirectionBins] = 1.0 - sum;
  return p;
}

/// Standard deviations of the χ² statistic above its mean (Wilson & Hilferty 1931).
double chi_square_sigmas(const std::vector<double>& p, const std::vector<int>& counts, int n) {
  double statistic = 0.0;
  double pooled_expected = 0.0;
  double pooled_count = 0.0;
  int degrees = -1;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double expected = p[k] * n;
    if (expected < 10.0) {
      pooled_expected += std::max(expected, 0.0);
      pooled_count += counts[k];
      continue;
    }
    statistic += (counts[k] - expected) * (counts[k] - expected) / expected;
    ++degrees;
  }
  // Bins too small for the test are tested together.
  if (pooled_expected > 10.0) {
    statistic +=
        (pooled_count - pooled_expected) * (pooled_count - pooled_expected) / pooled_expected;
    ++degrees;
  } else if (pooled_count > 40.0) {
    return 1e9;  // many samples where there should be almost none
  }
  if (degrees < 1) return 0.0;
  const double variance = 2.0 / (9.0 * degrees);
  return (std::cbrt(statistic / degrees) - (1.0 - variance)) / std::sqrt(variance);
}

TEST(Bsdf, SamplesFollowTheirDensity) {
  const Vec3 wos[] = {direction(1.F, 10.F), direction(45.F, 70.F), direction(80.F, 200.F),
                      direction(140.F, 300.F), direction(98.F, 20.F)};
  constexpr int kSamples = 60000;
  Rng rng(1);
  for (const float tilt : {0.F, 25.F}) {
    for (const NamedBsdf& b : catalogue(tilt)) {
      for (const Vec3& wo : wos) {
        std::vector<int> counts(kDirectionBins + 1, 0);
        for (int k = 0; k < kSamples; ++k) {
          const auto s = b.bsdf.sample(wo, random_uniforms(rng), TransportMode::Radiance);
          ++counts[s && !s->pdf.discrete() ? bin_of(s->wi) : kDirectionBins];
        }
        if (!b.bsdf.connectible()) {
          EXPECT_EQ(counts[kDirectionBins], kSamples) << b.name;
          continue;
        }
        EXPECT_LT(chi_square_sigmas(expected_probabilities(b.bsdf, wo), counts, kSamples), 5.0)
            << b.name << ", tilt " << tilt << ", wo " << wo;
      }
    }
  }
}

TEST(Bsdf, NeedleLobesIntegrateTheirSupport) {
  // For lobes too narrow for bins: the mean of 1/pdf over samples in a cap is the cap's solid
  // angle.
  const ConductorFresnel metal(Spectrum(0.2F), Spectrum(3.F));
  Rng rng(2);
  for (const FacetModel model : {FacetModel::Ggx, FacetModel::Beckmann}) {
    for (const float alpha : {0.001F, 0.01F, 0.05F}) {
      for (const float theta : {0.F, 40.F, 75.F}) {
        Bsdf bsdf(Frame(), Vec3(0.F, 0.F, 1.F));
        bsdf.add(Conductor{Microfacets(model, alpha, alpha), metal});
        const Vec3 wo = direction(theta, 30.F);
        const Vec3 mirrored(-wo.x, -wo.y, wo.z);
        const float radius = 0.7F * alpha;  // chord radius of the cap
        double sum = 0.0;
        double squares = 0.0;
        constexpr int kSamples = 40000;
        for (int k = 0; k < kSamples; ++k) {
          const auto s = bsdf.sample(wo, random_uniforms(rng), TransportMode::Radiance);
          if (!s || length(s->wi - mirrored) > radius) continue;
          sum += 1.0 / s->pdf.value();
          squares += 1.0 / (static_cast<double>(s->pdf.value()) * s->pdf.value());
        }
        const double mean = sum / kSamples;
        const double sigma = std::sqrt((squares / kSamples - mean * mean) / kSamples);
        const double cap = kPi * static_cast<double>(radius) * radius;
        EXPECT_NEAR(mean, cap, 5.0 * sigma + 2e-3 * cap)
            << "alpha " << alpha << ", theta " << theta << ", model " << static_cast<int>(model);
      }
    }
  }
}

TEST(Bsdf, SampleAgreesWithEvalAndPdf) {
  Rng rng(3);
  for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
    for (const float tilt : {0.F, 25.F}) {
      for (const NamedBsdf& b : catalogue(tilt)) {
        int scattered = 0;
        for (int k = 0; k < 2000; ++k) {
          const Vec3 wo = random_direction(rng);
          const auto s = b.bsdf.sample(wo, random_uniforms(rng), mode);
          if (!s || s->pdf.discrete()) continue;
          ++scattered;
          const float pdf = b.bsdf.pdf(wo, s->wi).value();
          const float reverse = b.bsdf.pdf(s->wi, wo).value();
          const Spectrum value = b.bsdf.eval(wo, s->wi, mode);
          EXPECT_NEAR(s->pdf.value(), pdf, 4e-3F * pdf + 1e-6F) << b.name << wo << s->wi;
          EXPECT_NEAR(s->reverse_pdf.value(), reverse, 1e-2F * reverse + 1e-5F)
              << b.name << wo << s->wi;
          for (int lane = 0; lane < 3; ++lane) {
            EXPECT_NEAR(s->weight[lane] * pdf, value[lane], 4e-3F * value[lane] + 1e-6F)
                << b.name << wo << s->wi;
          }
        }
        if (b.bsdf.connectible()) {
          EXPECT_GT(scattered, 100) << b.name;
        }
      }
    }
  }
}

TEST(Bsdf, SpecularReverseProbabilityIsThatOfTheReverseEvent) {
  // Sampling from wi must come back to wo with the probability that was promised.
  Rng rng(4);
  for (const NamedBsdf& b : catalogue(0.F)) {
    const Vec3 wo = direction(50.F, 20.F);
    for (int trial = 0; trial < 20; ++trial) {
      const auto s = b.bsdf.sample(wo, random_uniforms(rng), TransportMode::Radiance);
      if (!s || !s->pdf.discrete()) continue;
      int returned = 0;
      constexpr int kSamples = 4000;
      for (int k = 0; k < kSamples; ++k) {
        const auto back = b.bsdf.sample(s->wi, random_uniforms(rng), TransportMode::Radiance);
        returned += back && back->pdf.discrete() && length(back->wi - wo) < 1e-4F;
      }
      const double p = s->reverse_pdf.value();
      EXPECT_NEAR(returned, p * kSamples, 5.0 * std::sqrt(p * (1.0 - p) * kSamples) + 1.0)
          << b.name;
    }
  }
}

}  // namespace
}  // namespace ajar
