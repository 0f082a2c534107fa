#pragma once
#include <span>
#include <string_view>

#include "import/mitsuba/media.h"

namespace ajar::mitsuba {

/// Sets camera, film and sampler of the scene from `<sensor>`. Raises SceneError for invalid
/// values.
void read_sensor(Context& context, MediumTable& media, const Element& sensor);

/// The camera of a scene without a sensor: it sees all from the side of −z.
void look_at_everything(Context& context);

// In film.cpp: Mitsuba's defaults.
desc::Film default_film(const SourceLocation& where);
void read_film(Context& context, const Element& film);

// In hints.cpp:
void read_sampler(Context& context, const Element& sampler);
/// Integrators that estimate in the same way. Others are left to the renderer's choice.
struct IntegratorName {
  std::string_view theirs;
  std::string_view ours;
};
std::span<const IntegratorName> integrator_names();
/// The one whose settings were read: of one that only watches over another, that other.
const Element& read_integrator(Context& context, const Element& integrator);

}  // namespace ajar::mitsuba
