#pragma once

/// Energy losses by impulses of contacts, joint limits and dry friction.

#include <vector>

#include <Eigen/Core>

#include "dynamics/stepping/contact_step.h"

namespace thenar {

/// Selection of the work of impulses that counts.
enum class ImpulseBooking {
  kNet,    // all of it, also where it makes energy: substeps, which are extrapolated
  kLosses  // what two bodies take; what they make is left out
};

/// Adds the work of impulses to what friction (kRubbed) and approaches (kStruck) took:
///   -P . (u + u+) / 2,   just what the kinetic energy loses by them.
///
/// By kLosses each pair of bodies, joint limit and dry friction is held to its law, by which it
/// takes energy or none: the normals of contacts that went on for themselves, and all else
/// together, as what opens or strikes turns its slip by its normal impulse. What comes out below
/// zero is made of nothing and is not added, so that it is missing in the balance of energy.
/// @param list    with the modes from before these impulses; points of a pair follow each other
/// @param blocks  one for each of `list`
/// @param f, mean_u  impulses, and speeds of rows in the mean of before and after [N s], [m/s]
void add_impulse_losses(const std::vector<ActiveContact>& list,
                        const std::vector<ContactBlock>& blocks,
                        const Eigen::Ref<const Eigen::VectorXd>& f,
                        const Eigen::Ref<const Eigen::VectorXd>& mean_u, ImpulseBooking booking,
                        EnergyFlows& w);

}  // namespace thenar
