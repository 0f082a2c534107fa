#pragma once
#include <string>

#include "import/pbrt/context.h"
#include "import/pbrt/parameter_list.h"

/// The directives `Film` and `PixelFilter`.
namespace ajar::pbrt {

struct FilmOptions {
  desc::Film film;
  float diagonal = 35.F;  ///< mm
};
/// Everything but the filter. The scale of pbrt-v4's films is that of the sensor, ISO / 100; the
/// exposure time belongs to the camera.
FilmOptions make_film(Context& context, const SourceLocation& where, const std::string& type,
                      const ParameterList& parameters);
desc::Filter make_filter(Context& context, const SourceLocation& where, const std::string& type,
                         const ParameterList& parameters);
/// Filter without a PixelFilter: a box of a pixel in pbrt-v3, a Gauss curve in pbrt-v4.
desc::Filter default_filter(Dialect dialect);

}  // namespace ajar::pbrt
