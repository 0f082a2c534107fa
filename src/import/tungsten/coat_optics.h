#pragma once

/// Mean optics of a smooth dielectric layer over all directions of incidence, each weighted by its
/// cosine. Replacements for layers that our materials do not have reflect as much light in total by
/// these means.
namespace ajar::tungsten {

/// Share that is reflected at the layer, seen from outside, `ior` > 0 being the layer's index of
/// refraction relative to outside.
double mean_reflectance(double ior);

/// Reflectance from within the layer.
double mean_internal_reflectance(double ior);

/// Share that is left on one way through a layer of optical thickness `tau`.
double mean_transmittance(double ior, double tau);

/// Share of the light that arrives which goes in, is reflected by a smooth base without loss, and
/// comes out the same way.
double mean_round_trip(double ior, double tau);

/// The index ≥ 1 with this mean reflectance, which must be below 1; at most 100.
double ior_of_mean_reflectance(double reflectance);

}  // namespace ajar::tungsten
