#include "transport/kept_directions.h"

#include <cmath>
#include <utility>

namespace ajar {

void KeptDirections::trace(bool follow) {
  traced_ = true;
  follow_ = follow;
  proposal_.clear();
}

void KeptDirections::place(const PathVertex& vertex, float u_lobe, SampleAddress address,
                           SampleSource& source) const {
  const auto index = static_cast<std::size_t>(vertex.edges);
  if (!follow_ || vertex.in_medium || index >= current_.size()) return;
  const Direction& kept = current_[index];
  if (kept.pdf == 0.F) return;
  if (const auto inverse = vertex.bsdf.inverse(vertex.wo, kept.wi, u_lobe, Inverted::Diffuse)) {
    source.replace_pair(
        address, inverse->direction,
        std::log(static_cast<double>(inverse->pdf) / static_cast<double>(kept.pdf)));
  }
}

void KeptDirections::note(const PathVertex& vertex, float u_lobe, const Vec3& wi) {
  if (vertex.in_medium) return;
  if (const auto inverse = vertex.bsdf.inverse(vertex.wo, wi, u_lobe, Inverted::Diffuse)) {
    proposal_.resize(static_cast<std::size_t>(vertex.edges) + 1);
    proposal_.back() = {inverse->pdf, wi};
  }
}

void KeptDirections::accept() {
  if (traced_) std::swap(current_, proposal_);
}

}  // namespace ajar
