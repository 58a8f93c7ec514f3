#pragma once

/// Proof that the support of a wrench set of two caps is at least r in every direction.

#include <optional>

#include "grasp/quality/support_function.h"

namespace thenar::internal {

/// Result of prove_support().
struct SupportProof {
  bool found = false;   // true: h(u) >= r for all |u| = 1 is proven
  int parts = 0;        // number of parts of the sphere that were examined
  double residual = 0;  // smallest eigenvalue of all forms F, for a set of size 1: > 0 if found [1]
  std::optional<WrenchCoordinates> below;  // unit u with h(u) < r, which disproves the claim (6)
};

/// Proves that  h(u) >= r  for every unit u, by sums of products of cones.
///
/// Where h(u) < r, with t = |u| = 1, every cap has  l_i = r t - c_i'u > |z_i|,  z_i = A_i'u. Hence
/// all of  l_i^2 - |z_i|^2,  kappa l_i l_j - z_i' K z_j  with |K| <= kappa, and any multiple of
/// |u|^2 - t^2  are >= 0 there (the last is 0). If a combination of them with weights >= 0,
///   F(u, t) = sum mu_i (|z_i|^2 - l_i^2) + sum (z_i' K_ij z_j - kappa_ij l_i l_j)
///             + nu (|u|^2 - t^2),
/// is a positive definite form, there is no such u. Under kLinf the caps of two contacts have
/// levels s >= 0 and r t - s >= 0 in place of r t, and s is one more unknown of F.
/// maximise_component() finds weights; F, kappa and K are then recomputed and checked including
/// rounding errors. If it finds none, descend_support() starts from the directions that F leaves
/// unproven. Unless it ends below r, the sphere is cut in two across the direction in which the
/// unproven u are farthest apart; products of  +-(w'u - b t) >= 0  with all others help in each
/// half. A family of nearest directions, as for any symmetric pinch, costs no more than a single
/// one.
/// @param r  level below the minimum of h(u) by a margin, as there is no proof at the minimum [1]
/// @param max_parts  maximum number of parts of the sphere
/// @return not found if there are more than kMaxProofCaps different caps
/// Source: [BurerAnstreicher2013] for products of second-order cones.
[[nodiscard]] SupportProof prove_support(const SupportFunction& support, double r, int max_parts);

inline constexpr int kMaxProofCaps = 2;  // different caps that a proof can treat

}  // namespace thenar::internal
