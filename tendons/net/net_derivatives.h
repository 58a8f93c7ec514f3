#pragma once

/// Derivatives of a net's equilibrium by implicit differentiation; one-sided where a band is
/// exactly slack or a node just touches.
///
/// With  E*(q, p)  the energy minimised over the floating nodes,  tau = -dE*/dq  and for any input
/// p that does not move bones  dE*/dp = sum_bands of dE_b/dp at fixed length, so that
///   d tau/dp = -d2E*/(dq dp) = -(dL/dq)' dT/dp,
/// with dT/dp the rate of each band's tension at fixed length. All torque derivatives follow from
/// dL/dq, one linear solve per joint coordinate. Derivation: docs/theory/extensor_net.md.

#include <string>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/net/solve_net.h"

namespace thenar {

/// Returns the reason why an equilibrium is not differentiable, or an empty text. It is
/// differentiable if it is balanced, is no saddle, and no band has collapsed two floating nodes
/// together. A node that is collapsed into a fixed exit moves with the exit.
/// @param settled  residual below which a stalled net counts as balanced [N]
[[nodiscard]] std::string why_not_differentiable(const Net& net, const NetEquilibrium& rest,
                                                 double settled = 0);

/// Options of length_by_posture().
struct LengthSlopes {
  int coordinates = 0;  // number of entries of q
  double settled = 0;   // residual below which a stalled net counts as balanced [N]
};

/// Computes dL/dq of all bands while the net stays in equilibrium (bands, coordinates) [m/rad].
/// @throws InputError as in why_not_differentiable().
[[nodiscard]] Eigen::MatrixXd length_by_posture(const Net& net, const Tree<double>& tree,
                                                const TreeState<double>& state,
                                                const NetDrive& drive, const NetEquilibrium& rest,
                                                const LengthSlopes& wanted);

/// Computes d tau/d drive: by each muscle's tension [m/rad], or length [N] (coordinates, muscles).
/// @throws InputError as in why_not_differentiable().
[[nodiscard]] Eigen::MatrixXd torque_by_drive(const Net& net, const Tree<double>& tree,
                                              const TreeState<double>& state, const NetDrive& drive,
                                              const NetEquilibrium& rest, int coordinates);

/// Computes d length/d tension: lengths of the bands that each muscle pulls, by the tension of each
/// [m/N] (muscles, muscles). Symmetric, with no positive eigenvalue, as the second derivative of
/// min_x E + sum t length.
/// @throws InputError as in why_not_differentiable().
[[nodiscard]] Eigen::MatrixXd muscle_compliance(const Net& net, const TreeState<double>& state,
                                                const NetDrive& drive, const NetEquilibrium& rest);

/// Computes d tau/dq while the net stays in equilibrium: minus its joint stiffness, symmetric [N
/// m/rad] (coordinates, coordinates).
/// @throws InputError as in why_not_differentiable().
[[nodiscard]] Eigen::MatrixXd torque_by_posture(const Net& net, const Tree<double>& tree,
                                                const TreeState<double>& state,
                                                const NetDrive& drive, const NetEquilibrium& rest,
                                                int coordinates);

}  // namespace thenar
