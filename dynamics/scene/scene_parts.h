#pragma once

/// Bodies and hands of a scene file, each a mechanism by itself.

#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/mechanism/mechanism.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/scene/scene_compliance.h"
#include "dynamics/scene/scene_humans.h"

namespace thenar {

/// Body or hand of the file as it enters the mechanism of the scene.
struct ScenePart {
  Mechanism mechanism;             // its world is the scene's
  std::string name, prefix;        // of the file; before names of bodies and coordinates
  std::vector<Pose<double>> X_WB;  // of its bodies at the start
  std::vector<double> u, u_dot;    // of its coordinates at the start
  SceneJointSpec joint;            // of its first body
  SceneVelocity velocity;
  std::vector<CompliantJoint> compliant;  // coordinates are the part's
};

/// All parts of a scene, hands first, each in the order of the file.
struct SceneParts {
  std::vector<ScenePart> parts;
  std::vector<SceneHuman> humans;
  std::vector<std::string> warnings;  // what was assumed, and what is left out
};

/// Builds every body and hand by itself, where it is at the start, on its joint.
///
/// A motor that holds by itself and that nothing drives is welded where it stands.
/// @param hands  models of the hands, in their order
/// @throws InputError if there are not as many models as hands; DataError at the line of a hand or
/// body that cannot be built.
[[nodiscard]] SceneParts scene_parts(const SceneSpec& spec, const std::vector<SceneHand>& hands);

}  // namespace thenar
