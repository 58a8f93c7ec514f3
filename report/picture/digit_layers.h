#pragma once

/// A digit as layers of a 3D picture: bones, joint axes, tendons, forces.

#include "report/blocks.h"
#include "tendons/forces/feasible_force_set.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Returns the names of the x, y and z axes of a picture of a digit, for `axes` of the picture:
/// "proximal", "dorsal", "radial" or their opposites; empty where none is within 30 deg.
/// @param directions  columns proximal, dorsal, radial; length 0: not known (3, 3)
[[nodiscard]] Json axis_words(const Eigen::Matrix3d& directions);

/// Returns the coordinate axis, or its opposite, that is nearest to a direction.
[[nodiscard]] Eigen::Vector3d nearest_axis(const Eigen::Vector3d& direction);

/// Adds a bone from one place to another, unless they are the same. [m]
void add_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, Json& items);

/// Returns a layer of bones from joint to joint to the tip. @param q  posture [rad]
[[nodiscard]] Json bone_layer(const TendonDigit& digit, const Eigen::VectorXd& q,
                              const std::string& color);

/// Returns a layer of joint axes by name. @param length  length of each [m]
[[nodiscard]] Json axis_layer(const TendonDigit& digit, const Eigen::VectorXd& q,
                              const std::string& name, const std::string& color, double length,
                              bool labelled);

/// Returns one layer of all tendon paths as lines. Empty array of items if arms are constants.
[[nodiscard]] Json tendon_layer(const TendonDigit& digit, const Eigen::VectorXd& q,
                                const std::string& name, const std::string& color, bool labelled);

/// Returns a layer with the feasible force set at the tip, drawn at the scale `mm_per_N`.
[[nodiscard]] Json force_set_layer(const TendonDigit& digit, const Eigen::VectorXd& q,
                                   const FeasibleForceSet& set, double mm_per_N,
                                   const std::string& color);

/// Returns a scene of a digit, its back up. @param tip  proximal, dorsal and radial in columns (3 x
/// 3)
[[nodiscard]] Json digit_scene_block(const std::string& caption, const Eigen::Matrix3d& tip,
                                     Json layers);

}  // namespace thenar
