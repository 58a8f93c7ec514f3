#pragma once

/// Joints of a scene that give, and ligaments on lines, as plain data.

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/toml_table.h"

namespace thenar {

/// Compliance of a hinge in the ways beside flexion, which is the hinge's own.
struct SceneComplianceSpec {
  enum Way { kAcross, kAlong, kAxial, kAbduction, kTwist };

  std::string joint;                    // joint of a body on a hinge, or "HAND/JOINT"
  std::optional<Eigen::Vector3d> bone;  // direction of the distal bone, body's frame (3); absent:
                                        // from the joint to the centre of mass
  std::array<double, 5> stiffness;      // stiffness at rest [N/m], [N m/rad]; infinite: rigid
  std::array<double, 5> damping{};      // [N s/m], [N m s/rad]
  double translation_toe = std::numeric_limits<double>::infinity();  // [m]
  double rotation_toe = std::numeric_limits<double>::infinity();     // [rad]
  double twist_toe = std::numeric_limits<double>::infinity();        // toe of the twist alone [rad]
  double stiffening = 20;    // largest stiffness over that at rest [1]
  double twist_follows = 0;  // twist at rest over flexion [1]
  int line = 1;              // line in the file
};

/// A ligament between points of two bodies.
struct SceneLigamentSpec {
  std::string name;
  std::string from, to;                 // body, or "HAND/LINK"; empty `from`: the world
  Eigen::Vector3d from_point{0, 0, 0};  // attachment in the frame of `from` [m] (3)
  Eigen::Vector3d to_point{0, 0, 0};    // attachment in the frame of `to` [m] (3)
  double stiffness = 0;                 // force per strain of the straight part [N]
  std::optional<double> slack_length;   // [m]; absent: that at the start
  double toe_strain = 0.03;             // [1]
  double damping = 0;                   // [s]
  int line = 1;                         // line in the file
};

namespace internal {

/// Springs of a capsule's ways by 'translation' or 'rotation', with '.._damping' and '.._toe'.
struct SpringKeys {
  std::vector<double> stiffness;  // stiffness at rest [N/m] or [N m/rad] (ways)
  double damping = 0;             // [N s/m] or [N m s/rad]
  double toe = std::numeric_limits<double>::infinity();  // [m] or [rad]
};
/// @param name  "translation" or "rotation", of so many `ways`;  @param range  of the stiffness
[[nodiscard]] SpringKeys read_springs(TomlTable& table, const std::string& name, int ways,
                                      Range range);
/// Returns the dimension of the stiffness of "translation" or "rotation".
[[nodiscard]] Dimension spring_dimension(const std::string& name);
/// Reads 'stiffening', a number of springs with a toe. @param usual  where it is not stated
[[nodiscard]] double read_stiffening(TomlTable& table, bool has_toe, double usual);

/// Reads [[compliance]].
[[nodiscard]] SceneComplianceSpec read_scene_compliance(TomlTable& table);
/// Reads [[ligament]].
[[nodiscard]] SceneLigamentSpec read_scene_ligament(TomlTable& table);

}  // namespace internal
}  // namespace thenar
