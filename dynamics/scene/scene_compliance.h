#pragma once

/// Joints of a scene that give, from its file.

#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/ligament/compliant_joint.h"

namespace thenar {

/// The law of a [[compliance]].
[[nodiscard]] JointCompliance joint_compliance(const SceneComplianceSpec& spec);

/// Makes joints of one body or hand of a scene compliant.
/// @param name    of the body; @param prefix  "HAND/" of a hand, else empty
/// @param part    its mechanism, changed: coordinates come at the end, all 0 at the start
/// @throws DataError at the line of the file, as make_compliant()
[[nodiscard]] std::vector<CompliantJoint> make_part_compliant(const SceneSpec& spec,
                                                              const std::string& name,
                                                              const std::string& prefix,
                                                              Mechanism& part);

}  // namespace thenar
