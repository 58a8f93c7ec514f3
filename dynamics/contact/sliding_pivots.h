#pragma once

/// Contacts that slide, by pivots: which of them bear.

#include <Eigen/Core>

#include "dynamics/contact/scaled_contacts.h"

namespace thenar::internal {

/// Newton's step with who bears left open: tangents and bilateral rows are linearised and
/// eliminated, with contacts that slide by  ft = -mu fn ut / |ut|,  and normal impulses answer the
/// linear complementarity problem that is left, by Lemke's algorithm. It does so to rounding even
/// where sets of contacts that bear differ by next to nothing (a coin that lies on a table and its
/// edge), and a step which follows one side of each change never ends.
/// @param f  impulses near an answer (rows); the new ones
/// @param u  of f
/// @param pivots  more of them
/// @return false: there is no answer, f is as it was
/// Source: [Josephy1979].
[[nodiscard]] bool pivot_sliding(const ScaledContacts& contacts, Eigen::Ref<Eigen::VectorXd> f,
                                 const Eigen::Ref<const Eigen::VectorXd>& u, int& pivots);

}  // namespace thenar::internal
