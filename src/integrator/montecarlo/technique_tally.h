#pragma once
#include <cstddef>
#include <vector>

#include "integrator/technique_shares.h"

namespace ajar {

/// Gathers `TechniqueShares` while the samples of a pixel are taken. The techniques that belong to
/// the camera ray's pixel have their variance from the spread of the pixel's samples; light
/// tracing's from its squares alone, because a light path that hits a given pixel is rare.
class TechniqueTally {
 public:
  TechniqueTally();
  void add_camera_contribution(Technique technique, float luminance);
  void add_splat(Technique technique, float luminance);
  void end_sample();
  /// After the last of `samples` samples of one pixel.
  void end_pixel(double samples);
  const TechniqueShares& shares() const { return shares_; }

 private:
  struct Slot {
    float sample = 0.F;
    bool in_sample = false;
    bool in_pixel = false;
    double sum = 0.0;
    double squares = 0.0;
  };
  std::vector<Slot> slots_;
  std::vector<std::size_t> in_sample_;
  std::vector<std::size_t> in_pixel_;
  TechniqueShares shares_;
};

}  // namespace ajar
