#pragma once

/// Builds the bodies and hands of a scene file as separate mechanisms.

#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/mechanism/mechanism.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/scene/scene_compliance.h"
#include "dynamics/scene/scene_humans.h"

namespace thenar {

/// Body or hand of the file, before it is added to the mechanism of the scene.
struct ScenePart {
  Mechanism mechanism;             // its bodies and joints, in the world of the scene
  std::string name;                // name in the file
  std::string prefix;              // prefix of names of its bodies and coordinates
  std::vector<Pose<double>> X_WB;  // initial poses (bodies)
  std::vector<double> u, u_dot;    // initial coordinates and rates [rad] or [m] (coordinates)
  SceneJointSpec joint;            // joint of its first body
  SceneVelocity velocity;          // initial velocity, of a free joint
  std::vector<CompliantJoint> compliant;  // compliant joints, with coordinate indices of the part
};

/// Parts of a scene: hands, then bodies, in the order of the file.
struct SceneParts {
  std::vector<ScenePart> parts;
  std::vector<SceneHuman> humans;     // human hands among the parts
  std::vector<std::string> warnings;  // assumptions, and features that are left out
};

/// Builds every body and hand in its initial state, on its joint. A motor that is not backdrivable
/// and has no drive is welded at its initial position.
/// @param hands  models of the hands, in the order of the file
/// @throws InputError if the numbers of models and hands differ; DataError at the line of a hand or
/// body that cannot be built.
[[nodiscard]] SceneParts build_scene_parts(const SceneSpec& spec,
                                           const std::vector<SceneHand>& hands);

}  // namespace thenar
