#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "image/film.h"
#include "image/relative_error.h"
#include "integrator/integrator.h"
#include "post/display.h"
#include "session/output/final_files.h"
#include "session/output/picture_filter.h"

namespace ajar {

/// Description of an integrator's film: all that is needed to show it without the integrator.
struct Development {
  // Scales from sums to pixel values (`Integrator::develop_scale`).
  std::vector<DevelopScale> whole;  ///< per layer, for the sum over replicates
  std::vector<std::vector<DevelopScale>>
      replicates;  ///< per layer and replicate; none if it has none
  std::vector<std::pair<std::string, Plane>> maps;  ///< as in `Findings`
  std::optional<Plane> antialias_mask;
  bool misses_light = false;  ///< as in `Findings`
};
/// After `samples` samples per pixel.
Development development_of(const Film& film, const Integrator& integrator, std::uint64_t samples);
/// For the sum of two films. Maps are of the first: each render looks at its scene by itself.
Development development_of_sum(const Development& a, const Development& b);

/// Develops the film after `samples` samples per pixel: the picture (direct + indirect) times
/// `film_scale`, then every layer of the film, then those of `aovs` that are made here: "samples",
/// "standard-error" (also by scale) and "replicates" (as "replicates.0", "replicates.1", …).
Picture develop(const Film& film, const Integrator& integrator, std::uint64_t samples,
                double film_scale, const std::vector<std::string>& aovs);
Picture develop(const Film& film, const Development& scales, std::uint64_t samples,
                double film_scale, const std::vector<std::string>& aovs);

/// The independent parts of the picture and of its other estimate; none if each would have no
/// sample.
PictureEstimates estimates_of(const Film& film, const Development& scales, std::uint64_t samples,
                              double film_scale);

/// Relative error of the whole picture after `samples` samples per pixel, from the spread of the
/// film's replicates (`estimate_relative_error`); a lower bound, too, if light is missing. Empty
/// with a single replicate and of a black picture.
std::optional<RelativeError> estimate_error(const Film& film, const Integrator& integrator,
                                            std::uint64_t samples);
std::optional<RelativeError> estimate_error(const Film& film, const Development& scales,
                                            std::uint64_t samples);
/// By scale; empty where that is unknown.
std::vector<ErrorAtScale> estimate_errors_by_scale(const Film& film, const Development& scales,
                                                   std::uint64_t samples);

/// The pictures to write when none is named: an EXR and a PNG in the current folder, called like
/// the film's file name or, if it has none, like the scene.
std::vector<std::string> default_outputs(const std::string& film_filename,
                                         const std::string& scene);

/// To be called before rendering. Raises UsageError for an extension that cannot be written and
/// IoError if a file cannot be made in its folder.
void check_picture_paths(const std::vector<std::string>& paths);
/// Raises IoError if no file can be made at `path`. Removes what killed processes left beside it.
void check_writable(const std::string& path);

/// The files of a picture (kind by extension, see `write_image`), and the layer "density" in false
/// colours as NAME.density.png beside each `.png` and `.jpg`. `picture` must outlive them.
std::vector<FinalFile> picture_files(const Picture& picture, const std::vector<std::string>& paths,
                                     const DisplayOptions& display);
std::vector<FinalFile> picture_files(Picture&&, const std::vector<std::string>&,
                                     const DisplayOptions&) = delete;

}  // namespace ajar
