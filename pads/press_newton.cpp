#include "pads/press_newton.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "pads/node_contacts.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Keep the tangent while an iteration leaves less than this share of the residual [1]
constexpr double kTangentReuseRatio = 0.3;
// Keep it only while the residual is below this share of the contact forces [1]
constexpr double kTangentReuseShare = 0.2;

/// Solves with the matrix of this iteration: most of it has a factor, and what contacts add between
/// nodes comes by iterations.
VectorXd solve_coupled(const PressIterate& iterate, const VectorXd& b) {
  if (!iterate.gaps.depends_on_neighbours() && !has_sliding_nodes(iterate))
    return iterate.factors.tangent.solve(b);
  return iterate.solve_iteratively(b, [&](const Matrix3Xd& moved) {
    // Loss of contact forces, less the part that the factor has.
    Matrix3Xd more = contact_force_loss(iterate, moved);
    for (std::size_t k = 0; k < iterate.contacts.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      more.col(column) -= own_stiffness(iterate, k) * moved.col(column);
    }
    return more;
  });
}

/// @param u  displacements of all nodes [m] (3, nodes)
/// @return false if the object finds no way to its force
bool take_step(PressIterate& iterate, const Matrix3Xd& u) {
  // Newton step; to reach a force the object's motion is one more unknown.
  VectorXd dx = solve_coupled(iterate, -iterate.residual);
  double motion = 0;
  if (iterate.goal.force &&
      !iterate.solve_object_motion(
          [&](const Matrix3Xd& moved) { return contact_force_loss(iterate, moved); },
          [&](const VectorXd& b) { return solve_coupled(iterate, b); }, dx, motion))
    return false;
  // What the step predicts becomes the new pressure and the new contact forces.
  iterate.state.pressure =
      iterate.body.predict_pressure(u, iterate.body.node_displacements(dx, {}));
  Matrix3Xd moved = iterate.surface_displacements(dx);
  moved.colwise() -= motion * iterate.goal.along;
  const VectorXd closed = iterate.gaps.gap_changes(moved);
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const NodeContact& c = iterate.contacts[k];
    const double before = c.normal_force - iterate.node_stiffness[k] * closed[column];
    iterate.state.normal_force[column] = c.normal_force > 0 ? std::max(0.0, before) : 0;
    iterate.state.friction_force.col(column) =
        iterate.state.normal_force[column] > 0
            ? Vector3d(c.friction_force - lost_friction(iterate, k, moved.col(column),
                                                        iterate.node_stiffness[k] * closed[column]))
            : Vector3d(0, 0, 0);
  }
  iterate.state.x += dx;
  iterate.state.X_PO.p += motion * iterate.goal.along;
  return true;
}

bool factor_here(PressIterate& iterate) {
  add_own_stiffness(iterate);
  return iterate.factor_stabilized(
      [&] { return iterate.factors.tangent.factor(iterate.tissue.tangent); });
}

}  // namespace

PressOutcome press_by_newton(PressIterate& iterate) {
  PressOutcome out;
  VectorXd dx;
  bool keeps = false;
  double before = kInfinity;
  for (; iterate.may_continue(out); ++out.iterations) {
    // Tissue and contacts at the iterate; stiffness only if no tangent is kept.
    Matrix3Xd u;
    if (!iterate.evaluate_tissue(keeps ? ElementRequest::kForce : ElementRequest::kStiffness, dx, u,
                                 out))
      return out;
    if (out.iterations == 0) iterate.set_node_stiffness(iterate.tissue.tangent);
    const std::vector<ContactState> states_before = contact_states(iterate);
    const IterateAction turn = assess_iterate(iterate, u, out);
    if (turn == IterateAction::kEnded) return out;
    if (turn == IterateAction::kMoved) continue;
    // Renew a kept tangent where contacts have changed or the residual falls too slowly.
    const double left =
        std::max({out.residual, iterate.max_force_change, std::abs(iterate.force_deficit)});
    const bool same = contact_states(iterate) == states_before;
    if (keeps && !(same && left < kTangentReuseRatio * before)) {
      keeps = false;
      iterate.body.evaluate(u, iterate.goal.time, iterate.start.history, iterate.state.pressure,
                            ElementRequest::kStiffness, iterate.tissue);
    }
    if ((!keeps && !factor_here(iterate)) || !take_step(iterate, u)) {
      out.message = "the stiffness is not positive definite";
      return out;
    }
    // Keep the tangent close to the answer, while contacts stay.
    before = left;
    keeps = same && left < kTangentReuseShare * iterate.total_force;
  }
  return out;
}

}  // namespace thenar
