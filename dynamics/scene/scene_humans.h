#pragma once

/// Human hands of a scene: their posture at the start, and what pulls them.

#include <string>
#include <vector>

#include "data/io/scene/scene.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {

/// A human hand of a scene.
struct SceneHuman {
  std::string name;  // of the file
  HumanMechanism hand;
};

/// Coordinates of a hand at the start; what the file does not name stands where closing begins.
/// @throws InputError if it has no such joint, or an angle is beyond the joint's range.
[[nodiscard]] std::vector<double> human_posture(const SceneHandSpec& spec,
                                                const HumanMechanism& hand);

/// Adds stops and pulls of all human hands; warns of hands that nothing moves.
/// @param built  its mechanism is complete
/// @throws DataError at the line of the file that names what is not there.
void add_human_elements(const SceneSpec& spec, const std::vector<SceneHuman>& humans,
                        BuiltScene& built);

/// Keeps links of a human hand apart that joints hang on the same link, the roots of its digits on
/// the palm: the flesh between them is one web, and gives way. Rigid skin of such a root would be a
/// wedge between its neighbour and the palm, from which the neighbour's joint lets nothing escape.
/// Farther links of two digits may touch.
/// @param built  its mechanism is complete
void part_webs(const std::vector<SceneHuman>& humans, BuiltScene& built);

}  // namespace thenar
