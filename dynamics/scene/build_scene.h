#pragma once

/// Moving scenes from their files.

#include <string>
#include <variant>
#include <vector>

#include "data/io/robot/robot.h"
#include "data/io/scene/scene.h"
#include "dynamics/human/human_mechanism.h"
#include "dynamics/stepping/moving_scene.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// A scene ready to be simulated.
struct BuiltScene {
  MovingScene scene;
  SceneOptions options;
  std::vector<std::string> owner;  // of each body of the mechanism: the body or hand of the file
  std::vector<std::string> force_names, drive_names;  // as the file has them, in its order
  std::vector<std::string> warnings;                  // what was assumed
  int pads = 0;                                       // elements of [[pad]], each for one pair
};

/// Model from which a hand of a scene is built.
using SceneHand = std::variant<RobotSpec, HumanModel>;

/// Builds a scene at its start.
///
/// Joints carry bodies that stand where the file puts them: with A the frame whose z is the axis
/// and s the value at the start,  F = A motion(-s),  M = A.  Links of a hand are called HAND/LINK,
/// its coordinates HAND/MOTOR, or HAND/JOINT where no motor moves the joint; a base that moves has
/// the coordinate HAND/base. A motor that cannot be driven back and that nothing drives is welded.
/// Links of one hand that are in each other at the start, or with all coordinates at 0, are never
/// asked for contacts; nor are those of a human hand that hang on one link, as part_webs() says.
/// Coordinates of a human hand are called HAND/JOINT; its elements are JointStops, and a DigitPull
/// for each digit that a [[tendon]] or [[muscle]] pulls. In a digit of which a [[muscle]] excites
/// one muscle all muscles contract, the others at excitation 0, but for those with a tension; so do
/// those of digits that share such a muscle with it, which are one DigitPull with it.
/// Pads are PadElements, as add_pads() says; bodies that meet one are apart, but for it.
/// The friction of a pair is that of its [[friction]]; else that of the [[friction]] for all; else
/// the static one of its materials.
/// @param hands  of the scene, in their order
/// @throws DataError at the line of the file where parts do not fit together.
[[nodiscard]] BuiltScene build_scene(const SceneSpec& spec, const std::vector<SceneHand>& hands);

/// Changes one number of a scene:
///   friction       coefficient of all pairs [1]; refused where pads have their own
///   mass/BODY      [kg], the inertia with it
///   force/NAME     length of the force [N], or of the moment where there is no force [N m]
///   drive/NAME     size of its effort, which keeps its sense [N] or [N m]
///   step, longest  [s];  tolerance  [m] or [rad]
/// @throws InputError if the scene has no such number, or the value is impossible.
void set_number(BuiltScene& built, const std::string& name, double value);

}  // namespace thenar
