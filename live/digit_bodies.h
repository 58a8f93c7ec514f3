#pragma once

/// Bones, skin, joints and axes of one digit as a live view shows them.

#include <string>
#include <vector>

#include "data/io/subject.h"
#include "live/live_picture.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Shapes that stand for the bones of a digit.
enum class DigitLook {
  kAnatomy,  // bones and skin of the subject; capsules where its anatomy is not known
  kCapsules  // from axis to axis to the tip: of digits that are not of the subject's size
};

/// The bodies of one digit in its picture, where its distal direction points along x and its dorsal
/// one up, along z.
struct DigitBodies {
  std::vector<LiveBody> bodies;       // every link has at least one, which may have no mesh
  std::vector<int> links;             // that carry them; -1: the base (bodies)
  std::vector<LiveJoint> joints;      // of every hinge
  Pose<double> X_WS;                  // the subject's frame in the picture: a rotation
  std::vector<std::string> warnings;  // where capsules stand for bones
};

/// @param name   of the digit
/// @param digit  that moves: a digit of the subject, or one with other axes
[[nodiscard]] DigitBodies digit_bodies(const Subject& subject, const std::string& name,
                                       const TendonDigit& digit, DigitLook look);

/// Poses of the bodies in the picture. @param state  links of the digit, subject's frame
[[nodiscard]] std::vector<Pose<double>> body_poses(const DigitBodies& bodies,
                                                   const TreeState<double>& state);

/// Angles of all hinges, those that are led as well [rad] (hinges). @param q  [rad] (coordinates)
[[nodiscard]] std::vector<double> hinge_angles(const TendonModel<double>& model,
                                               const Eigen::VectorXd& q);

/// An arrow along every axis, half of it to either side of the bone.
/// @param names  of the hinges
[[nodiscard]] std::vector<LiveArrow> axis_arrows(const std::vector<std::string>& names);
/// Computes the vectors of axis_arrows() at a posture, in the picture.
[[nodiscard]] std::vector<LiveVector> axis_vectors(const DigitBodies& bodies,
                                                   const TendonModel<double>& model,
                                                   const TreeState<double>& state);

/// Places the camera so that it sees the whole digit from the side that `shape` has in front.
/// @param state  links of the digit at the posture at first
void aim_at_digit(const DigitBodies& bodies, const TendonModel<double>& model,
                  const TreeState<double>& state, LiveShape& shape);

}  // namespace thenar
