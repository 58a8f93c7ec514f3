#pragma once

/// Body, contacts and goal of one step of a press.

#include "pads/contact_cones.h"
#include "pads/contact_surface.h"
#include "pads/press_goal.h"
#include "pads/press_state.h"
#include "pads/tissue_body.h"

namespace thenar {

/// Factored tangents of a body, kept as workspace from step to step.
struct PressFactors {
  explicit PressFactors(const TissueBody& body) : tangent(body), cones(body) {}
  CondensedBody tangent;  // tangent of the current iteration, with or without contacts
  ContactCones cones;     // tangent that press_by_cones() reuses over several steps
};

/// Data of one step: body, object, goal, options and start.
struct PressProblem {
  const TissueBody& body;
  const ContactSurface& surface;
  const RigidObject& object;
  const PressGoal& goal;
  const PressOptions& options;
  const PressState& start;
};

}  // namespace thenar
