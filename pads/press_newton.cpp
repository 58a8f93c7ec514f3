#include "pads/press_newton.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "pads/node_contacts.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

// Largest residual over the contact forces for which the tangent is reused [1]
constexpr double kTangentReuseShare = 0.2;

/// Solves with the matrix of this iteration: directly by the factor, or by GMRES where contacts
/// couple nodes in ways that the factor leaves out.
VectorXd solve_coupled(const PressIterate& iterate, const VectorXd& b) {
  if (!iterate.gaps.depends_on_neighbours() && !has_sliding_nodes(iterate))
    return iterate.factors.tangent.solve(b);
  return iterate.solve_iteratively(b, [&](const Matrix3Xd& moved) {
    // Subtract the part of the loss that the factor contains.
    Matrix3Xd left_out = contact_force_loss(iterate, moved);
    for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
      left_out.col(k) -= own_stiffness(iterate, k) * moved.col(k);
    return left_out;
  });
}

/// Takes a Newton step.
/// @param u  displacements of all nodes [m] (3, nodes)
/// @return false if the motion of the object to its force cannot be computed
bool take_step(PressIterate& iterate, const Matrix3Xd& u) {
  // Solve for the step; to reach a force the object's motion is one more unknown.
  VectorXd dx = solve_coupled(iterate, -iterate.residual);
  const std::optional<double> motion = iterate.solve_object_motion(
      [&](const Matrix3Xd& moved) { return contact_force_loss(iterate, moved); },
      [&](const VectorXd& b) { return solve_coupled(iterate, b); }, dx);
  if (!motion) return false;
  // Predict the contact forces after the step.
  Matrix3Xd moved = iterate.surface_displacements(dx);
  moved.colwise() -= *motion * iterate.goal.along;
  const VectorXd gap_changes = iterate.gaps.gap_changes(moved);
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k) {
    const SkinNodeContact& c = iterate.contacts[k];
    const double lost = iterate.node_stiffness[k] * gap_changes[k];
    double& normal_force = iterate.state.normal_force[k];
    normal_force = c.normal_force > 0 ? std::max(0.0, c.normal_force - lost) : 0;
    iterate.state.friction_force.col(k).setZero();
    if (normal_force > 0)
      iterate.state.friction_force.col(k) =
          c.friction_force - lost_friction(iterate, k, moved.col(k), lost);
  }
  iterate.advance(u, dx, *motion);
  return true;
}

bool factor_with_contacts(PressIterate& iterate) {
  add_own_stiffness(iterate);
  return iterate.factor_stabilized(
      [&] { return iterate.factors.tangent.factor(iterate.tissue.tangent); });
}

}  // namespace

PressOutcome press_by_newton(PressIterate& iterate) {
  PressOutcome out;
  VectorXd dx;
  bool reuses_tangent = false;
  double residual_before = kInfinity;
  for (; iterate.may_continue(out); ++out.iterations) {
    // Evaluate tissue and contacts, with the stiffness unless the tangent is reused.
    Matrix3Xd u;
    const auto request = reuses_tangent ? ElementRequest::kForce : ElementRequest::kStiffness;
    if (!iterate.evaluate_tissue(request, dx, u, out)) return out;
    if (out.iterations == 0) iterate.set_node_stiffness(iterate.tissue.tangent);
    const std::vector<ContactState> states_before = contact_states(iterate);
    const IterateAction action = assess_iterate(iterate, u, out);
    if (action == IterateAction::kEnded) return out;
    if (action == IterateAction::kMoved) continue;
    // Renew a reused tangent if contacts have changed or the residual decreases too slowly.
    const double residual =
        std::max({out.residual, iterate.max_force_change, std::abs(iterate.force_deficit)});
    const bool same_contacts = contact_states(iterate) == states_before;
    if (reuses_tangent && !(same_contacts && residual < kTangentReuseRatio * residual_before)) {
      reuses_tangent = false;
      iterate.body.evaluate(u, iterate.goal.time, iterate.start.history, iterate.state.pressure,
                            ElementRequest::kStiffness, iterate.tissue);
    }
    if ((!reuses_tangent && !factor_with_contacts(iterate)) || !take_step(iterate, u))
      return failed_by(out, "the stiffness is not positive definite");
    // Reuse the tangent close to the solution, while contacts keep their states.
    residual_before = residual;
    reuses_tangent = same_contacts && residual < kTangentReuseShare * iterate.total_force;
  }
  return out;
}

}  // namespace thenar
