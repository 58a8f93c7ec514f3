#pragma once

/// Mass of a hand's links from their skin.

#include <map>
#include <string>

#include "hand/skeleton.h"
#include "hand/skin/hand_anatomy.h"
#include "hand/skin/skin_body.h"

namespace thenar {

/// Mass, centre and inertia of every segment of `bodies`, filled with tissue of kHandDensity, at
/// the reference posture. Where two neighbours overlap at their joint, flesh belongs to the side of
/// the joint's centre on which it lies, so that nothing counts twice.
///
/// Integrated over cells of 1/80 of the body's box, of which those at the skin count in part; the
/// volume of a ball comes out within 0.2 %.
[[nodiscard]] std::map<std::string, LinkMass> skin_masses(
    const HandAnatomy& hand, const std::map<std::string, SoftBody>& bodies);

/// The subject with skin masses where it states none (and no radius to make a capsule of).
[[nodiscard]] Subject with_skin_masses(Subject subject);

}  // namespace thenar
