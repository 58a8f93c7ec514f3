#include "pads/press_cones.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/numbers.h"
#include "pads/node_contacts.h"
#include "solvers/anderson_mixing.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Stiffness of a drive's spring over that of the tissue under a node [1]
constexpr double kDriveSpringRatio = 1e-2;
// Length of a motion over that of the last one above which motions creep [1]
constexpr double kCreepRatio = 0.4;
// Largest residual over the contact forces for which creeping motions are mixed [1]
constexpr double kMixingShare = 0.02;
constexpr std::size_t kMixedMotions = 3;  // number of motions that Anderson mixing combines
// Step of the differences of normals, over the distance of nodes [1]
constexpr double kNormalStepRatio = 0.1;

/// Adds to the tangent the effect of normal forces that turn as nodes slide over a curved object,
/// - (normal force) d2 distance / dx2,  by differences over a part of the distance between nodes,
/// as if each gap depended on its own node alone.
void add_curvature_stiffness(PressIterate& iterate) {
  const double step = kNormalStepRatio * std::sqrt(iterate.surface.area.mean());
  const Pose<double> X_OP = iterate.state.X_PO.inverse();
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k) {
    const double normal_force = iterate.state.normal_force[k];
    if (normal_force <= 0) continue;
    const auto normal_at = [&](const Vector3d& p) {
      return Vector3d(iterate.state.X_PO.R * iterate.object.shape->nearest(X_OP * p).normal);
    };
    // Differentiate the normal by central differences.
    const Vector3d p = iterate.node_position(k);
    Matrix3d slope;
    for (int c = 0; c < 3; ++c) {
      const Vector3d shift = step * Vector3d::Unit(c);
      slope.col(c) = (normal_at(p + shift) - normal_at(p - shift)) / (2 * step);
    }
    iterate.add_node_block(k, -0.5 * normal_force * (slope + slope.transpose()));
  }
}

/// Computes and factors the tangent at this state, with the effect of turning normal forces. If the
/// body is stable only by its contacts, springs at the contacts are added.
bool renew_tangent(PressIterate& iterate, const Matrix3Xd& u) {
  iterate.body.evaluate(u, iterate.goal.time, iterate.start.history, iterate.state.pressure,
                        ElementRequest::kStiffness, iterate.tissue);
  // Try the tangent with turning forces, then without.
  const Matrix3Xd no_springs(3, 0);
  const std::vector<double> tissue_tangent = iterate.tissue.tangent;
  add_curvature_stiffness(iterate);
  if (iterate.factors.cones.factor(iterate.tissue.tangent, no_springs)) return true;
  iterate.tissue.tangent = tissue_tangent;
  if (iterate.factors.cones.factor(iterate.tissue.tangent, no_springs)) return true;
  // Add springs between touching nodes and the object.
  Matrix3Xd springs = Matrix3Xd::Zero(3, iterate.contacts.size());
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    if (iterate.contacts[k].normal_force > 0)
      springs.col(k) = std::sqrt(iterate.node_stiffness[k]) * iterate.gaps.own_gradient(k);
  add_own_stiffness(iterate);
  return iterate.factor_stabilized(
      [&] { return iterate.factors.cones.factor(iterate.tissue.tangent, springs); });
}

/// Solves for the equilibrium of the linearized body under its contacts.
ContactCones::Equilibrium solve_under_cones(PressIterate& iterate) {
  Matrix3Xd slip(3, static_cast<Eigen::Index>(iterate.contacts.size()));
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k) slip.col(k) = iterate.node_slip(k);
  // A force to reach drives the object against a soft spring.
  std::optional<ContactCones::Drive> drive;
  if (iterate.goal.force)
    drive = {iterate.goal.along, *iterate.goal.force,
             kDriveSpringRatio * iterate.body.max_shear_modulus() *
                 std::sqrt(iterate.surface.area.mean()),
             iterate.max_motion};
  return iterate.factors.cones.solve(
      iterate.surface, {iterate.tissue.force, iterate.gaps, slip, iterate.state.normal_force,
                        iterate.state.friction_force, iterate.object.friction, drive});
}

}  // namespace

PressOutcome press_by_cones(PressIterate& iterate) {
  PressOutcome out;
  const CondensedBody& tangent = iterate.factors.cones.body();
  double residual_before = kInfinity;
  VectorXd dx, last_dx;
  AndersonMixing mixing(kMixedMotions);
  for (; iterate.may_continue(out); ++out.iterations) {
    // Evaluate tissue and contacts, with the stiffness if there is no tangent yet.
    Matrix3Xd u;
    const bool has_factor = tangent.has_factor();
    const auto request = has_factor ? ElementRequest::kForce : ElementRequest::kStiffness;
    if (!iterate.evaluate_tissue(request, dx, u, out)) return out;
    if (iterate.node_stiffness.empty())
      iterate.set_node_stiffness(has_factor ? tangent.tangent() : iterate.tissue.tangent);
    const IterateAction action = assess_iterate(iterate, u, out);
    if (action == IterateAction::kEnded) return out;
    if (action == IterateAction::kMoved) continue;
    // Renew the tangent unless the residual decreases fast enough with the old one.
    const double residual = std::max(out.residual, iterate.max_force_change);
    const bool converges =
        out.iterations == 0 ||
        residual < kTangentReuseRatio * std::min(residual_before, iterate.total_force);
    if (!(has_factor && converges) && !renew_tangent(iterate, u))
      return failed_by(out, "the stiffness is not positive definite");
    residual_before = residual;
    // Solve for the equilibrium of the linearized body under exact cones.
    const ContactCones::Equilibrium solution = solve_under_cones(iterate);
    if (solution.status != Status::kSolved)
      return failed_by(out, "no forces of contact were found");
    // Mix motions (Anderson) where they shrink slowly, as where friction turns with the normals.
    const bool creeps = last_dx.size() > 0 && solution.dx.norm() > kCreepRatio * last_dx.norm();
    last_dx = solution.dx;
    if (iterate.goal.force || !creeps || residual > kMixingShare * iterate.total_force)
      mixing.clear();
    dx = mixing.next_step(solution.dx);
    // Predict the pressure and the contact forces after the motion.
    iterate.advance(u, dx, solution.object_motion);
    iterate.state.normal_force = solution.normal_force;
    iterate.state.friction_force = solution.friction_force;
  }
  return out;
}

}  // namespace thenar
