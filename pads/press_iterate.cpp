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

// Least stiffness of contacts, over that of tissue under a node at rest [1]
constexpr double kContactOverRest = 100;
// Stiffness of contacts, over that of the deformed body at a node [1]
constexpr double kContactOverBody = 10;
// Largest stiffness of contacts, over tissue under a node at rest [1]
constexpr double kMostContactOverRest = 5000;

// Longest motion of the object in an iteration to a force, over the distance of nodes [1]
constexpr double kMotionShare = 0.25;
// Largest gap from which an object is brought to touch, over that motion [1]
constexpr double kSearchDistance = 20;
// Depth at which the object touches again, over that longest motion [1]
constexpr double kTouchDepth = 0.01;
constexpr int kMotionHalvings = 10;  // Most halvings of a motion that turns an element inside out
// Weakest springs that hold nodes, over the diagonal of the tangent [1]
constexpr double kLeastHold = 1e-6;
// Strongest springs that hold nodes, over the diagonal of the tangent [1]
constexpr double kMostHold = 1;
// Relative tolerance of a step in the coupling that the factor leaves out [1]
constexpr double kCouplingTolerance = 1e-6;
constexpr int kMostCouplingIterations = 40;  // Most iterations on that coupling
// Rounding of volume strains in the forces of an element [1]
constexpr double kRoundedStrain = 1e-14;
// Rounding of coordinates, for objects of up to a metre [m]
constexpr double kRoundedPlace = 2e-16;

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
      now(problem.start),
      gaps(problem.surface),
      contacts(problem.surface.nodes.size()),
      longest(kMotionShare * std::sqrt(problem.surface.area.mean())) {
  now.X_PO = goal.X_PO;
}

void PressIterate::restart() {
  now = start;
  now.X_PO = goal.X_PO;
  stiffness.clear();
}

bool PressIterate::goes_on(PressOutcome& out) const {
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

bool PressIterate::respond(ElementAsk ask, VectorXd& dx, Matrix3Xd& u, PressOutcome& out) {
  for (int cut = 0; cut <= kMotionHalvings; ++cut) {
    u = body.spread(now.x, {});
    body.respond(u, goal.time, start.history, now.pressure, ask, tissue);
    if (!tissue.inverted) return true;
    // Inverted: take back half of the last motion.
    if (dx.size() == 0) break;
    dx *= 0.5;
    now.x -= dx;
  }
  out.message = "an element turned inside out";
  return false;
}

void PressIterate::measure(const Matrix3Xd& forces, PressOutcome& out) {
  residual = tissue.force;
  out.gap = change = rounding = 0;
  out.push = {};
  scale = 0;
  // Contact forces, subtracted from those of tissue, and their wrench on the body.
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const TouchingNode& c = contacts[k];
    const auto column = static_cast<Eigen::Index>(k);
    const Vector3d force = forces.col(column) + c.shear;
    if (force.isZero(0)) continue;
    residual.segment<3>(3 * surface.nodes[k]) -= force;
    out.push += wrench_of_force(place_of(k), force);
    scale += force.norm();
    if (c.push <= 0) continue;
    rounding = std::max(rounding, stiffness[k] * kRoundedPlace);
    // A force that still changes may be that of a node that is to stick, to slip or to open.
    change = std::max(change, (c.shear - Vector3d(now.shear.col(column))).norm());
    if (springs) continue;  // springs leave no gap to close
    out.gap = std::max(out.gap, std::abs(gaps.gap(k)));
    change = std::max(change, std::abs(c.push - now.normal[column]));
  }
  push = out.push;
  out.residual = residual.lpNorm<Eigen::Infinity>();
  missing = goal.force ? *goal.force - goal.along.dot(out.push.force) : 0;
}

bool PressIterate::is_solved(const PressOutcome& out) const {
  // Tolerance, but no less than the rounding of forces within elements, which bulk moduli
  // magnify, and of contact forces, which their stiffness magnifies.
  const double rounded = std::max(kRoundedStrain * body.largest_pressure_force(), rounding);
  const double small = std::max(options.force_tolerance * scale, rounded);
  return out.residual <= small && std::abs(missing) <= std::max(small, 1e-9) &&
         out.gap <= options.gap_tolerance && change <= small;
}

void PressIterate::end(const Matrix3Xd& u, PressOutcome& out) const {
  out.message = find_crossing(*this, u);
  if (out.message.empty()) out.status = Status::kSolved;
}

bool PressIterate::go_to_touch(PressOutcome& out) {
  double nearest = 1e300;
  for (std::size_t k = 0; k < contacts.size(); ++k) nearest = std::min(nearest, gaps.gap(k));
  if (nearest > kSearchDistance * longest) {
    out.message = "the object does not touch: move it until it does";
    return false;
  }
  now.X_PO.p += (nearest + kTouchDepth * longest) * goal.along;
  return true;
}

void PressIterate::find_stiffness(const std::vector<double>& values) {
  stiffness.clear();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    // Stiffness of tissue at rest under the node, and of the body as it is.
    const double at_rest =
        body.largest_modulus() * std::sqrt(surface.area[static_cast<Eigen::Index>(k)]);
    double here = 0;
    for (int c = 0; c < 3; ++c)
      here = std::max(here, values[body.diagonal_entry(surface.nodes[k], c, c)]);
    // The upper bound keeps the rounding of places out of the forces.
    stiffness.push_back(std::clamp(kContactOverBody * here, kContactOverRest * at_rest,
                                   kMostContactOverRest * at_rest));
  }
}

bool PressIterate::factored(const std::function<bool()>& factor) {
  if (factor()) return true;
  const double mean = mean_diagonal(body, tissue.values);
  // Springs on the diagonal, ten times stiffer each time.
  double held = 0;
  for (double share = kLeastHold; share <= kMostHold; share *= 10) {
    add_to_diagonal(body, share * mean - held, tissue.values);
    held = share * mean;
    if (factor()) return true;
  }
  return false;
}

void PressIterate::add_block(std::size_t k, const Matrix3d& block) {
  for (int c = 0; c < 3; ++c)
    for (int r = c; r < 3; ++r)
      tissue.values[body.diagonal_entry(surface.nodes[k], r, c)] += block(r, c);
}

bool PressIterate::reach_force(const std::function<Matrix3Xd(const Matrix3Xd&)>& loss,
                               const std::function<VectorXd(const VectorXd&)>& solve, VectorXd& dx,
                               double& motion) const {
  // Forces lost by a unit motion of the object, and the body's answer to them.
  const Matrix3Xd lost = loss(goal.along.replicate(1, static_cast<Eigen::Index>(contacts.size())));
  const VectorXd follows = solve(on_body(lost));
  const auto lost_along = [&](const Matrix3Xd& forces) {
    return goal.along.dot(forces.rowwise().sum());
  };
  // Schur complement: stiffness of the object's motion, with the body following.
  const double schur = lost_along(lost) - lost_along(loss(on_surface(follows)));
  if (!(schur > 0)) return false;
  motion = std::clamp((missing + lost_along(loss(on_surface(dx)))) / schur, -longest, longest);
  dx += motion * follows;
  return true;
}

VectorXd PressIterate::solve_with(
    const VectorXd& b, const std::function<Matrix3Xd(const Matrix3Xd&)>& left_out) const {
  // GMRES on  (1 + A^-1 B) x = A^-1 b,  where the factor of A leaves out B.
  return gmres(
      [&](const VectorXd& x) {
        return VectorXd(x + factors.moment.solve(on_body(left_out(on_surface(x)))));
      },
      factors.moment.solve(b), kCouplingTolerance, kMostCouplingIterations);
}

Vector3d PressIterate::place_of(std::size_t k) const {
  return surface.places.col(static_cast<Eigen::Index>(k)) + now.x.segment<3>(3 * surface.nodes[k]);
}

Vector3d PressIterate::across(std::size_t k, const Vector3d& v) const {
  const Vector3d normal = gaps.normal(k);
  return v - v.dot(normal) * normal;
}

Vector3d PressIterate::slip_of(std::size_t k) const {
  const Vector3d anchor = start.anchor.col(static_cast<Eigen::Index>(k));
  return across(k, place_of(k) - now.X_PO * anchor);
}

Matrix3Xd PressIterate::on_surface(const VectorXd& x) const {
  return places_of(surface, x) - surface.places;
}

VectorXd PressIterate::on_body(const Matrix3Xd& forces) const {
  VectorXd out = VectorXd::Zero(body.unknowns());
  for (std::size_t k = 0; k < contacts.size(); ++k)
    out.segment<3>(3 * surface.nodes[k]) = forces.col(static_cast<Eigen::Index>(k));
  return out;
}

}  // namespace thenar
