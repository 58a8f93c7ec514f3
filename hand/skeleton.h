#pragma once

/// Bones and hinges of a subject, reduced to the selected digits.

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"
#include "hand/chain.h"

namespace thenar {

/// Options of a skeleton: the part of the subject to build. Segments across a frozen joint are
/// welded.
struct SkeletonOptions {
  std::vector<std::string> digits;       // digits to keep; empty: all
  std::map<std::string, double> frozen;  // joint -> the angle it is frozen at [rad]
};

/// Passive moment at the two ends of one hinge's range; the hinge's angle is  ratio * coordinate +
/// offset.
struct PassiveHinge {
  double ratio = 1;               // [rad/rad]
  double offset = 0;              // [rad]
  double rest = 0;                // rest angle of the hinge [rad]
  PassiveEnd flexing, extending;  // ends in flexion and in extension
};

/// Range of a coordinate and its passive resistance. Springs, dampers and ranges of coupled hinges
/// are included, referred to the coordinate that drives them.
struct CoordinateLimits {
  double lower;      // lower end of the range [rad]
  double upper;      // upper end of the range [rad]
  double rest;       // angle at which the spring has no torque [rad]
  double stiffness;  // spring stiffness [N m/rad]: passive torque = -stiffness (q - rest), plus
                     // that of the ends
  double damping;    // [N m s/rad]
  /// Hinges of the coordinate that have a passive moment at their ends.
  std::vector<PassiveHinge> ends = {};
};

/// Mass of all segments welded to one link, at the reference posture.
struct LinkMass {
  double mass = 0;               // [kg]
  Eigen::Vector3d com{0, 0, 0};  // centre of mass [m] (3)
  /// Moments of inertia about com, base axes [kg m^2] (3, 3).
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  std::string segment_without_inertia;  // segment with mass but unknown inertia; empty: none
};

/// Tip of a digit.
struct SkeletonTip {
  std::string digit;
  int link;              // -1: welded to the base
  Eigen::Vector3d p;     // position at the reference posture [m] (3)
  Eigen::Matrix3d axes;  // columns proximal, dorsal, radial at the reference posture; a rotation in
                         // a right hand, a reflection (det -1) in a left one (3, 3)
};

/// Kinematic tree of hinges (revolute joints) with names, constant once built.
struct Skeleton {
  Tree<double> tree;                           // parents before children
  std::vector<std::string> hinge_names;        // names of all hinges, coupled ones included
  std::vector<std::string> coordinate_names;   // joint that owns each entry of q
  std::vector<CoordinateLimits> limits;        // limits of each coordinate
  std::vector<LinkMass> masses;                // mass of each link
  std::map<std::string, int> link_of_segment;  // link that carries each segment; -1: the base
  /// Displacement of each segment at q = 0, by frozen joints.
  std::map<std::string, Pose<double>> segment_at;
  /// Joint, by name or by its leader -> the angle it is frozen at [rad].
  std::map<std::string, double> frozen;
  std::vector<SkeletonTip> tips;

  [[nodiscard]] int coordinates() const { return static_cast<int>(coordinate_names.size()); }
};

/// Builds the smallest skeleton that holds the digits of `options`.
/// @throws InputError for an unknown digit or joint, a frozen angle outside the joint's limits, or
/// a joint coupled to a joint of an omitted digit.
[[nodiscard]] Skeleton build_skeleton(const Subject& subject, const SkeletonOptions& options = {});

/// Returns the joints between the base and more than one digit: the wrist.
[[nodiscard]] std::vector<std::string> shared_joints(const Subject& subject);

/// Builds a posture from named angles; joints not named have their reference angle.
/// @return q (coordinates) [rad]
/// @throws InputError for an unknown joint or a non-finite angle.
[[nodiscard]] Eigen::VectorXd posture(const Skeleton& skeleton,
                                      const std::map<std::string, double>& angles);

/// Returns the tip of the named digit. @throws InputError listing the digits of the skeleton.
[[nodiscard]] const SkeletonTip& tip(const Skeleton& skeleton, const std::string& digit);

/// Computes the passive joint torque, passive_moment() of every coordinate  [N m] (coordinates).
[[nodiscard]] Eigen::VectorXd passive_torque(const Skeleton& skeleton,
                                             const Eigen::Ref<const Eigen::VectorXd>& q);

// Mass of a segment: measured, or a solid capsule of hand tissue, bone included.

/// Mean density of a hand segment [kg/m^3]. Source: [Dempster1955] hand, 1.16 kg/l.
inline constexpr double kHandDensity = 1160;

/// Computes mass, centre and inertia of one segment at the reference posture. Measured values take
/// precedence; else the segment is a capsule from `proximal` to `distal` of `radius` and
/// kHandDensity; all are zero if the subject states neither. A measured mass without moments of
/// inertia takes those of the capsule, scaled to the mass; without a radius they are unknown, and
/// LinkMass::segment_without_inertia names the segment.
[[nodiscard]] LinkMass segment_mass(const Segment& segment);

/// Combines two bodies that move as one (parallel-axis theorem).
[[nodiscard]] LinkMass combine(const LinkMass& a, const LinkMass& b);

/// Returns the body after a displacement.
[[nodiscard]] LinkMass displace(const Pose<double>& X, const LinkMass& body);

}  // namespace thenar
