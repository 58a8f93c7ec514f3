#pragma once

/// A subject's bones and hinges, reduced to what a question needs.

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

/// Ends of the passive moment of one hinge, which stands at  ratio * coordinate + offset.
struct PassiveHinge {
  double ratio = 1;               // [rad/rad]
  double offset = 0;              // [rad]
  double rest = 0;                // of the hinge [rad]
  PassiveEnd flexing, extending;  // beyond rest, and short of it
};

/// Range of a coordinate and its passive resistance. Springs, dampers and ranges of coupled hinges
/// are included, referred to the coordinate that drives them.
struct CoordinateLimits {
  double lower;      // of the range [rad]
  double upper;      // of the range [rad]
  double rest;       // angle at which the spring makes no torque [rad]
  double stiffness;  // passive torque = -stiffness (q - rest) [N m/rad], and that of the ends
  double damping;    // [N m s/rad]
  std::vector<PassiveHinge> ends = {};  // of all hinges of the coordinate that have some
};

/// Mass of everything welded to one link, at the reference posture.
struct LinkMass {
  double mass = 0;                                    // [kg]
  Eigen::Vector3d com{0, 0, 0};                       // [m] (3)
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about com, base axes [kg m^2] (3, 3)
  std::string segment_without_inertia;  // one that has mass but unknown inertia; empty: none
};

/// The tip of a digit.
struct SkeletonTip {
  std::string digit;
  int link;              // -1: welded to the base
  Eigen::Vector3d p;     // reference posture [m] (3)
  Eigen::Matrix3d axes;  // columns proximal, dorsal, radial; reference posture; a rotation in a
                         // right hand, in a left one a reflection (det -1) (3, 3)
};

/// A kinematic tree of hinges (revolute joints) with names, constant once built.
struct Skeleton {
  Tree<double> tree;                               // parents before children
  std::vector<std::string> hinge_names;            // of every hinge, coupled ones too
  std::vector<std::string> coordinate_names;       // joint that owns each entry of q
  std::vector<CoordinateLimits> limits;            // of each coordinate
  std::vector<LinkMass> masses;                    // of each link
  std::map<std::string, int> link_of_segment;      // -1: the base
  std::map<std::string, Pose<double>> segment_at;  // displacement of each segment at q = 0,
                                                   // by frozen joints
  std::map<std::string, double> frozen;  // joint, by name or by its leader -> where it stands [rad]
  std::vector<SkeletonTip> tips;

  [[nodiscard]] int coordinates() const { return static_cast<int>(coordinate_names.size()); }
};

/// Builds the smallest skeleton that holds the digits of `options`.
/// @throws InputError for an unknown digit or joint, a frozen angle outside the joint's limits, a
/// joint coupled to one of a digit left out.
[[nodiscard]] Skeleton build_skeleton(const Subject& subject, const SkeletonOptions& options = {});

/// Joints between the base and more than one digit: the wrist.
[[nodiscard]] std::vector<std::string> shared_joints(const Subject& subject);

/// Coordinates from named angles; joints not named stay at the reference posture.
/// @return q (coordinates) [rad]
/// @throws InputError for an unknown joint or a non-finite angle.
[[nodiscard]] Eigen::VectorXd posture(const Skeleton& skeleton,
                                      const std::map<std::string, double>& angles);

/// The tip of the named digit. @throws InputError naming the digits there are.
[[nodiscard]] const SkeletonTip& tip(const Skeleton& skeleton, const std::string& digit);

/// Passive joint torque, passive_moment() of every coordinate  [N m] (coordinates).
[[nodiscard]] Eigen::VectorXd passive_torque(const Skeleton& skeleton,
                                             const Eigen::Ref<const Eigen::VectorXd>& q);

// Mass of a segment: measured, or a solid capsule of hand tissue, bone included.

/// Mean density of a hand segment [kg/m^3]. Source: [Dempster1955] hand, 1.16 kg/l.
inline constexpr double kHandDensity = 1160;

/// Mass, centre and inertia of one segment at the reference posture.
/// Measured values win; else a capsule from `proximal` to `distal` of `radius` and
/// kHandDensity; all zero if the subject says neither. A measured mass without moments of inertia
/// takes those of the capsule, scaled to the mass; without a radius they stay unknown, which
/// LinkMass::segment_without_inertia tells.
[[nodiscard]] LinkMass segment_mass(const Segment& segment);

/// Mass of two bodies moving as one (parallel-axis theorem).
[[nodiscard]] LinkMass combine(const LinkMass& a, const LinkMass& b);

/// Returns the body after a displacement.
[[nodiscard]] LinkMass displace(const Pose<double>& X, const LinkMass& body);

}  // namespace thenar
