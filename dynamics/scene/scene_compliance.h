#pragma once

/// Builds compliant joints, bushings and ligaments from a scene file.

#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/ligament/bushing.h"
#include "dynamics/ligament/compliant_joint.h"

namespace thenar {

/// Returns the joint compliance of a [[compliance]].
[[nodiscard]] JointCompliance joint_compliance(const SceneComplianceSpec& spec);

/// Makes joints of one body or hand of a scene compliant, as its file says.
/// @param name    name of the body or hand
/// @param prefix  "HAND/" for a hand, empty for a body
/// @param part    its mechanism, changed: new coordinates are appended and are 0 at the start
/// @return the compliant joints, with coordinate indices of `part`
/// @throws DataError at the line of the file for the errors of make_compliant()
[[nodiscard]] std::vector<CompliantJoint> make_part_compliant(const SceneSpec& spec,
                                                              const std::string& name,
                                                              const std::string& prefix,
                                                              Mechanism& part);

/// Builds the bushings and ligaments of a scene. A ligament without a stated slack length is just
/// taut at the start.
/// @param X_WB  initial poses of the bodies (bodies)
/// @throws DataError at the line of the file if a body does not exist or an element is invalid
[[nodiscard]] std::vector<std::shared_ptr<const ForceElement>> build_scene_ligaments(
    const SceneSpec& spec, const Mechanism& mechanism, const std::vector<Pose<double>>& X_WB);

}  // namespace thenar
