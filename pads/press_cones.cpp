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

// Keep the tangent while an iteration leaves less than this share of the residual [1]
constexpr double kTangentFallRatio = 0.3;
// Spring of a drive, over the stiffness of tissue under a node [1]
constexpr double kDriveSpringRatio = 1e-2;
// A motion longer than this share of the motion before it creeps [1]
constexpr double kCreepRatio = 0.4;
// Creeping motions are mixed once the residual is below this share of the forces [1]
constexpr double kMixingShare = 0.02;
constexpr std::size_t kMixedMotions = 3;  // Number of motions that Anderson mixing combines
// Distance over which a normal's turn is measured, over the distance of nodes [1]
constexpr double kTurningDistance = 0.1;

/// Adds to the tangent that a node which slides over a curved object has its normal force turn:
/// - normal d2 distance / dx2, by differences over a part of the way between nodes, as if all force
/// were the node's own.
void add_turning_slopes(PressIterate& iterate) {
  const double step = kTurningDistance * std::sqrt(iterate.surface.area.mean());
  const Pose<double> X_OP = iterate.state.X_PO.inverse();
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k) {
    const double normal = iterate.state.normal_force[static_cast<Eigen::Index>(k)];
    if (normal <= 0) continue;
    const auto normal_at = [&](const Vector3d& p) {
      return Vector3d(iterate.state.X_PO.R * iterate.object.shape->nearest(X_OP * p).normal);
    };
    // Slope of the normal by central differences.
    Matrix3d slope;
    for (int c = 0; c < 3; ++c) {
      const Vector3d way = step * Vector3d::Unit(c);
      slope.col(c) =
          (normal_at(iterate.node_position(k) + way) - normal_at(iterate.node_position(k) - way)) /
          (2 * step);
    }
    iterate.add_node_block(k, -0.5 * normal * (slope + slope.transpose()));
  }
}

/// Factors the tangent at this state, with the effect of forces whose normals turn. If the body is
/// stable only by its contacts, the contacts get springs.
bool renew_tangent(PressIterate& iterate, const Matrix3Xd& u) {
  iterate.body.evaluate(u, iterate.goal.time, iterate.start.history, iterate.state.pressure,
                        ElementRequest::kStiffness, iterate.tissue);
  // Tangent with turning forces, or without where that is not positive definite.
  const Matrix3Xd none(3, 0);
  const std::vector<double> tissue = iterate.tissue.tangent;
  add_turning_slopes(iterate);
  if (iterate.factors.cones.factor(iterate.tissue.tangent, none)) return true;
  iterate.tissue.tangent = tissue;
  if (iterate.factors.cones.factor(iterate.tissue.tangent, none)) return true;
  // Springs between contacts and object, where the contacts alone hold the body.
  Matrix3Xd springs = Matrix3Xd::Zero(3, static_cast<Eigen::Index>(iterate.contacts.size()));
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    if (iterate.contacts[k].normal_force > 0)
      springs.col(static_cast<Eigen::Index>(k)) =
          std::sqrt(iterate.node_stiffness[k]) * iterate.gaps.own_gradient(k);
  add_own_stiffness(iterate);
  return iterate.factor_stabilized(
      [&] { return iterate.factors.cones.factor(iterate.tissue.tangent, springs); });
}

/// Slip of every node since the last step, tangential [m] (3, nodes).
Matrix3Xd slips_of(const PressIterate& iterate) {
  Matrix3Xd out(3, static_cast<Eigen::Index>(iterate.contacts.size()));
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    out.col(static_cast<Eigen::Index>(k)) = iterate.node_slip(k);
  return out;
}

/// The linear body at rest under its contacts.
ContactCones::Equilibrium solve_under_cones(PressIterate& iterate) {
  const Matrix3Xd slip = slips_of(iterate);
  // A force to reach drives the object, held by a soft spring.
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
  double before = kInfinity;
  VectorXd dx, last;
  AndersonMixing mixing(kMixedMotions);
  for (; iterate.may_continue(out); ++out.iterations) {
    // Tissue and contacts at the iterate; stiffness only if there is no tangent yet.
    Matrix3Xd u;
    const bool has_factor = tangent.has_factor();
    if (!iterate.evaluate_tissue(has_factor ? ElementRequest::kForce : ElementRequest::kStiffness,
                                 dx, u, out))
      return out;
    if (iterate.node_stiffness.empty())
      iterate.set_node_stiffness(has_factor ? tangent.tangent() : iterate.tissue.tangent);
    const IterateAction turn = assess_iterate(iterate, u, out);
    if (turn == IterateAction::kEnded) return out;
    if (turn == IterateAction::kMoved) continue;
    // An older tangent serves while the residual falls well.
    const double left = std::max(out.residual, iterate.max_force_change);
    const bool well =
        out.iterations == 0 || left < kTangentFallRatio * std::min(before, iterate.total_force);
    if (!(has_factor && well) && !renew_tangent(iterate, u)) {
      out.message = "the stiffness is not positive definite";
      return out;
    }
    before = left;
    // Linear body at rest under exact cones.
    const ContactCones::Equilibrium rest = solve_under_cones(iterate);
    if (rest.status != Status::kSolved) {
      out.message = "no forces of contact were found";
      return out;
    }
    // Anderson mixing where motions shrink slowly, as where friction turns with normals.
    dx = rest.dx;
    const bool creeps = last.size() > 0 && rest.dx.norm() > kCreepRatio * last.norm();
    last = rest.dx;
    if (iterate.goal.force || !creeps || left > kMixingShare * iterate.total_force) mixing.clear();
    dx = mixing.next(rest.dx);
    // Pressure and contact forces that the motion predicts.
    iterate.state.pressure =
        iterate.body.predict_pressure(u, iterate.body.node_displacements(dx, {}));
    iterate.state.x += dx;
    iterate.state.X_PO.p += rest.object_motion * iterate.goal.along;
    iterate.state.normal_force = rest.normal_force;
    iterate.state.friction_force = rest.friction_force;
  }
  return out;
}

}  // namespace thenar
