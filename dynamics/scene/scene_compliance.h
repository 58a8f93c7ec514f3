#pragma once

/// Joints of a scene that give and its ligaments, from its file.

#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/ligament/bushing.h"
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

/// Bushings and ligaments of a scene; without a slack length ligaments are just taut at the start.
/// @param X_WB  bodies at the start (bodies)
/// @throws DataError at the line of the file, where a body is not there or both ends are one
[[nodiscard]] std::vector<std::shared_ptr<const ForceElement>> scene_ligaments(
    const SceneSpec& spec, const Mechanism& mechanism, const std::vector<Pose<double>>& X_WB);

}  // namespace thenar
