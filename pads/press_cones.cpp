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
void add_turning_slopes(PressIterate& at) {
  const double step = kTurningDistance * std::sqrt(at.surface.area.mean());
  const Pose<double> X_OP = at.now.X_PO.inverse();
  for (std::size_t k = 0; k < at.contacts.size(); ++k) {
    const double normal = at.now.normal[static_cast<Eigen::Index>(k)];
    if (normal <= 0) continue;
    const auto normal_at = [&](const Vector3d& p) {
      return Vector3d(at.now.X_PO.R * at.object.shape->nearest(X_OP * p).normal);
    };
    // Slope of the normal by central differences.
    Matrix3d slope;
    for (int c = 0; c < 3; ++c) {
      const Vector3d way = step * Vector3d::Unit(c);
      slope.col(c) =
          (normal_at(at.place_of(k) + way) - normal_at(at.place_of(k) - way)) / (2 * step);
    }
    at.add_block(k, -0.5 * normal * (slope + slope.transpose()));
  }
}

/// Factors the tangent at this state, with the effect of forces whose normals turn. If the body is
/// stable only by its contacts, the contacts get springs.
bool renew_tangent(PressIterate& at, const Matrix3Xd& u) {
  at.body.respond(u, at.goal.time, at.start.history, at.now.pressure, ElementAsk::kStiffness,
                  at.tissue);
  // Tangent with turning forces, or without where that is not positive definite.
  const Matrix3Xd none(3, 0);
  const std::vector<double> tissue = at.tissue.values;
  add_turning_slopes(at);
  if (at.factors.cones.factor(at.tissue.values, none)) return true;
  at.tissue.values = tissue;
  if (at.factors.cones.factor(at.tissue.values, none)) return true;
  // Springs between contacts and object, where the contacts alone hold the body.
  Matrix3Xd springs = Matrix3Xd::Zero(3, static_cast<Eigen::Index>(at.contacts.size()));
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    if (at.contacts[k].push > 0)
      springs.col(static_cast<Eigen::Index>(k)) = std::sqrt(at.stiffness[k]) * at.gaps.own_slope(k);
  add_own_slopes(at);
  return at.factored([&] { return at.factors.cones.factor(at.tissue.values, springs); });
}

/// Slip of every node since the last step, tangential [m] (3, nodes).
Matrix3Xd slips_of(const PressIterate& at) {
  Matrix3Xd out(3, static_cast<Eigen::Index>(at.contacts.size()));
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    out.col(static_cast<Eigen::Index>(k)) = at.slip_of(k);
  return out;
}

/// The linear body at rest under its contacts.
ContactCones::Rest rest_under_cones(PressIterate& at) {
  const Matrix3Xd slip = slips_of(at);
  // A force to reach drives the object, held by a soft spring.
  std::optional<ContactCones::Drive> drive;
  if (at.goal.force)
    drive = {at.goal.along, *at.goal.force,
             kDriveSpringRatio * at.body.largest_modulus() * std::sqrt(at.surface.area.mean()),
             at.longest};
  return at.factors.cones.solve(at.surface, {at.tissue.force, at.gaps, slip, at.now.normal,
                                             at.now.shear, at.object.friction, drive});
}

}  // namespace

PressOutcome press_by_cones(PressIterate& at) {
  PressOutcome out;
  const CondensedBody& tangent = at.factors.cones.body();
  double before = kInfinity;
  VectorXd dx, last;
  AndersonMixing mixing(kMixedMotions);
  for (; at.goes_on(out); ++out.iterations) {
    // Tissue and contacts at the iterate; stiffness only if there is no tangent yet.
    Matrix3Xd u;
    const bool has_factor = tangent.has_factor();
    if (!at.respond(has_factor ? ElementAsk::kForce : ElementAsk::kStiffness, dx, u, out))
      return out;
    if (at.stiffness.empty()) at.find_stiffness(has_factor ? tangent.values() : at.tissue.values);
    const IterateTurn turn = judge_iterate(at, u, out);
    if (turn == IterateTurn::kEnded) return out;
    if (turn == IterateTurn::kMoved) continue;
    // An older tangent serves while the residual falls well.
    const double left = std::max(out.residual, at.change);
    const bool well = out.iterations == 0 || left < kTangentFallRatio * std::min(before, at.scale);
    if (!(has_factor && well) && !renew_tangent(at, u)) {
      out.message = "the stiffness is not positive definite";
      return out;
    }
    before = left;
    // Linear body at rest under exact cones.
    const ContactCones::Rest rest = rest_under_cones(at);
    if (rest.status != Status::kSolved) {
      out.message = "no forces of contact were found";
      return out;
    }
    // Anderson mixing where motions shrink slowly, as where friction turns with normals.
    dx = rest.dx;
    const bool creeps = last.size() > 0 && rest.dx.norm() > kCreepRatio * last.norm();
    last = rest.dx;
    if (at.goal.force || !creeps || left > kMixingShare * at.scale) mixing.clear();
    dx = mixing.next_step(rest.dx);
    // Pressure and contact forces that the motion predicts.
    at.now.pressure = at.body.pressure_after(u, at.body.spread(dx, {}));
    at.now.x += dx;
    at.now.X_PO.p += rest.motion * at.goal.along;
    at.now.normal = rest.normal;
    at.now.shear = rest.shear;
  }
  return out;
}

}  // namespace thenar
