#pragma once

/// Builds moving scenes from the specifications of their files.

#include <string>
#include <variant>
#include <vector>

#include "data/io/robot/robot.h"
#include "data/io/scene/scene.h"
#include "dynamics/human/human_mechanism.h"
#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Scene that is ready to be simulated.
struct BuiltScene {
  MovingScene scene;
  SceneOptions options;
  std::vector<std::string> owner;  // body or hand of the file that each body belongs to (bodies)
  std::vector<std::string> force_names, drive_names;  // names in the order of the file
  std::vector<std::string> warnings;                  // assumptions that were made
  int pads = 0;                                       // number of PadElements, one for each pair
};

/// Model from which a hand of a scene is built.
using SceneHand = std::variant<RobotSpec, HumanModel>;

/// Builds a scene in its initial state.
///
/// Joints. Bodies start at the pose that the file states. Let A be the frame whose z is the joint
/// axis, and s the initial value. The joint then has the frames  F = A motion(-s)  in the parent
/// and  M = A  in the body. A motor that is not backdrivable and has no drive is welded.
///
/// Names. Links of a hand are named HAND/LINK, its coordinates HAND/MOTOR, or HAND/JOINT for joints
/// without a motor and for human hands; a moving base has the coordinate HAND/base.
///
/// Contacts. Two links of one hand have no contacts if they overlap at the start or with all
/// coordinates at 0, or as exclude_web_contacts() says. The friction of a pair is that of its own
/// [[friction]], else that of the [[friction]] for all pairs, else the static one of its materials.
/// Bodies of a PadElement have no other contacts with each other, see add_pads().
///
/// Human hands. Their elements are JointStops, and a DigitPull for each digit that a [[tendon]] or
/// [[muscle]] pulls. If a [[muscle]] excites one muscle of a digit, all its muscles without a given
/// tension contract, the others at excitation 0; digits that share such a muscle contract too and
/// become one DigitPull.
/// @param hands  models of the scene's hands, in the order of the file
/// @throws DataError at the line of the file where parts do not fit together.
[[nodiscard]] BuiltScene build_scene(const SceneSpec& spec, const std::vector<SceneHand>& hands);

/// Changes one number of a scene:
///   friction       coefficient of all pairs [1]; refused where pads have their own
///   mass/BODY      mass [kg]; the inertia is scaled with it
///   force/NAME     magnitude of the force [N], or of the moment if there is no force [N m]
///   drive/NAME     magnitude of the effort, which keeps its sign [N] or [N m]
///   step, longest  [s];  tolerance  [m] or [rad]
/// @throws InputError if the scene has no such number, or the value is impossible.
void set_number(BuiltScene& built, const std::string& name, double value);

}  // namespace thenar
