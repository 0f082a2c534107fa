#pragma once
#include <cstdint>

#include "core/by_lane.h"
#include "path/path.h"
#include "transport/path_sampler.h"

/// Contribution of a path and densities of its techniques, straight from the definitions; linear in
/// the length of the path.
namespace ajar {

/// A spectrum whose size neither floats nor doubles hold: products over many edges.
struct ScaledSpectrum {
  Spectrum spectrum{1.F};     ///< mantissa, of the order of one
  double scale = 1.0;         ///< 0, or within [1/2, 1) after a multiplication
  std::int64_t exponent = 0;  ///< power of two that multiplies it
  ScaledSpectrum& operator*=(const Spectrum& factor);
  ScaledSpectrum& operator*=(double factor);
  bool is_black() const { return scale == 0.0 || spectrum.is_black(); }
  Spectrum value() const { return spectrum * static_cast<float>(whole_scale()); }
  double luminance() const {
    return static_cast<double>(ajar::luminance(spectrum)) * whole_scale();
  }
  /// Natural logarithm of the luminance; −∞ if that is 0.
  double log_luminance() const;

 private:
  double whole_scale() const;
};

/// The measurement contribution f(x) = L_e · Π f_s · Π G · V · W_e, in the product of the vertices'
/// measures (`VertexMeasure`: area, volume, solid angle at infinity, counting measure), visibility
/// and transmittance by `segments`; σ_s of media included. The film's filter is not.
///
/// At specular vertices the delta distribution over the direction toward the light, given the one
/// toward the camera, is left out (see `specular_spread`).
ScaledSpectrum contribution(const Scene& scene, const Path& path);

/// True if light tracing, technique (s, 1), reaches this place on the film.
bool inside_image(const Scene& scene, const Vec2& raster);

// Densities of single vertices, of which those of techniques are products. The vertices before on
// the sampled side are given. All are by the lane that distances in media are sampled by, which is
// one for all vertices of a path, any: the density of several is the mean over lanes of the product
// (`LogDensity`).

/// Jacobian from the density of the direction in which `from` is left (of endpoints at infinity: of
/// the place where the ray crosses a plane) to that of its neighbour `to`, in the measure of that
/// vertex: |cos θ| / d², and the transmission probability between.
ByLane arrival_pdf(const Scene& scene, const Path& path, int from, int to);
/// With which a subpath from the light goes on to vertex `x`; of x_0: with which it starts there.
ByLane light_step_pdf(const Scene& scene, const Path& path, int x);
/// Density of a step from the camera, whose x_k is where it starts. Raster positions are uniform
/// over the full image.
ByLane camera_step_pdf(const Scene& scene, const Path& path, int x);
/// With which x_0 is chosen to light x_1.
double next_event_pdf(const Scene& scene, const Path& path);

/// Density, in the same measure as `contribution`, with which technique (s, t) makes this path in
/// one try by each lane; 0 if it cannot. At specular vertices it has the probability of the event,
/// whichever end they are sampled from: the deltas are left out, as in MIS weights. Roulette is not
/// in it.
ByLane technique_pdf_by_lane(const Scene& scene, const Path& path, Technique technique);
/// By whichever lane.
double technique_pdf(const Scene& scene, const Path& path, Technique technique);

/// Ratio of the delta over the direction toward the light to that over the direction toward the
/// camera, at specular vertex x: (η² |cos θ_s|)_light / (η² |cos θ_s|)_camera, θ_s to the shading
/// normal. f / p of a technique that samples x from the light has it as a factor
/// (docs/methods/notation.md, "Deltas").
double specular_spread(const Scene& scene, const Path& path, int x);

/// f / p: contribution of one try of the technique that makes this path, without MIS weight. Black
/// if the technique cannot.
Spectrum throughput(const Scene& scene, const Path& path, Technique technique);

/// Expected tries of a technique for one camera sample (techniques (s, 1): per pixel of the full
/// image).
double tries(const PathSamplerSettings& settings, Technique technique);

/// MIS weight of a technique over the settings' set, counts and heuristic included. By each lane it
/// counts as a technique of its own.
double mis_weight(const Scene& scene, const PathSamplerSettings& settings, const Path& path,
                  Technique technique);

}  // namespace ajar
