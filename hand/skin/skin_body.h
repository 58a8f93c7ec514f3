#pragma once

/// The flesh of every link of a hand, as lumps.

#include <map>
#include <string>

#include "hand/skin/hand_anatomy.h"
#include "hand/skin/soft_body.h"

namespace thenar {

/// Flesh of every segment that has any, at the reference posture. Neighbours overlap in a ball
/// about the joint between them, so that no gap opens as it turns.
///
/// Sections have the area that the subject's radius says. That a section is 1.08 (joints) to 1.25
/// (fingertips) times as broad as deep, that the tip tapers to 0.7 of its radius, how far the pad
/// bulges and how eminences and webs lie on the palm are priors, chosen by eye.
[[nodiscard]] std::map<std::string, SoftBody> skin_bodies(const HandAnatomy& hand);

}  // namespace thenar
