#pragma once

/// Newton steps with pivoting for sliding contacts.

#include <Eigen/Core>

#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// Takes a Newton step that does not fix beforehand which contacts are loaded. Tangential and
/// bilateral rows are linearized, sliding contacts as  ft = -mu fn ut / |ut|,  and eliminated; the
/// normal impulses solve the remaining linear complementarity problem by Lemke's algorithm. The
/// step is exact to rounding where possible sets of loaded contacts differ by 1e-9 of the
/// velocities (a coin on the edge of its table) and a semismooth Newton step cycles. Intervals with
/// two bounds stay at a bound during the step if they are there.
/// @param f       impulses near a solution, replaced by those after the step (rows)
/// @param u       velocities at f (rows)
/// @param pivots  counter, increased by the pivots of Lemke's algorithm
/// @return false if Lemke's algorithm fails; f is then unchanged
/// Source: [Josephy1979].
[[nodiscard]] bool take_pivoting_step(const ScaledContacts& contacts, Eigen::Ref<Eigen::VectorXd> f,
                                      const Eigen::Ref<const Eigen::VectorXd>& u, int& pivots);

}  // namespace thenar::internal
