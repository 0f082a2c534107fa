#include "transport/kept_directions.h"

#include <algorithm>
#include <cmath>

namespace ajar {

void KeptDirections::trace(bool follow) {
  traced_ = true;
  follow_ = follow;
  std::fill(proposal_.begin(), proposal_.end(), Direction{});
}

void KeptDirections::place(const PathVertex& vertex, float u_lobe, SampleAddress address,
                           SampleSource& source) const {
  if (!follow_ || vertex.in_medium) return;
  const Direction& kept = current_[size(vertex.edges)];
  if (kept.pdf == 0.F) return;
  if (const auto inverse = vertex.bsdf.inverse(vertex.wo, kept.wi, u_lobe)) {
    source.replace_pair(
        address, inverse->direction,
        std::log(static_cast<double>(inverse->pdf) / static_cast<double>(kept.pdf)));
  }
}

void KeptDirections::note(const PathVertex& vertex, float u_lobe, const Vec3& wi) {
  if (vertex.in_medium) return;
  const std::optional<LobeInverse> inverse = vertex.bsdf.inverse(vertex.wo, wi, u_lobe);
  if (inverse) proposal_[size(vertex.edges)] = {inverse->pdf, wi};
}

void KeptDirections::accept(bool moved) {
  if (traced_) {
    std::swap(current_, proposal_);
  } else if (moved) {
    std::fill(current_.begin(), current_.end(), Direction{});
  }
}

}  // namespace ajar
