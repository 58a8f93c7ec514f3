#pragma once

/// Flesh of every link of a hand, as implicit bodies.

#include <map>
#include <string>

#include "hand/skeleton.h"
#include "hand/skin/hand_anatomy.h"
#include "hand/skin/implicit_body.h"

namespace thenar {

/// Builds the flesh of every segment that has any, at the reference posture. Neighbours overlap in
/// a ball about the joint between them, so that no gap opens as it turns.
///
/// Sections have the area of the subject's radius. The following are assumptions, chosen by eye: a
/// section is 1.08 (joints) to 1.25 (fingertips) times as broad as deep, the tip tapers to 0.7 of
/// its radius, and the bulge of the pad and the shapes of eminences and webs of the palm.
[[nodiscard]] std::map<std::string, ImplicitBody> skin_bodies(const HandAnatomy& hand);

// Mass of a hand's links from their skin.

/// Computes mass, centre and inertia of every segment of `bodies`, filled with tissue of
/// kHandDensity, at the reference posture. Where two neighbours overlap at their joint, flesh
/// belongs to the side of the joint's centre on which it lies, so that nothing counts twice.
///
/// Integrated over cells of 1/80 of the body's box, of which those at the skin count in part; the
/// volume of a ball is accurate to 0.2 %.
[[nodiscard]] std::map<std::string, LinkMass> skin_masses(
    const HandAnatomy& hand, const std::map<std::string, ImplicitBody>& bodies);

/// Returns the subject with skin masses where it states neither mass nor a radius for a capsule.
[[nodiscard]] Subject with_skin_masses(Subject subject);

}  // namespace thenar
