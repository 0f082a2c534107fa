#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/features.h"
#include "image/film.h"
#include "integrator/integrator.h"
#include "os/file_lock.h"
#include "session/job/job_state.h"
#include "session/options/render_spec.h"
#include "session/output/output.h"

namespace ajar {

/// Scene and method of a render: all that decides the bits of a picture but for the number of
/// samples.
struct RenderRecord {
  std::string scene;  ///< absolute path, or builtin:NAME
  std::uint64_t scene_hash = 0;
  std::string integrator;
  std::map<std::string, std::string> parameters;  ///< all that matter, defaults too
  /// Parameters that were not left at their defaults.
  std::map<std::string, std::string> given;
  RenderSettings settings;
  double film_scale = 1.0;
  /// Specification, with the limits and layers that came of it. Checkpoints keep those of its
  /// options that `RenderOption::is_kept` names, which may be changed when they go on.
  RenderSpec spec;
};

/// A part of a picture that was put together from several renders.
struct MergedRun {
  std::uint64_t seed = 0;
  std::uint64_t samples_per_pixel = 0;
};

/// Everything that a render needs to go on with the same bits, and a program to show its picture.
struct Checkpoint {
  std::string version;  ///< version of the program that wrote it
  RenderRecord render;
  Features features;  ///< features of the scene, for filters; may be empty
  std::vector<LayerSpec> layers;
  Development scales;  ///< scales of the film as it is
  JobState job;
  std::string integrator_state;              ///< bytes of `Integrator::save_state`
  Counters preparation;                      ///< counters of the first run
  std::optional<PreparationCut> unprepared;  ///< why it was cut short, if it was
  std::uint64_t preparation_rounds = 0;      ///< completed rounds
  double other_seconds = 0.0;  ///< seconds of building and preparing, all runs together
  std::uint32_t resumptions = 0;
  std::uint32_t interruptions = 0;  ///< by signals; kill −9 leaves no trace
  std::vector<MergedRun> merged;    ///< more than one if seeds were merged; then it cannot go on
  std::vector<std::int64_t> sums;   ///< `Film::raw`
};

/// Writes a checkpoint in one step (`write_file_atomically`): the previous one is kept until the
/// new one is whole. The film's sums are `sums`, not those of `checkpoint`, which need not be
/// copied for this. Raises IoError.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint,
                      std::span<const std::int64_t> sums);

/// Keeps other programs from writing a checkpoint there, until destroyed. Raises IoError if one
/// does.
FileLock lock_checkpoint(const std::string& path);

/// Reads and checks a checkpoint. Raises IoError if it cannot be read, is none, is cut short or
/// damaged, or was written in a format that this program does not know.
Checkpoint read_checkpoint(const std::string& path);

/// A film with the checkpoint's sums, which are moved out of it. For going on, `filter` must be the
/// scene's; to show the picture any will do. Raises IoError if they do not fit.
Film film_of(Checkpoint& checkpoint, const Filter& filter, const std::string& path);

/// Raises UsageError if this program cannot go on with it: it was written by another version (which
/// `force` allows), or several seeds were merged in it.
void check_resumable(const Checkpoint& checkpoint, const std::string& path, bool force);
/// Raises UsageError that names what is different in `now`: integrator, parameters, seed, size, ….
/// The scene's hash is left to `check_scene`.
void check_same_render(const RenderRecord& then, const RenderRecord& now, const std::string& path);
/// Raises UsageError if the scene's hash is not the checkpoint's (which `force` allows: hashes
/// differ, too, if the scene has moved), or the layers that an integrator wants for it are not. The
/// latter hang on a first look at the light, and cannot agree for scenes that look different.
void check_scene(const Checkpoint& checkpoint, std::uint64_t hash,
                 std::span<const LayerSpec> layers, const std::string& path, bool force);

}  // namespace ajar
