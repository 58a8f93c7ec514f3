#include "pads/press_iterate.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "pads/press_crossing.h"
#include "solvers/sparse/gmres.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Least contact stiffness over that of the tissue under a node at rest [1]
constexpr double kMinStiffnessOverRest = 100;
// Contact stiffness over that of the deformed body at a node [1]
constexpr double kStiffnessOverBody = 10;
// Largest contact stiffness over that of the tissue under a node at rest [1]
constexpr double kMaxStiffnessOverRest = 5000;

// Longest motion of the object in an iteration to a force, over the distance of nodes [1]
constexpr double kMaxMotionRatio = 0.25;
// Largest gap that the object crosses to touch, over that motion [1]
constexpr double kMaxSearchRatio = 20;
// Depth of the object after it has moved to touch, over that motion [1]
constexpr double kTouchDepthRatio = 0.01;
constexpr int kMaxMotionHalvings = 10;  // halvings of a motion that inverts an element
// Stiffness of the softest stabilizing springs over the diagonal of the tangent [1]
constexpr double kMinHoldRatio = 1e-6;
// Stiffness of the stiffest stabilizing springs over the diagonal of the tangent [1]
constexpr double kMaxHoldRatio = 1;
constexpr double kCouplingTolerance = 1e-6;  // relative tolerance of solve_iteratively() [1]
constexpr int kMaxCouplingIterations = 40;   // iterations of solve_iteratively()
// Rounding error of volumetric strains in the forces of an element [1]
constexpr double kRoundedStrain = 1e-14;
// Rounding error of coordinates, for objects of up to a metre [m]
constexpr double kRoundedCoordinate = 2e-16;

double mean_diagonal(const TissueBody& body, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 0; i < body.free_nodes().size(); ++i)
    for (int c = 0; c < 3; ++c) sum += values[body.diagonal_entry(static_cast<int>(i), c, c)];
  return sum / body.unknowns();
}

void add_to_diagonal(const TissueBody& body, double more, std::vector<double>& values) {
  for (std::size_t i = 0; i < body.free_nodes().size(); ++i)
    for (int c = 0; c < 3; ++c) values[body.diagonal_entry(static_cast<int>(i), c, c)] += more;
}

}  // namespace

PressIterate::PressIterate(const PressProblem& problem, PressFactors& tangents)
    : PressProblem(problem),
      factors(tangents),
      state(problem.start),
      gaps(problem.surface),
      contacts(problem.surface.nodes.size()),
      max_motion(kMaxMotionRatio * std::sqrt(problem.surface.area.mean())) {
  state.X_PO = goal.X_PO;
}

void PressIterate::reset_to_start() {
  state = start;
  state.X_PO = goal.X_PO;
  node_stiffness.clear();
}

bool PressIterate::may_continue(PressOutcome& out) const {
  if (out.iterations >= options.max_iterations) {
    out.status = Status::kLimit;
    out.message = "too many iterations";
    return false;
  }
  if (options.stop && options.stop()) {
    out.status = Status::kStopped;
    out.message = "stopped";
    return false;
  }
  return true;
}

bool PressIterate::evaluate_tissue(ElementRequest request, VectorXd& dx, Matrix3Xd& u,
                                   PressOutcome& out) {
  for (int cut = 0; cut <= kMaxMotionHalvings; ++cut) {
    u = body.node_displacements(state.x, {});
    body.evaluate(u, goal.time, start.history, state.pressure, request, tissue);
    if (!tissue.inverted) return true;
    // Take back half of the last motion.
    if (dx.size() == 0) break;
    dx *= 0.5;
    state.x -= dx;
  }
  out.message = "an element turned inside out";
  return false;
}

void PressIterate::measure_residual(const Matrix3Xd& forces, PressOutcome& out) {
  residual = tissue.force;
  out.gap = max_force_change = force_rounding = 0;
  out.push = {};
  total_force = 0;
  // Subtract the contact forces from those of the tissue, and sum their wrench on the body.
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const SkinNodeContact& c = contacts[k];
    const Vector3d force = forces.col(k) + c.friction_force;
    if (force.isZero(0)) continue;
    residual.segment<3>(3 * surface.nodes[k]) -= force;
    out.push += wrench_of_force(node_position(k), force);
    total_force += force.norm();
    if (c.normal_force <= 0) continue;
    force_rounding = std::max(force_rounding, node_stiffness[k] * kRoundedCoordinate);
    // Track changes of the forces: a node whose force still changes may yet stick, slip or open.
    max_force_change = std::max(max_force_change,
                                (c.friction_force - Vector3d(state.friction_force.col(k))).norm());
    if (springs) continue;  // springs leave no gap to close
    out.gap = std::max(out.gap, std::abs(gaps.gap(k)));
    max_force_change = std::max(max_force_change, std::abs(c.normal_force - state.normal_force[k]));
  }
  push = out.push;
  out.residual = residual.lpNorm<Eigen::Infinity>();
  force_deficit = goal.force ? *goal.force - goal.along.dot(out.push.force) : 0;
}

bool PressIterate::is_converged(const PressOutcome& out) const {
  // Bound the tolerance from below by the rounding errors of element forces, which bulk moduli
  // amplify, and of contact forces, which their stiffness amplifies.
  const double rounding = std::max(kRoundedStrain * body.max_pressure_force(), force_rounding);
  const double tolerance = std::max(options.force_tolerance * total_force, rounding);
  return out.residual <= tolerance && std::abs(force_deficit) <= std::max(tolerance, 1e-9) &&
         out.gap <= options.gap_tolerance && max_force_change <= tolerance;
}

void PressIterate::accept(const Matrix3Xd& u, PressOutcome& out) const {
  out.message = describe_crossing(*this, u);
  if (out.message.empty()) out.status = Status::kSolved;
}

bool PressIterate::move_to_contact(PressOutcome& out) {
  double nearest = kInfinity;
  for (std::size_t k = 0; k < contacts.size(); ++k) nearest = std::min(nearest, gaps.gap(k));
  if (nearest > kMaxSearchRatio * max_motion) {
    out.message = "the object does not touch: move it until it does";
    return false;
  }
  state.X_PO.p += (nearest + kTouchDepthRatio * max_motion) * goal.along;
  return true;
}

void PressIterate::set_node_stiffness(const std::vector<double>& values) {
  node_stiffness.clear();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    // Compare the stiffness of the tissue at rest under the node and of the deformed body.
    const double at_rest = body.max_shear_modulus() * std::sqrt(surface.area[k]);
    double here = 0;
    for (int c = 0; c < 3; ++c)
      here = std::max(here, values[body.diagonal_entry(surface.nodes[k], c, c)]);
    // The upper bound limits the rounding error that coordinates cause in the forces.
    node_stiffness.push_back(std::clamp(kStiffnessOverBody * here, kMinStiffnessOverRest * at_rest,
                                        kMaxStiffnessOverRest * at_rest));
  }
}

bool PressIterate::factor_stabilized(const std::function<bool()>& factor) {
  if (factor()) return true;
  const double mean = mean_diagonal(body, tissue.tangent);
  // Add springs to the diagonal, ten times stiffer at each attempt.
  double held = 0;
  for (double share = kMinHoldRatio; share <= kMaxHoldRatio; share *= 10) {
    add_to_diagonal(body, share * mean - held, tissue.tangent);
    held = share * mean;
    if (factor()) return true;
  }
  return false;
}

void PressIterate::add_node_block(std::size_t k, const Matrix3d& block) {
  for (int c = 0; c < 3; ++c)
    for (int r = c; r < 3; ++r)
      tissue.tangent[body.diagonal_entry(surface.nodes[k], r, c)] += block(r, c);
}

std::optional<double> PressIterate::solve_object_motion(
    const std::function<Matrix3Xd(const Matrix3Xd&)>& loss,
    const std::function<VectorXd(const VectorXd&)>& solve, VectorXd& dx) const {
  if (!goal.force) return 0.0;
  // Compute the forces lost by a unit motion of the object, and the body's response to them.
  const Matrix3Xd lost = loss(goal.along.replicate(1, static_cast<Eigen::Index>(contacts.size())));
  const VectorXd follows = solve(body_forces(lost));
  const auto lost_along = [&](const Matrix3Xd& forces) {
    return goal.along.dot(forces.rowwise().sum());
  };
  // Eliminate the body: the Schur complement is the stiffness of the object's motion.
  const double schur = lost_along(lost) - lost_along(loss(surface_displacements(follows)));
  if (!(schur > 0)) return std::nullopt;
  const double motion =
      std::clamp((force_deficit + lost_along(loss(surface_displacements(dx)))) / schur, -max_motion,
                 max_motion);
  dx += motion * follows;
  return motion;
}

void PressIterate::advance(const Matrix3Xd& u, const VectorXd& dx, double object_motion) {
  state.pressure = body.predict_pressure(u, body.node_displacements(dx, {}));
  state.x += dx;
  state.X_PO.p += object_motion * goal.along;
}

VectorXd PressIterate::solve_iteratively(
    const VectorXd& b, const std::function<Matrix3Xd(const Matrix3Xd&)>& left_out) const {
  // Solve  (1 + A^-1 B) x = A^-1 b  by GMRES, where the factor of A leaves out B.
  return gmres(
      [&](const VectorXd& x) {
        return VectorXd(x + factors.tangent.solve(body_forces(left_out(surface_displacements(x)))));
      },
      factors.tangent.solve(b), kCouplingTolerance, kMaxCouplingIterations);
}

Vector3d PressIterate::node_position(std::size_t k) const {
  return surface.rest_positions.col(k) + state.x.segment<3>(3 * surface.nodes[k]);
}

Vector3d PressIterate::tangential(std::size_t k, const Vector3d& v) const {
  const Vector3d normal = gaps.normal(k);
  return v - v.dot(normal) * normal;
}

Vector3d PressIterate::node_slip(std::size_t k) const {
  const Vector3d anchor = start.anchor.col(k);
  return tangential(k, node_position(k) - state.X_PO * anchor);
}

Matrix3Xd PressIterate::surface_displacements(const VectorXd& x) const {
  return deformed_positions(surface, x) - surface.rest_positions;
}

VectorXd PressIterate::body_forces(const Matrix3Xd& forces) const {
  VectorXd out = VectorXd::Zero(body.unknowns());
  for (std::size_t k = 0; k < contacts.size(); ++k)
    out.segment<3>(3 * surface.nodes[k]) = forces.col(k);
  return out;
}

}  // namespace thenar
