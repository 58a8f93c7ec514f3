#pragma once

/// Fixed tendons and actuators of MJCF.

#include <optional>
#include <string>
#include <vector>

#include "data/io/robot/import_couplings.h"
#include "data/io/robot/mjcf_source.h"
#include "data/io/robot/robot.h"

namespace thenar::internal {

/// One joint of a fixed tendon.
struct TendonTerm {
  std::string joint;
  double coefficient;  // length per joint value [m/rad] or [1]
};

/// A fixed tendon: its length is a weighted sum of joint values.
struct FixedTendon {
  std::string name;
  std::vector<TendonTerm> terms;
  int line = 1;
  std::optional<JointRange> limits;  // range of its length
};

/// Largest efforts in both directions; both 0: unknown.
struct EffortRange {
  double up = 0, down = 0;  // largest effort either way, >= 0 [N m] or [N]

  /// Returns the efforts on a coordinate that moves by 1 / ratio: multiplied by |ratio|, with the
  /// directions exchanged if the ratio is negative.
  [[nodiscard]] EffortRange through(double ratio) const;
  EffortRange& operator+=(const EffortRange& other);
};

/// An actuator on a joint or a fixed tendon.
struct MjcfActuator {
  std::string name;
  std::string joint, tendon;  // joint or tendon that it drives: one of the two is set
  EffortRange effort;         // range of effort on the joint or tendon
};

/// Returns true if an element refers to a hinge or slide of the robot. Other names in an incomplete
/// model are recorded.
/// @throws DataError if there is no such joint in a complete model
[[nodiscard]] bool has_joint(const MjcfSource& source, const RobotSpec& robot,
                             const pugi::xml_node& node, const std::string& name);

/// Reads the fixed tendons, with limits by MuJoCo's rules; spatial tendons are noted.
/// @throws DataError
[[nodiscard]] std::vector<FixedTendon> read_fixed_tendons(const MjcfSource& source,
                                                          const RobotSpec& robot);

/// Reads the actuators of joints and of these tendons; others are noted.
/// @throws DataError
[[nodiscard]] std::vector<MjcfActuator> read_actuators(const MjcfSource& source,
                                                       const RobotSpec& robot,
                                                       const std::vector<FixedTendon>& tendons);

}  // namespace thenar::internal
