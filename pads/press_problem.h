#pragma once

/// Body, contacts and goal of one step of a press.

#include "pads/contact_cones.h"
#include "pads/contact_surface.h"
#include "pads/press_goal.h"
#include "pads/press_state.h"
#include "pads/tissue_body.h"

namespace thenar {

/// Tangents of a body that its steps factor.
struct PressFactors {
  explicit PressFactors(const TissueBody& body) : moment(body), cones(body) {}
  CondensedBody moment;  // of the moment, with contacts or without
  ContactCones cones;    // kept from step to step
};

/// Body, object and goal of a step.
struct PressProblem {
  const TissueBody& body;
  const ContactSurface& surface;
  const RigidObject& object;
  const PressGoal& goal;
  const PressOptions& options;
  const PressState& start;
};

}  // namespace thenar
