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
int nodes_to_touch(PressIterate& iterate) {
  iterate.gaps.update(*iterate.object.shape, iterate.state.X_PO, iterate.state.x);
  int count = 0;
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    count += iterate.state.normal_force[static_cast<Eigen::Index>(k)] > 0 || iterate.gaps.gap(k) < 0
                 ? 1
                 : 0;
  return count;
}

/// Solves by springs where there are edges; else by the augmented Lagrangian without friction or
/// where many nodes touch, or by cones; where one fails, by the other.
PressOutcome solve(PressIterate& iterate) {
  // Edges over the skin: springs.
  if (has_edge_nearby(iterate.surface, *iterate.object.shape, iterate.start.X_PO,
                      iterate.start.x) ||
      has_edge_nearby(iterate.surface, *iterate.object.shape, iterate.goal.X_PO, iterate.start.x))
    return press_by_springs(iterate);
  // Newton's method or cones, and from the start again by the other if that fails.
  const bool augments = iterate.object.friction <= 0 || nodes_to_touch(iterate) > kMostConeNodes;
  PressOutcome out = augments ? press_by_newton(iterate) : press_by_cones(iterate);
  if (out.status == Status::kSolved || out.status == Status::kStopped) return out;
  const int iterations = out.iterations;
  iterate.reset_to_start();
  out = augments ? press_by_cones(iterate) : press_by_newton(iterate);
  out.iterations += iterations;
  return out;
}

/// The new state, once solved.
PressState finish(PressIterate& iterate) {
  PressState& now = iterate.state;
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const NodeContact& c = iterate.contacts[k];
    now.normal_force[column] = c.normal_force;
    // Friction is cut to its cone, which it may exceed by the tolerance.
    const double bound = iterate.object.friction * c.normal_force, size = c.friction_force.norm();
    now.friction_force.col(column) = (size > bound ? bound / size : 1.0) * c.friction_force;
    now.anchor.col(column) = now.X_PO.inverse() * iterate.node_position(k);
  }
  // Push and springs, and the relaxation over the step.
  now.push = iterate.push;
  now.uses_skin_springs = iterate.springs.has_value();
  now.spring_energy = iterate.springs ? iterate.springs->energy() : 0;
  if (iterate.springs && !iterate.node_stiffness.empty())
    now.spring_stiffness = iterate.node_stiffness;
  now.history = iterate.body.advance_history(iterate.body.node_displacements(now.x, {}),
                                             iterate.goal.time, iterate.start.history);
  return now;
}

/// Nodes that touch, by how they do.
TouchingNodes touching_nodes(const PressState& state, double friction) {
  TouchingNodes out;
  out.friction_ratio.resize(3, state.normal_force.size());
  for (Eigen::Index k = 0; k < state.normal_force.size(); ++k) {
    if (state.normal_force[k] <= 0) continue;
    out.friction_ratio.col(static_cast<Eigen::Index>(out.nodes.size())) =
        state.friction_force.col(k) / state.normal_force[k];
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
  require(state.x.size() == body.unknowns() && state.normal_force.size() == nodes &&
              state.friction_force.cols() == nodes && state.anchor.cols() == nodes &&
              has_springs_of(state, surface),
          "a state of {} unknowns and {} nodes does not fit a body of {} and {}", state.x.size(),
          state.normal_force.size(), body.unknowns(), nodes);
  // The state changes only if the step is solved.
  PressIterate iterate({body, surface, object, goal, options, state}, factors);
  PressOutcome out = solve(iterate);
  if (out.status == Status::kSolved) state = finish(iterate);
  return out;
}

Eigen::Matrix<double, 6, 6> press_stiffness(const TissueBody& body, const ContactSurface& surface,
                                            const RigidObject& object, const PressOptions& options,
                                            PressFactors& factors, const PressState& state) {
  require(state.x.size() == body.unknowns() &&
              state.normal_force.size() == static_cast<Eigen::Index>(surface.nodes.size()) &&
              has_springs_of(state, surface),
          "a state of {} unknowns does not fit a body of {}", state.x.size(), body.unknowns());
  PressGoal here;
  here.X_PO = state.X_PO;
  // Tissue at the state, with no time to relax.
  PressIterate iterate({body, surface, object, here, options, state}, factors);
  iterate.body.evaluate(body.node_displacements(iterate.state.x, {}), 0, state.history,
                        iterate.state.pressure, ElementRequest::kStiffness, iterate.tissue);
  if (iterate.tissue.inverted) return Eigen::Matrix<double, 6, 6>::Zero();
  if (state.uses_skin_springs) return spring_press_stiffness(iterate);
  // Contacts of nodes on the body, whose compliance is found for the nodes that touch.
  iterate.gaps.update(*object.shape, iterate.state.X_PO, iterate.state.x);
  const TouchingNodes touching = touching_nodes(iterate.state, object.friction);
  if (touching.nodes.empty() || !factors.tangent.factor(iterate.tissue.tangent))
    return Eigen::Matrix<double, 6, 6>::Zero();
  return contact_stiffness(
      factors.tangent, surface, iterate.gaps, touching,
      deformed_positions(surface, iterate.state.x),
      iterate.gaps.nodal_forces(iterate.state.normal_force) + iterate.state.friction_force);
}

}  // namespace thenar
