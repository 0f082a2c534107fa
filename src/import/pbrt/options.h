#pragma once
#include <optional>
#include <string>

#include "import/pbrt/context.h"
#include "import/pbrt/parameter_list.h"

/// The directives before WorldBegin: camera, sampler, integrator; film.h has the others.
namespace ajar::pbrt {

/// A camera, and for a "realistic" one the focal length of the perspective that stands in for it;
/// its field of view follows from the film.
struct CameraOptions {
  desc::Camera camera;
  std::optional<double> focal_length;  ///< mm
  float exposure_time = 1.F;           ///< pbrt-v4: pictures are as bright as it is long
};
/// Raises SceneError for unknown types and parameters that make no camera.
CameraOptions make_camera(Context& context, const SourceLocation& where, const std::string& type,
                          const ParameterList& parameters, const Mat4& ctm);

void apply_sampler(Context& context, const SourceLocation& where, const std::string& type,
                   const ParameterList& parameters);
/// Sets pbrt's behaviour where no integrator is named.
void apply_no_integrator(Context& context);
/// Warns if the integrator of this type, "" for that of a file without one, leaves out the media
/// that the scene has.
void check_media(Context& context, const SourceLocation& where, const std::string& type);
void apply_integrator(Context& context, const SourceLocation& where, const std::string& type,
                      const ParameterList& parameters);

}  // namespace ajar::pbrt
