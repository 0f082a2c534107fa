#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/vector.h"
#include "image/film.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Memory that a render will need beside what the program has already, bytes. Known before it is
/// asked for: a machine that promises more than it has ends programs without a word.
struct MemoryEstimate {
  std::uint64_t scene = 0;     ///< memory of building it; 0 once it is built
  std::uint64_t film = 0;      ///< layers × replicates
  std::uint64_t pictures = 0;  ///< while they are written
  std::uint64_t method = 0;    ///< memory of the integrator (`Integrator::memory_bytes`)
  std::uint64_t denoiser = 0;  ///< while it filters a picture
  std::uint64_t total() const { return scene + film + pictures + method + denoiser; }
};

/// Memory of a film with these layers, bytes (8 per channel and replicate).
std::uint64_t film_bytes(const Box2i& crop, int replicates, const std::vector<LayerSpec>& layers);
/// Memory for writing a picture of such a film: its layers in float, row by row for the file and in
/// the file's format; with the layers of `aovs` that are made of others.
std::uint64_t picture_bytes(const Box2i& crop, int replicates, const std::vector<LayerSpec>& layers,
                            const std::vector<std::string>& aovs);
/// Images and geometry together.
std::uint64_t scene_bytes(const desc::SceneDesc& scene);

/// "3.2 GB (scene 0.1 GB, film 3.0 GB, …)", parts that are nothing left out.
std::string memory_text(const MemoryEstimate& estimate);

/// Error if that is more than there is, in one sentence; empty if it is not, or if `available` is
/// 0, unknown.
std::string memory_complaint(const MemoryEstimate& estimate, std::uint64_t available);

}  // namespace ajar
