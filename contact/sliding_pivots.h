#pragma once

/// Contacts that slide, by pivots: which of them bear.

#include <Eigen/Core>

#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// A step of Newton that does not choose beforehand which contacts bear a load. Tangents and
/// bilateral rows are linearised, contacts that slide as  ft = -mu fn ut / |ut|,  and eliminated;
/// the normal impulses then solve the linear complementarity problem that is left, by Lemke's
/// algorithm. This is exact to rounding where sets of contacts that could bear differ by 1e-9 of
/// the velocities (a coin on the edge of its table), where a Newton step that chooses beforehand
/// goes round in circles. Intervals with two ends stay at an end for the step if they are there.
/// @param f       impulses near an answer (rows); in the end those after the step
/// @param u       of f
/// @param pivots  Lemke's are added to it
/// @return false: Lemke's algorithm did not solve the step's problem; f is as it was
/// Source: [Josephy1979].
[[nodiscard]] bool pivot_sliding(const ScaledContacts& contacts, Eigen::Ref<Eigen::VectorXd> f,
                                 const Eigen::Ref<const Eigen::VectorXd>& u, int& pivots);

}  // namespace thenar::internal
