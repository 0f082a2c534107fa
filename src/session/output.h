#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "image/film.h"
#include "image/image_file.h"
#include "integrator/integrator.h"

namespace ajar {

/// A developed picture: what goes into files.
struct Picture {
  struct Layer {
    std::string name;  ///< "" for the picture itself
    int channels = 3;
    std::vector<float> pixels;  ///< scene-linear, row by row, crop only, channels interleaved
  };
  Vec2i resolution{0, 0};     ///< of the full image
  Box2i crop;                 ///< inclusive; the pixels that exist
  std::vector<Layer> layers;  ///< the first is the picture
  std::map<std::string, std::string> metadata;
  std::optional<Plane> antialias_mask;  ///< for pictures for the eye (antialias.h)
};

/// What an integrator says of its film: all that is needed to show it without the integrator.
struct Development {
  // What turns sums into pixel values (`Integrator::develop_scale`).
  std::vector<double> whole;                    ///< per layer, for the sum over replicates
  std::vector<std::vector<double>> replicates;  ///< per layer and replicate; none if it has none
  std::vector<std::pair<std::string, Plane>> maps;  ///< `Integrator::maps`
  std::optional<Plane> antialias_mask;
};
/// After `samples` samples per pixel.
Development development_of(const Film& film, const Integrator& integrator, std::uint64_t samples);
/// For the sum of two films. Maps are of the first: each render looks at its scene by itself.
Development development_of_sum(const Development& a, const Development& b);

/// Develops the film after `samples` samples per pixel: the picture (direct + indirect) times
/// `film_scale`, then every layer of the film, then those of `aovs` that are made here: "samples",
/// "standard-error" and "replicates" (as "replicates.0", "replicates.1", …).
Picture develop(const Film& film, const Integrator& integrator, std::uint64_t samples,
                double film_scale, const std::vector<std::string>& aovs);
Picture develop(const Film& film, const Development& scales, std::uint64_t samples,
                double film_scale, const std::vector<std::string>& aovs);

/// Relative error of the whole picture after `samples` samples per pixel, from the spread of the
/// film's replicates (METHODS, section 8); empty with a single replicate.
std::optional<double> estimate_error(const Film& film, const Integrator& integrator,
                                     std::uint64_t samples);
std::optional<double> estimate_error(const Film& film, const Development& scales,
                                     std::uint64_t samples);

/// The pictures to write when none is named: an EXR and a PNG in the current folder, called like
/// the film's file name or, if it has none, like the scene.
std::vector<std::string> default_outputs(const std::string& film_filename,
                                         const std::string& scene);

/// To be called before rendering. Raises UsageError for an extension that cannot be written and
/// IoError if a file cannot be made in its folder.
void check_picture_paths(const std::vector<std::string>& paths);
/// Raises IoError if no file can be made at `path`.
void check_writable(const std::string& path);

/// The picture as files have it.
LayeredImage layered_image(const Picture& picture);

/// What became of one file.
struct WrittenFile {
  std::string path;    ///< where it is now; empty if it is nowhere
  std::string wanted;  ///< where it should be
  std::string error;   ///< why it is not there; empty if it is
};
/// Calls `write` with `path` and, if that raises anything, with `NAME-rescued-N.EXT` in the current
/// folder and then in the one for temporary files, until it succeeds. Raises nothing.
WrittenFile write_or_rescue(const std::string& path,
                            const std::function<void(const std::string& path)>& write);
/// Writes each file (kind by extension, see `write_image`), and the layer "density" in false
/// colours as NAME.density.png beside each `.png` and `.jpg`; one that cannot be written at its
/// place is written as `NAME-rescued.EXT` into the current or the temporary folder. Raises nothing.
std::vector<WrittenFile> write_pictures(const Picture& picture,
                                        const std::vector<std::string>& paths,
                                        const DisplayOptions& display);

}  // namespace ajar
