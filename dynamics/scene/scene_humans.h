#pragma once

/// Adds human hands to a scene: initial posture, joint stops, tendons and muscles.

#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {

/// Human hand of a scene.
struct SceneHuman {
  std::string name;     // name in the file
  HumanMechanism hand;  // its mechanism
};

/// Returns the initial coordinates of a hand [rad]; joints that the file does not name have the
/// open posture.
/// @throws InputError if a named joint does not exist, or an angle is beyond the joint's range.
[[nodiscard]] std::vector<double> human_posture(const SceneHandSpec& spec,
                                                const HumanMechanism& hand);

/// Adds the JointStops and DigitPulls of all human hands, and warns of hands without any drive.
/// @param built  scene with a complete mechanism
/// @throws DataError at the line of the file with an unknown name or invalid values.
void add_human_elements(const SceneSpec& spec, const std::vector<SceneHuman>& humans,
                        BuiltScene& built);

/// Excludes contacts between links of a human hand that are attached to the same link, such as the
/// proximal links of the digits on the palm. The web of flesh between them is soft; rigid skin
/// would wedge between the neighbour and the palm. More distal links of two digits keep their
/// contacts.
/// @param built  scene with a complete mechanism
void exclude_web_contacts(const std::vector<SceneHuman>& humans, BuiltScene& built);

}  // namespace thenar
