#pragma once

/// Finger pads of a scene.

#include <optional>
#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/scene/scene_humans.h"

namespace thenar {

/// Pose and scale of a pad on the fingertip of a digit, in the frame of the fingertip's link. The
/// pad is placed by skin_patches(): x along the digit, z outward, the skin's top in the middle of
/// the patch, with the breadth of the patch: scale = 2 half_breadth / width.
struct PadPlace {
  Pose<double> X_BP;
  double scale = 1;  // [1]
};
/// @param link  of the hand, without its name: "DP2"
/// @param scale  instead of that of the patch
/// @throws InputError if no digit ends there.
[[nodiscard]] PadPlace place_on_fingertip(const HumanMechanism& hand, const std::string& link,
                                          const PadSpec& pad, std::optional<double> scale);

/// Adds a PadElement for each body that presses on a pad, and keeps the pair apart; hard points add
/// nothing.
/// @param built  its mechanism is complete, its pairs are not set
/// @throws DataError at the line of the pad, where a body is not there or has no shape, a link that
/// is no fingertip has a pad without a place, two bodies are welded to each other, or a pad makes
/// no sense.
void add_pads(const SceneSpec& spec, const std::vector<SceneHuman>& humans, BuiltScene& built);

/// Gives the rigid contacts of hard points the friction that their pads state.
/// @param built  its pairs are set
void set_hard_points(const SceneSpec& spec, BuiltScene& built);

}  // namespace thenar
