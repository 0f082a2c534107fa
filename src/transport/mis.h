#pragma once

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
/// Source: the recursion of van Antwerpen 2011 and Georgiev 2012 (technical report), with
/// coefficients for arbitrary sets of technique classes; the restriction to the set is ours.
struct MisState {
  double inverse_forward = 0.0;  ///< M_i
  double partial = 0.0;          ///< V_i
  double coefficient = 0.0;      ///< c_i, as if z_i were not specular

  /// S_i. `reverse`: R_i; `reverse_previous`: r_{i-1}, the density of the direction z_i → z_{i-1}
  /// given the connection.
  double sum(Heuristic heuristic, double reverse, double reverse_previous) const;
};

inline double h(Heuristic heuristic, double x) { return heuristic == Heuristic::Power ? x * x : x; }

/// What the recursion needs to know of one step from z_i to z_{i+1}.
struct MisStep {
  bool specular;             ///< the scattering event at z_i
  double reverse_previous;   ///< r_{i-1}
  double backward_geometry;  ///< g_i: |cos θ_i| / d² (1 if z_i is at infinity) · reverse distance
                             ///< density
  double forward;            ///< F_{i+1}
  double class_coefficient;  ///< of the technique with i + 1 vertices on this side
};

/// State at the endpoint z_0, whose position was sampled with density `forward`; c_0 =
/// `coefficient`.
inline MisState mis_start(Heuristic heuristic, double forward, double coefficient) {
  return {h(heuristic, 1.0 / forward), 0.0, coefficient};
}

inline MisState mis_extend(Heuristic heuristic, const MisState& at, const MisStep& step) {
  const double coefficient = step.specular ? 0.0 : at.coefficient;
  MisState next;
  next.inverse_forward = h(heuristic, 1.0 / step.forward);
  next.partial =
      h(heuristic, step.backward_geometry / step.forward) *
      (coefficient * at.inverse_forward + h(heuristic, step.reverse_previous) * at.partial);
  next.coefficient = step.specular ? 0.0 : step.class_coefficient;
  return next;
}

inline double MisState::sum(Heuristic heuristic, double reverse, double reverse_previous) const {
  return h(heuristic, reverse) *
         (coefficient * inverse_forward + h(heuristic, reverse_previous) * partial);
}

/// What the recursion did at one vertex, kept where c_i depends on the depth of the whole path:
/// sets that name single techniques. V_i is then only known at a connection, by walking the
/// subpath.
struct MisTrailEntry {
  double inverse_forward = 0.0;   ///< M_i
  double coefficient = 0.0;       ///< c_i without h(count of the technique)
  double transfer = 0.0;          ///< h(g_{i-1} / F_i)
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
  MisState state{trail[0].inverse_forward, 0.0, trail[0].coefficient * h_count(0)};
  for (int j = 1; j <= i; ++j) {
    const MisTrailEntry& entry = trail[j];
    const double coefficient = entry.after_specular ? 0.0 : state.coefficient;
    state.partial = entry.transfer *
                    (coefficient * state.inverse_forward + entry.reverse_previous * state.partial);
    state.inverse_forward = entry.inverse_forward;
    state.coefficient = entry.coefficient * h_count(j);
  }
  return state;
}

}  // namespace ajar
