#include "integrator/montecarlo/technique_tally.h"

#include <algorithm>

namespace ajar {

TechniqueTally::TechniqueTally() : slots_(TechniqueShares::kSlots) {
  in_sample_.reserve(TechniqueShares::kSlots);
  in_pixel_.reserve(TechniqueShares::kSlots);
}

void TechniqueTally::add_camera_contribution(Technique technique, float luminance) {
  const std::size_t index = TechniqueShares::slot(technique);
  Slot& slot = slots_[index];
  slot.sample += luminance;
  if (slot.in_sample) return;
  slot.in_sample = true;
  in_sample_.push_back(index);
}

void TechniqueTally::add_splat(Technique technique, float luminance) {
  const auto value = static_cast<double>(luminance);
  shares_.add(TechniqueShares::slot(technique), value, value * value);
}

void TechniqueTally::end_sample() {
  for (const std::size_t index : in_sample_) {
    Slot& slot = slots_[index];
    const auto value = static_cast<double>(slot.sample);
    slot.sum += value;
    slot.squares += value * value;
    slot.sample = 0.F;
    slot.in_sample = false;
    if (!slot.in_pixel) in_pixel_.push_back(index);
    slot.in_pixel = true;
  }
  in_sample_.clear();
}

void TechniqueTally::end_pixel(double samples) {
  for (const std::size_t index : in_pixel_) {
    Slot& slot = slots_[index];
    // A single sample has no spread: its square stands in.
    const double spread =
        samples > 1.0 ? (slot.squares - slot.sum * slot.sum / samples) * samples / (samples - 1.0)
                      : slot.squares;
    shares_.add(index, slot.sum, std::max(0.0, spread));
    slot = {};
  }
  in_pixel_.clear();
}

}  // namespace ajar
