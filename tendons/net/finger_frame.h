#pragma once

/// Bones of one finger by role, with the directions and scales for placing a net on them.

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/net_description.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Bone of a finger, at the reference posture.
struct FingerBone {
  std::string segment;
  int link = -1;
  // Ends of its line: joint centres or the tip [m] (3).
  Eigen::Vector3d proximal{0, 0, 0}, distal{0, 0, 0};
  Eigen::Vector3d along{0, 0, 0};                    // unit direction towards proximal (3)
  Eigen::Vector3d dorsal{0, 0, 0}, radial{0, 0, 0};  // unit directions square to `along` (3)
  double length = 0;                                 // length of the line [m]
  double ratio[2] = {1, 1};  // ratio of the extensor's height to that in the net's reference
                             // finger, at the proximal and distal end [1]
};

/// Geometry of a finger on which a net is built.
struct FingerFrame {
  std::array<FingerBone, 4> bones;  // bones by BoneRole
  // Height of the extensor over the joints' axes, by FingerJoint [m].
  std::array<double, 3> height{};
  Eigen::VectorXd straight;  // posture in which the bones' lines are parallel [rad]
  double scale = 1;          // length of the phalanges over that of the reference finger [1]

  /// Returns the bone with a role.
  [[nodiscard]] const FingerBone& bone(BoneRole role) const {
    return bones[static_cast<std::size_t>(role)];
  }
};

/// Finds the bones by walking up the joints from the tip.
///
/// A joint's centre is the point of its flexion axis nearest to the extensor's run over it; the
/// dorsal direction of a bone is square to its line and to the mean of the flexion axes at its
/// ends. The height of the extensor over a joint is the distance between run and axis in the
/// straight finger. The metacarpal has the direction of the extensor's points on it; failing these,
/// its segment's; failing that, the digit's.
/// @throws InputError naming what is missing: a joint, an extensor, a run across a joint.
[[nodiscard]] FingerFrame finger_frame(const Subject& subject, const TendonDigit& digit,
                                       const NetDescription& description);

/// Builds the reference finger of the description's lengths: straight along -x with dorsal y, all
/// bones on the base.
[[nodiscard]] FingerFrame reference_finger(const NetDescription& description);

/// Interpolates the ratio of the extensor's height to that in the reference finger along a bone
/// [1].
/// @param along  position along the bone, 0 at its proximal end and 1 at its distal one
[[nodiscard]] double height_ratio(const FingerBone& bone, double along);

/// Computes the position of a place of the description in the reference posture [m] (3).
[[nodiscard]] Eigen::Vector3d place_position(const FingerFrame& frame, const NetPlace& place);

/// Computes the unit vector at `angle` about a bone: 0 dorsal, +90 degrees radial (3).
[[nodiscard]] Eigen::Vector3d direction_around(const FingerBone& bone, double angle);

/// Returns the strand that a muscle of the subject pulls. @throws InputError if there is none.
[[nodiscard]] const Strand& pulled_strand(const Subject& subject, const std::string& muscle);

/// Returns the first of the named strands that crosses a joint of the digit, or null.
[[nodiscard]] const Strand* find_strand(const Subject& subject, const TendonDigit& digit,
                                        const std::vector<std::string>& names);

/// Returns the names of the digit's muscles that have a role, in the digit's order.
[[nodiscard]] std::vector<std::string> muscles_of(const TendonDigit& digit,
                                                  const NetMusclePlan& role);

}  // namespace thenar
