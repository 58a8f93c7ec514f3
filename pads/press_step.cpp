#include "pads/press_step.h"

#include <cmath>

#include "base/error.h"
#include "pads/press_cones.h"
#include "pads/press_iterate.h"
#include "pads/press_newton.h"
#include "pads/press_springs.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;

// Most touching nodes for which cones cost less than Newton's method
constexpr int kMostConeNodes = 60;

/// Nodes that touch or, if no tissue moves, will be inside the object.
int nodes_to_touch(PressIterate& at) {
  at.gaps.find(*at.object.shape, at.now.X_PO, at.now.x);
  int count = 0;
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    count += at.now.normal[static_cast<Eigen::Index>(k)] > 0 || at.gaps.gap(k) < 0 ? 1 : 0;
  return count;
}

/// Solves by springs where there are edges; else by the augmented Lagrangian without friction or
/// where many nodes touch, or by cones; where one fails, by the other.
PressOutcome solve(PressIterate& at) {
  // Edges over the skin: springs.
  if (meets_edge(at.surface, *at.object.shape, at.start.X_PO, at.start.x) ||
      meets_edge(at.surface, *at.object.shape, at.goal.X_PO, at.start.x))
    return press_by_springs(at);
  // Newton's method or cones, and from the start again by the other if that fails.
  const bool augments = at.object.friction <= 0 || nodes_to_touch(at) > kMostConeNodes;
  PressOutcome out = augments ? press_by_newton(at) : press_by_cones(at);
  if (out.status == Status::kSolved || out.status == Status::kStopped) return out;
  const int iterations = out.iterations;
  at.restart();
  out = augments ? press_by_cones(at) : press_by_newton(at);
  out.iterations += iterations;
  return out;
}

/// The new state, once solved.
PressState finish(PressIterate& at) {
  PressState& now = at.now;
  for (std::size_t k = 0; k < at.contacts.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const TouchingNode& c = at.contacts[k];
    now.normal[column] = c.push;
    // Friction is cut to its cone, which it may exceed by the tolerance.
    const double bound = at.object.friction * c.push, size = c.shear.norm();
    now.shear.col(column) = (size > bound ? bound / size : 1.0) * c.shear;
    now.anchor.col(column) = now.X_PO.inverse() * at.place_of(k);
  }
  // Push and springs, and the relaxation over the step.
  now.push = at.push;
  now.by_springs = at.springs.has_value();
  now.spring_energy = at.springs ? at.springs->energy() : 0;
  if (at.springs && !at.stiffness.empty()) now.spring_stiffness = at.stiffness;
  now.history = at.body.advance(at.body.spread(now.x, {}), at.goal.time, at.start.history);
  return now;
}

/// Nodes that touch, by how they do.
TouchingNodes touching_nodes(const PressState& state, double friction) {
  TouchingNodes out;
  out.along_normal.resize(3, state.normal.size());
  for (Eigen::Index k = 0; k < state.normal.size(); ++k) {
    if (state.normal[k] <= 0) continue;
    out.along_normal.col(static_cast<Eigen::Index>(out.nodes.size())) =
        state.shear.col(k) / state.normal[k];
    out.nodes.push_back(static_cast<int>(k));
    out.sticks.push_back(node_sticks(state, k, friction));
  }
  return out;
}

/// Returns whether springs of a state, where there are some, are those of the surface's nodes.
bool has_springs_of(const PressState& state, const ContactSurface& surface) {
  return state.spring_stiffness.empty() || state.spring_stiffness.size() == surface.nodes.size();
}

}  // namespace

PressOutcome press_step(const TissueBody& body, const ContactSurface& surface,
                        const RigidObject& object, const PressGoal& goal,
                        const PressOptions& options, PressFactors& factors, PressState& state) {
  const auto nodes = static_cast<Eigen::Index>(surface.nodes.size());
  // Object and goal must make sense, and the state must fit the body.
  require(object.shape != nullptr, "an object without a shape presses on nothing");
  require(object.friction >= 0 && std::isfinite(object.friction),
          "friction must be finite and >= 0, got {}", object.friction);
  require(goal.X_PO.p.allFinite() && goal.X_PO.R.allFinite(), "a goal's pose is not finite");
  require(goal.time >= 0, "a step takes 0 s or more, got {}", goal.time);
  require(!goal.force || (std::isfinite(*goal.force) && *goal.force > 0),
          "a force to reach must be above 0, got {} N", goal.force.value_or(0));
  require(!goal.force || std::abs(goal.along.norm() - 1) < 1e-9,
          "the direction of a force is no unit vector");
  require(nodes > 0, "a body has no surface that may touch");
  require(state.x.size() == body.unknowns() && state.normal.size() == nodes &&
              state.shear.cols() == nodes && state.anchor.cols() == nodes &&
              has_springs_of(state, surface),
          "a state of {} unknowns and {} nodes does not fit a body of {} and {}", state.x.size(),
          state.normal.size(), body.unknowns(), nodes);
  // The state changes only if the step is solved.
  PressIterate at({body, surface, object, goal, options, state}, factors);
  PressOutcome out = solve(at);
  if (out.status == Status::kSolved) state = finish(at);
  return out;
}

Eigen::Matrix<double, 6, 6> press_stiffness(const TissueBody& body, const ContactSurface& surface,
                                            const RigidObject& object, const PressOptions& options,
                                            PressFactors& factors, const PressState& state) {
  require(state.x.size() == body.unknowns() &&
              state.normal.size() == static_cast<Eigen::Index>(surface.nodes.size()) &&
              has_springs_of(state, surface),
          "a state of {} unknowns does not fit a body of {}", state.x.size(), body.unknowns());
  PressGoal here;
  here.X_PO = state.X_PO;
  // Tissue at the state, with no time to relax.
  PressIterate at({body, surface, object, here, options, state}, factors);
  at.body.respond(body.spread(at.now.x, {}), 0, state.history, at.now.pressure,
                  ElementAsk::kStiffness, at.tissue);
  if (at.tissue.inverted) return Eigen::Matrix<double, 6, 6>::Zero();
  if (state.by_springs) return spring_press_stiffness(at);
  // Contacts of nodes on the body, whose compliance is found for the nodes that touch.
  at.gaps.find(*object.shape, at.now.X_PO, at.now.x);
  const TouchingNodes touching = touching_nodes(at.now, object.friction);
  if (touching.nodes.empty() || !factors.moment.factor(at.tissue.values))
    return Eigen::Matrix<double, 6, 6>::Zero();
  return contact_stiffness(factors.moment, surface, at.gaps, touching, places_of(surface, at.now.x),
                           at.gaps.spread(at.now.normal) + at.now.shear);
}

}  // namespace thenar
