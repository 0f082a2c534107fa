#include "session/render/memory_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "image/channels.h"
#include "image/relative_error.h"
#include "os/available_memory.h"
#include "scene/scene_memory.h"

namespace ajar {

namespace {

/// A layer as it is developed, gathered with the others for the file, and in the file's bytes.
constexpr std::uint64_t kPictureCopies = 3;

std::uint64_t pixels_of(const Box2i& crop) {
  const Vec2i size = crop.max - crop.min + Vec2i(1, 1);
  return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
}

}  // namespace

std::uint64_t film_bytes(const Box2i& crop, int replicates, const std::vector<LayerSpec>& layers) {
  const std::uint64_t per_sum = pixels_of(crop) * kChannels * sizeof(std::int64_t);
  std::uint64_t bytes = 0;
  for (const LayerSpec& layer : layers) {
    bytes += per_sum * (layer.has_replicates ? static_cast<std::uint64_t>(replicates) : 1U);
  }
  return bytes;
}

std::uint64_t picture_bytes(const Box2i& crop, int replicates, const std::vector<LayerSpec>& layers,
                            const std::vector<std::string>& aovs) {
  std::uint64_t shown = 1;  // their sum
  bool has_boxes = false;
  for (const LayerSpec& layer : layers) {
    has_boxes = has_boxes || !layer.box_of.empty();
    shown += layer.part_of.empty() && layer.instead_of.empty() && layer.box_of.empty() ? 1U : 0U;
  }
  if (has_boxes) ++shown;
  for (const std::string& name : aovs) {
    const AovInfo* const info = find_aov(name);
    if (info == nullptr) continue;
    shown += static_cast<std::uint64_t>(info->pictures == AovInfo::kPerReplicate ? replicates
                                                                                 : info->pictures);
  }
  const std::uint64_t shown_bytes = kChannels * sizeof(float) * kPictureCopies * shown;
  // Errors are estimated before, not meanwhile.
  return pixels_of(crop) * std::max(shown_bytes, error_estimate_bytes(replicates));
}

std::uint64_t scene_bytes(const desc::SceneDesc& scene) {
  const SceneMemory memory = estimate_memory(scene);
  return memory.geometry + memory.images + memory.media;
}

std::string memory_text(const MemoryEstimate& estimate) {
  const std::array<std::pair<const char*, std::uint64_t>, 5> parts = {
      {{"scene", estimate.scene},
       {"film", estimate.film},
       {"writing pictures", estimate.pictures},
       {"method", estimate.method},
       {"denoising", estimate.denoiser}}};
  std::string text;
  for (const auto& [name, bytes] : parts) {
    if (bytes == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, bytes_text(bytes));
  }
  return fmt::format("{} ({})", bytes_text(estimate.total()), text);
}

std::string memory_complaint(const MemoryEstimate& estimate, std::uint64_t available) {
  if (fits_into_memory(estimate.total(), available)) return {};
  return fmt::format(
      "this needs {} of memory, and {} are free here; use a smaller --resolution or --crop, or "
      "fewer --aov",
      memory_text(estimate), bytes_text(available));
}

}  // namespace ajar
