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
VectorXd solve_coupled(const PressIterate& at, const VectorXd& b) {
  if (!at.gaps.neighbours_matter() && !some_slip(at)) return at.factors.moment.solve(b);
  return at.solve_with(b, [&](const Matrix3Xd& moved) {
    // Loss of contact forces, less the part that the factor has.
    Matrix3Xd more = contact_loss(at, moved);
    for (std::size_t k = 0; k < at.contacts.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      more.col(column) -= own_slope(at, k) * moved.col(column);
    }
    return more;
  });
}

/// @param u  displacements of all nodes [m] (3, nodes)
/// @return false if the object finds no way to its force
bool take_step(PressIterate& at, const Matrix3Xd& u) {
  // Newton step; to reach a force the object's motion is one more unknown.
  VectorXd dx = solve_coupled(at, -at.residual);
  double motion = 0;
  if (at.goal.force &&
      !at.reach_force([&](const Matrix3Xd& moved) { return contact_loss(at, moved); },
                      [&](const VectorXd& b) { return solve_coupled(at, b); }, dx, motion))
    return false;
  // What the step predicts becomes the new pressure and the new contact forces.
  at.now.pressure = at.body.pressure_after(u, at.body.spread(dx, {}));
  Matrix3Xd moved = at.on_surface(dx);
  moved.colwise() -= motion * at.goal.along;
  const VectorXd closed = at.gaps.change(moved);
  for (std::size_t k = 0; k < at.contacts.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const TouchingNode& c = at.contacts[k];
    const double before = c.push - at.stiffness[k] * closed[column];
    at.now.normal[column] = c.push > 0 ? std::max(0.0, before) : 0;
    at.now.shear.col(column) =
        at.now.normal[column] > 0 ? Vector3d(c.shear - lost_shear(at, k, moved.col(column),
                                                                  at.stiffness[k] * closed[column]))
                                  : Vector3d(0, 0, 0);
  }
  at.now.x += dx;
  at.now.X_PO.p += motion * at.goal.along;
  return true;
}

bool factor_here(PressIterate& at) {
  add_own_slopes(at);
  return at.factored([&] { return at.factors.moment.factor(at.tissue.values); });
}

}  // namespace

PressOutcome press_by_newton(PressIterate& at) {
  PressOutcome out;
  VectorXd dx;
  bool keeps = false;
  double before = kInfinity;
  for (; at.goes_on(out); ++out.iterations) {
    // Tissue and contacts at the iterate; stiffness only if no tangent is kept.
    Matrix3Xd u;
    if (!at.respond(keeps ? ElementAsk::kForce : ElementAsk::kStiffness, dx, u, out)) return out;
    if (out.iterations == 0) at.find_stiffness(at.tissue.values);
    const std::vector<int> touched = contact_states(at);
    const IterateTurn turn = judge_iterate(at, u, out);
    if (turn == IterateTurn::kEnded) return out;
    if (turn == IterateTurn::kMoved) continue;
    // Renew a kept tangent where contacts have changed or the residual falls too slowly.
    const double left = std::max({out.residual, at.change, std::abs(at.missing)});
    const bool same = contact_states(at) == touched;
    if (keeps && !(same && left < kTangentReuseRatio * before)) {
      keeps = false;
      at.body.respond(u, at.goal.time, at.start.history, at.now.pressure, ElementAsk::kStiffness,
                      at.tissue);
    }
    if ((!keeps && !factor_here(at)) || !take_step(at, u)) {
      out.message = "the stiffness is not positive definite";
      return out;
    }
    // Keep the tangent close to the answer, while contacts stay.
    before = left;
    keeps = same && left < kTangentReuseShare * at.scale;
  }
  return out;
}

}  // namespace thenar
