#pragma once

/// Bodies, joints and joint axes of one digit in a live view.

#include <string>
#include <vector>

#include "data/io/subject.h"
#include "live/live_picture.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Shapes that represent the bones of a digit.
enum class DigitLook {
  kAnatomy,  // bones and skin of the subject; capsules if its anatomy is not known
  kCapsules  // capsules from axis to axis to the tip, for digits that are not of the subject's size
};

/// Bodies and joints of one digit. In the picture the digit points along x (distal), with its
/// dorsal side along z (up).
struct DigitBodies {
  std::vector<LiveBody> bodies;       // at least one for each link; it may have no mesh
  std::vector<int> links;             // link that carries each body; -1: the base (bodies)
  std::vector<LiveJoint> joints;      // one for each hinge
  Pose<double> X_WS;                  // pose of the subject's frame in the picture: a rotation
  std::vector<std::string> warnings;  // reasons why capsules replace bones
};

/// Builds the bodies and joints of a digit.
/// @param name   name of the digit
/// @param digit  model of that digit: the subject's own, or one with other joint axes
[[nodiscard]] DigitBodies digit_bodies(const Subject& subject, const std::string& name,
                                       const TendonDigit& digit, DigitLook look);

/// Returns the poses of the bodies in the picture (bodies).
/// @param state  poses of the digit's links in the subject's frame
[[nodiscard]] std::vector<Pose<double>> body_poses(const DigitBodies& bodies,
                                                   const TreeState<double>& state);

/// Returns the angles of all hinges, including those that follow a coordinate [rad] (hinges).
/// @param q  posture [rad] (coordinates)
[[nodiscard]] std::vector<double> hinge_angles(const TendonModel<double>& model,
                                               const Eigen::VectorXd& q);

/// Returns one arrow for each joint axis; axis_vectors() places them.
/// @param names  names of the hinges
[[nodiscard]] std::vector<LiveArrow> axis_arrows(const std::vector<std::string>& names);
/// Computes the vectors of axis_arrows() in the picture, each centred on the bone.
/// @param state  poses of the digit's links in the subject's frame
[[nodiscard]] std::vector<LiveVector> axis_vectors(const DigitBodies& bodies,
                                                   const TendonModel<double>& model,
                                                   const TreeState<double>& state);

/// Sets the camera of `shape` to see the whole digit from the side and a little from above.
/// @param state  poses of the digit's links in the initial posture, subject's frame
void aim_at_digit(const DigitBodies& bodies, const TendonModel<double>& model,
                  const TreeState<double>& state, LiveShape& shape);

}  // namespace thenar
