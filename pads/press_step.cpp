#include "pads/press_step.h"

#include <cmath>

#include "base/error.h"
#include "pads/press_cones.h"
#include "pads/press_iterate.h"
#include "pads/press_newton.h"
#include "pads/press_springs.h"

namespace thenar {
namespace {

// Largest number of touching nodes for which exact cones cost less than Newton's method
constexpr int kMaxConeNodes = 60;

/// Counts nodes that touch, or that the object at its goal overlaps.
int count_touching_nodes(PressIterate& iterate) {
  iterate.gaps.update(*iterate.object.shape, iterate.state.X_PO, iterate.state.x);
  int count = 0;
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    if (iterate.state.normal_force[k] > 0 || iterate.gaps.gap(k) < 0) ++count;
  return count;
}

/// Solves a step by the method that suits its contact.
PressOutcome solve(PressIterate& iterate) {
  // Use springs where an edge lies over the skin.
  if (has_edge_nearby(iterate.surface, *iterate.object.shape, iterate.start.X_PO,
                      iterate.start.x) ||
      has_edge_nearby(iterate.surface, *iterate.object.shape, iterate.goal.X_PO, iterate.start.x))
    return press_by_springs(iterate);
  // Use Newton's method without friction or with many contacts, otherwise exact cones.
  const bool augments =
      iterate.object.friction <= 0 || count_touching_nodes(iterate) > kMaxConeNodes;
  PressOutcome out = augments ? press_by_newton(iterate) : press_by_cones(iterate);
  if (out.status == Status::kSolved || out.status == Status::kStopped) return out;
  // If that fails, start again with the other method.
  const int iterations = out.iterations;
  iterate.reset_to_start();
  out = augments ? press_by_cones(iterate) : press_by_newton(iterate);
  out.iterations += iterations;
  return out;
}

/// Returns the state at the end of a solved step.
PressState final_state(PressIterate& iterate) {
  PressState& state = iterate.state;
  // Copy the forces of the nodes, and anchor them to the object.
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k) {
    const SkinNodeContact& c = iterate.contacts[k];
    state.normal_force[k] = c.normal_force;
    // Friction may exceed its cone by the tolerance.
    const double bound = iterate.object.friction * c.normal_force, size = c.friction_force.norm();
    state.friction_force.col(k) = (size > bound ? bound / size : 1.0) * c.friction_force;
    state.anchor.col(k) = state.X_PO.inverse() * iterate.node_position(k);
  }
  // Copy the wrench and the springs, and advance the relaxation over the step.
  state.push = iterate.push;
  state.uses_skin_springs = iterate.springs.has_value();
  state.spring_energy = iterate.springs ? iterate.springs->energy() : 0;
  if (iterate.springs && !iterate.node_stiffness.empty())
    state.spring_stiffness = iterate.node_stiffness;
  state.history = iterate.body.advance_history(iterate.body.node_displacements(state.x, {}),
                                               iterate.goal.time, iterate.start.history);
  return state;
}

/// Lists the touching nodes of a state with their friction.
TouchingNodes touching_nodes(const PressState& state, double friction) {
  TouchingNodes out;
  out.friction_ratio.resize(3, state.normal_force.size());
  for (Eigen::Index k = 0; k < state.normal_force.size(); ++k) {
    if (state.normal_force[k] <= 0) continue;
    out.friction_ratio.col(out.nodes.size()) = state.friction_force.col(k) / state.normal_force[k];
    out.nodes.push_back(static_cast<int>(k));
    out.sticks.push_back(node_sticks(state, k, friction));
  }
  return out;
}

/// Returns whether a state has no springs, or one for each surface node.
bool springs_match(const PressState& state, const ContactSurface& surface) {
  return state.spring_stiffness.empty() || state.spring_stiffness.size() == surface.nodes.size();
}

}  // namespace

PressOutcome press_step(const TissueBody& body, const ContactSurface& surface,
                        const RigidObject& object, const PressGoal& goal,
                        const PressOptions& options, PressFactors& factors, PressState& state) {
  const auto nodes = static_cast<Eigen::Index>(surface.nodes.size());
  // Check the object and the goal, and that the state fits the body.
  require(object.shape != nullptr, "an object without a shape presses on nothing");
  require(object.friction >= 0 && std::isfinite(object.friction),
          "friction must be finite and >= 0, got {}", object.friction);
  require(goal.X_PO.p.allFinite() && goal.X_PO.R.allFinite(), "a goal's pose is not finite");
  require(goal.time >= 0, "a step takes 0 s or more, got {}", goal.time);
  require(!goal.force || (std::isfinite(*goal.force) && *goal.force > 0),
          "a force to reach must be above 0, got {} N", goal.force.value_or(0));
  require(!goal.force || std::abs(goal.along.norm() - 1) < 1e-9,
          "the direction of a force is not a unit vector");
  require(nodes > 0, "a body has no surface that may touch");
  require(state.x.size() == body.unknowns() && state.normal_force.size() == nodes &&
              state.friction_force.cols() == nodes && state.anchor.cols() == nodes &&
              springs_match(state, surface),
          "a state of {} unknowns and {} nodes does not fit a body of {} and {}", state.x.size(),
          state.normal_force.size(), body.unknowns(), nodes);
  // Solve the step; the state changes only on success.
  PressIterate iterate({body, surface, object, goal, options, state}, factors);
  PressOutcome out = solve(iterate);
  if (out.status == Status::kSolved) state = final_state(iterate);
  return out;
}

Eigen::Matrix<double, 6, 6> press_stiffness(const TissueBody& body, const ContactSurface& surface,
                                            const RigidObject& object, const PressOptions& options,
                                            PressFactors& factors, const PressState& state) {
  require(state.x.size() == body.unknowns() &&
              state.normal_force.size() == static_cast<Eigen::Index>(surface.nodes.size()) &&
              springs_match(state, surface),
          "a state of {} unknowns does not fit a body of {}", state.x.size(), body.unknowns());
  PressGoal here;
  here.X_PO = state.X_PO;
  // Compute the tangent of the tissue at the state, without relaxation.
  PressIterate iterate({body, surface, object, here, options, state}, factors);
  iterate.body.evaluate(body.node_displacements(iterate.state.x, {}), 0, state.history,
                        iterate.state.pressure, ElementRequest::kStiffness, iterate.tissue);
  if (iterate.tissue.inverted) return Eigen::Matrix<double, 6, 6>::Zero();
  if (state.uses_skin_springs) return spring_press_stiffness(iterate);
  // Condense the body to the touching nodes, and move the object against them.
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
