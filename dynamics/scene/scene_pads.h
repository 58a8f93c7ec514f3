#pragma once

/// Adds finger pads to a scene.

#include <optional>
#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/scene/scene_humans.h"

namespace thenar {

/// Pose and scale of a pad on its body.
struct PadPlace {
  Pose<double> X_BP;  // pose of the pad in the body's frame
  double scale = 1;   // size over that of the pad model [1]
};
/// Places a pad on a fingertip by skin_patches(): x along the digit, z outward, the top of the pad
/// in the middle of the patch, scaled to the breadth of the patch: scale = 2 half_breadth / width.
/// @param link   name of the fingertip's link, without that of the hand: "DP2"
/// @param scale  scale that replaces the one of the patch
/// @throws InputError if the link is not a fingertip.
[[nodiscard]] PadPlace fingertip_pad_place(const HumanMechanism& hand, const std::string& link,
                                           const PadSpec& pad, std::optional<double> scale);

/// Adds a PadElement for each body that presses on a pad, and excludes other contacts of the pair.
/// Pads of the rung "hard-point" add no element.
/// @param built  scene with a complete mechanism, before set_pairs()
/// @throws DataError at the line of the pad if a body does not exist or has no shape, a link that
/// is not a fingertip has a pad without a position, two bodies are welded to each other, or the
/// pad's numbers are invalid.
void add_pads(const SceneSpec& spec, const std::vector<SceneHuman>& humans, BuiltScene& built);

/// Sets the friction of the rigid contacts of "hard-point" pads to the value of their [[pad]].
/// @param built  scene after set_pairs()
void set_hard_point_friction(const SceneSpec& spec, BuiltScene& built);

}  // namespace thenar
