#include "data/io/world/graspit_posture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "data/io/graspit/graspit_transform.h"

namespace thenar {
namespace {

constexpr double kFileRounding = 1e-4;  // Rounding of six digits in a file [rad] or [m]

std::vector<const RobotJoint*> joints_of(const RobotSpec& robot, const RobotDof& dof) {
  std::vector<const RobotJoint*> joints;
  for (const RobotJoint& joint : robot.joints)
    if (joint.dof == dof.name) joints.push_back(&joint);
  return joints;
}

double unit_of(const RobotJoint& joint) {
  return joint.kind == RobotJointKind::kPrismatic ? kGraspitLength : 1;
}

/// Reads the numbers of a posture one after the other.
class PostureReader {
 public:
  PostureReader(const RobotSpec& robot, const std::vector<double>& numbers)
      : robot_(robot), numbers_(numbers) {}

  /// @returns nothing if there are too many numbers, too few, or an invalid flag.
  std::optional<GraspitPosture> read(bool with_flags) {
    for (const RobotDof& dof : robot_.dofs) {
      const std::vector<const RobotJoint*> joints = joints_of(robot_, dof);
      if (at_ == numbers_.size()) return {};
      const double q = numbers_[at_++];
      // A breakaway motor has a flag for each joint.
      std::vector<double> values(joints.size(), q);
      bool broken = false;
      if (with_flags && dof.kind == DriveCoupling::kBreakaway)
        for (double& value : values)
          if (!read_flag(value, broken)) return {};
      // Joints that broke away have values of their own.
      if (broken)
        for (std::size_t j = 0; j < joints.size(); ++j) set_joint(*joints[j], values[j]);
      else
        set(dof.name, (joints.empty() ? 1 : unit_of(*joints.front())) * q, dof.lower, dof.upper);
    }
    if (at_ != numbers_.size()) return {};
    return posture_;
  }

 private:
  /// Reads one joint's flag and what follows it: a joint that broke away stays behind its motor.
  bool read_flag(double& value, bool& broken) {
    if (at_ == numbers_.size()) return false;
    const double flag = numbers_[at_++];
    if (flag == 0) return true;
    if (flag != 1 || at_ == numbers_.size()) return false;
    value = std::min(value, numbers_[at_++]);
    broken = true;
    return true;
  }

  void set_joint(const RobotJoint& joint, double value) {
    set(joint.name, joint.ratio * unit_of(joint) * value, joint.lower - joint.offset,
        joint.upper - joint.offset);
  }

  void set(const std::string& name, double value, double lower, double upper) {
    // Values a rounding beyond the limits are put on them without a warning.
    const double kept = std::clamp(value, lower, upper);
    if (std::abs(kept - value) > kFileRounding)
      posture_.warnings.push_back(fmt::format(
          "'{}' is at {:.6g}, outside its limits {:.6g} .. {:.6g} (rad or m): put on them", name,
          value, lower, upper));
    posture_.values[name] = kept;
  }

  const RobotSpec& robot_;
  const std::vector<double>& numbers_;
  std::size_t at_ = 0;
  GraspitPosture posture_;
};

}  // namespace

GraspitPosture graspit_posture(const RobotSpec& robot, const std::vector<double>& numbers) {
  if (numbers.empty()) return {};
  // With flags first, then without.
  for (const bool with_flags : {true, false})
    if (std::optional<GraspitPosture> posture = PostureReader(robot, numbers).read(with_flags))
      return std::move(*posture);
  GraspitPosture none;
  none.warnings.push_back(
      fmt::format("wanted <dofValues> of the {} degrees of freedom of '{}', got {} numbers that do "
                  "not fit them: the posture is left out",
                  robot.dofs.size(), robot.name, numbers.size()));
  return none;
}

}  // namespace thenar
