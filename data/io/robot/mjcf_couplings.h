#pragma once

/// Couplings and loops of joints in an MJCF model: its equalities, and limits of its tendons.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/close_loops.h"
#include "data/io/robot/import_couplings.h"
#include "data/io/robot/mjcf_actuators.h"
#include "data/io/robot/mjcf_source.h"
#include "data/io/robot/robot.h"

namespace thenar::internal {

/// Collects the couplings of a robot's joints, and then applies them.
class MjcfCouplings {
 public:
  /// @param ref  value of each joint in the file's own posture, in the order of `robot.joints`
  ///             [rad] or [m]
  MjcfCouplings(const MjcfSource& source, const std::vector<double>& ref,
                const std::vector<FixedTendon>& tendons, RobotSpec& robot);

  /// Reads <equality>: couplings of joints and tendons, joints that are held, closed loops.
  /// @throws DataError
  void read_equalities();
  /// Couples the two joints of tendons without actuator whose length can hardly change,
  ///   c1 q1 + c2 q2 = middle of the limits;  for others a warning says that limits are not kept.
  void keep_limited_tendons(const std::vector<MjcfActuator>& actuators);
  /// Fixes joints that are held at a value, and couples the others.
  void apply();

  [[nodiscard]] const std::vector<LoopClosure>& loops() const { return loops_; }

 private:
  void couple(const pugi::xml_node& node, const MjcfElement& equality);
  void couple_through_tendon(const pugi::xml_node& node, const MjcfElement& equality);
  void couple_limited(const FixedTendon& tendon, double slack, bool first_leads);
  void add_coupling(const FollowerCoupling& coupling, const pugi::xml_node& node);
  /// Returns whether a joint follows another already.
  [[nodiscard]] bool follows(const std::string& joint) const;

  const MjcfSource& source_;
  const std::vector<double>& refs_;  // values of joints in the file's posture [rad] or [m]
  const std::vector<FixedTendon>& tendons_;
  RobotSpec& robot_;
  std::map<std::string, double> ref_;  // reference value by joint
  std::vector<LoopClosure> loops_;
  std::vector<FollowerCoupling> couplings_, held_;
};

}  // namespace thenar::internal
