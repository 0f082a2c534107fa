#pragma once
#include "core/by_lane.h"

namespace ajar {

/// Weighs techniques by their densities (balance) or by the squares of them (power, β = 2).
/// Source: Veach & Guibas 1995.
enum class Heuristic { Balance, Power };

/// Multiple importance sampling over a technique set with O(1) work per vertex and connection.
///
/// Let z_0 … z_i be a subpath (from either end), F_i the density with which it sampled z_i, R_i the
/// density with which the other end of the path would have, both in the vertex measure. The
/// technique that gives this side only i vertices (boundary between z_{i-1} and z_i) has the
/// coefficient c_i: h(number of samples) if it belongs to the set and neither z_{i-1} nor z_i is
/// specular, else 0. Then the sum over all techniques with a shorter subpath on this side, relative
/// to the technique whose boundary lies behind z_i, is
///     S_i = h(R_i / F_i) (c_i + S_{i-1}),    h(x) = x or x².
/// R_i = r_i g_i needs the direction density r_i of a scattering event at z_{i+1} that is only
/// known once z_{i+2} is. So a vertex stores M_i = h(1/F_i), c_i and V_i such that
///     S_i = h(R_i) (c_i M_i + h(r_{i-1}) V_i),    V_{i+1} = h(g_i / F_{i+1}) (c_i M_i + h(r_{i-1})
///     V_i).
/// At specular vertices F and r are probabilities: the Dirac deltas cancel in each ratio.
///
/// Densities of distances in media differ by the lane of a spectrum that they are sampled by, and a
/// path has one lane, any: h of a technique is the mean over lanes of h of its density by each. F_i
/// is that by all lanes, given z_0 … z_{i-1}; L_i is the density of the subpath by each lane over
/// that by all; R_i is by each lane. Then M_i has the factor h(L_{i-1}), V_i and S_i are by lane,
/// and S_i is relative to h of the subpath by all lanes.
///
/// Source: the recursion of van Antwerpen 2011 and Georgiev 2012 (technical report), with
/// coefficients for arbitrary sets of technique classes; the restriction to the set is ours.
struct MisState {
  ByLane inverse_forward{0.0};  ///< M_i
  ByLane partial{0.0};          ///< V_i
  double coefficient = 0.0;     ///< c_i, as if z_i were not specular

  /// S_i. `reverse`: R_i; `reverse_previous`: r_{i-1}, the density of the direction z_i → z_{i-1}
  /// given the connection.
  ByLane sum(Heuristic heuristic, const ByLane& reverse, double reverse_previous) const;
};

template <typename Number>
Number h(Heuristic heuristic, const Number& x) {
  return heuristic == Heuristic::Power ? x * x : x;
}

/// Quantities of one step from z_i to z_{i+1} in the recursion.
struct MisStep {
  bool specular;             ///< the scattering event at z_i
  double reverse_previous;   ///< r_{i-1}
  ByLane backward_geometry;  ///< g_i: |cos θ_i| / d² (1 if z_i is at infinity) · reverse distance
                             ///< density
  double forward;            ///< F_{i+1}
  ByLane lanes;              ///< L_i
  double class_coefficient;  ///< coefficient of the technique with i + 1 vertices on this side
};

/// State at the endpoint z_0, whose position was sampled with density `forward`; c_0 =
/// `coefficient`.
inline MisState mis_start(Heuristic heuristic, double forward, double coefficient) {
  return {ByLane(h(heuristic, 1.0 / forward)), ByLane(0.0), coefficient};
}

inline MisState mis_extend(Heuristic heuristic, const MisState& at, const MisStep& step) {
  const double coefficient = step.specular ? 0.0 : at.coefficient;
  MisState next;
  next.inverse_forward = h(heuristic, step.lanes / step.forward);
  next.partial =
      h(heuristic, step.backward_geometry / step.forward) *
      (at.inverse_forward * coefficient + at.partial * h(heuristic, step.reverse_previous));
  next.coefficient = step.specular ? 0.0 : step.class_coefficient;
  return next;
}

inline ByLane MisState::sum(Heuristic heuristic, const ByLane& reverse,
                            double reverse_previous) const {
  return h(heuristic, reverse) *
         (inverse_forward * coefficient + partial * h(heuristic, reverse_previous));
}

/// Quantities of the recursion at one vertex, kept where c_i depends on the depth of the whole
/// path: sets that name single techniques. V_i is then only known at a connection, by walking the
/// subpath.
struct MisTrailEntry {
  ByLane inverse_forward{0.0};    ///< M_i
  double coefficient = 0.0;       ///< c_i without h(count of the technique)
  ByLane transfer{0.0};           ///< h(g_{i-1} / F_i)
  double reverse_previous = 0.0;  ///< h(r_{i-2})
  bool after_specular = false;    ///< z_{i-1} is specular
};

/// `at`: the state after `step`.
inline MisTrailEntry mis_trail_entry(Heuristic heuristic, const MisState& at, const MisStep& step) {
  return {at.inverse_forward, at.coefficient, h(heuristic, step.backward_geometry / step.forward),
          h(heuristic, step.reverse_previous), step.specular};
}

/// State at vertex `i` of a recorded subpath, given h(count) of the technique that leaves this side
/// j vertices.
template <typename CountOf>
MisState mis_along(const MisTrailEntry* trail, int i, const CountOf& h_count) {
  MisState state{trail[0].inverse_forward, ByLane(0.0), trail[0].coefficient * h_count(0)};
  for (int j = 1; j <= i; ++j) {
    const MisTrailEntry& entry = trail[j];
    const double coefficient = entry.after_specular ? 0.0 : state.coefficient;
    state.partial = entry.transfer *
                    (state.inverse_forward * coefficient + state.partial * entry.reverse_previous);
    state.inverse_forward = entry.inverse_forward;
    state.coefficient = entry.coefficient * h_count(j);
  }
  return state;
}

}  // namespace ajar
