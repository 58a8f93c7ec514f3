#pragma once

/// Energy dissipated by impulses of contacts, joint limits and dry friction.

#include <vector>

#include <Eigen/Core>

#include "dynamics/stepping/contact_step.h"

namespace thenar {

/// Selects which impulse work is recorded as a loss.
enum class ImpulseBooking {
  kNet,    // all work, also where it adds energy: for substeps that are extrapolated
  kLosses  // only dissipated energy; energy that impulses add is left out
};

/// Adds the energy that impulses dissipate to the flows kFrictionLoss and kImpactLoss:
///   -P . (u + u+) / 2,   exactly the kinetic energy that they remove.
///
/// By kLosses each pair of bodies, joint limit and dry friction books only dissipation, as its law
/// demands: the normals of contacts that persist separately; all else together, because the normal
/// impulse of a contact that opens or strikes changes its slip. A negative sum is spurious energy:
/// it is not booked, and appears as an error in the energy balance.
/// @param list    contacts with the modes before the impulses; points of a pair are adjacent
/// @param blocks  constraint blocks of the contacts (list)
/// @param f       impulses [N s], [N m s] (rows)
/// @param mean_u  mean of the velocities before and after the impulses [m/s], [rad/s] (rows)
/// @param w       flows, increased [J]
void add_impulse_losses(const std::vector<ActiveContact>& list,
                        const std::vector<ContactBlock>& blocks,
                        const Eigen::Ref<const Eigen::VectorXd>& f,
                        const Eigen::Ref<const Eigen::VectorXd>& mean_u, ImpulseBooking booking,
                        EnergyFlows& w);

}  // namespace thenar
