#include "data/io/robot/mjcf_parts.h"

#include <algorithm>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/lists.h"
#include "base/words.h"
#include "data/io/robot/import_couplings.h"
#include "data/io/robot/mjcf_actuators.h"
#include "data/io/robot/mjcf_couplings.h"

namespace thenar::internal {
namespace {

constexpr double kSameEffort = 1e-6;  // Relative difference up to which efforts are equal [1]

/// Gives joints their degrees of freedom and efforts.
class MjcfDrive {
 public:
  MjcfDrive(const MjcfSource& source, const std::vector<double>& ref, RobotSpec& robot)
      : source_(source),
        robot_(robot),
        tendons_(read_fixed_tendons(source, robot)),
        couplings_(source, ref, tendons_, robot) {}

  void run() {
    // Read all that couples or drives.
    couplings_.read_equalities();
    actuators_ = read_actuators(source_, robot_, tendons_);
    // Couple joints, then drive through tendons, then directly.
    couplings_.keep_limited_tendons(actuators_);
    couplings_.apply();
    for (const MjcfActuator& actuator : actuators_)
      if (!actuator.tendon.empty()) drive_through_tendon(actuator);
    for (const MjcfActuator& actuator : actuators_)
      if (!actuator.joint.empty()) drive_joint(actuator);
    set_efforts();
    // Names for the user, and loops last, as they need the motors.
    name_shared();
    close_loops(robot_, couplings_.loops(), moved_);
    name_undriven();
  }

 private:
  void drive_joint(const MjcfActuator& actuator) {
    const RobotJoint& driven = *find_named(robot_.joints, actuator.joint);
    RobotDof* dof = find_named(robot_.dofs, driven.dof);
    if (dof == nullptr) {
      robot_.warnings.push_back(
          fmt::format("actuator '{}' drives joint '{}', which nothing can move: it is left out",
                      actuator.name, actuator.joint));
      return;
    }
    // Efforts on one degree of freedom add up.
    efforts_[dof->name] += actuator.effort.through(driven.ratio);
    moved_.insert(dof->name);
    by_dof_[dof->name].push_back(actuator.name);
  }

  /// Gives motors their efforts; of different ones in both directions the smaller, as long as
  /// nothing says which way closes, and the only one of motors that pull one way.
  void set_efforts() {
    std::vector<std::string> uneven;
    for (RobotDof& dof : robot_.dofs) {
      const EffortRange effort = efforts_[dof.name];
      const double least = std::min(effort.up, effort.down),
                   most = std::max(effort.up, effort.down);
      const bool even = most - least <= kSameEffort * most;
      dof.max_effort = even || least == 0 ? most : least;
      if (even) continue;
      dof.effort_up = effort.up;
      dof.effort_down = effort.down;
      uneven.push_back(
          fmt::format("'{}' {:.4g} upwards and {:.4g} downwards, of which {:.4g} is taken",
                      dof.name, effort.up, effort.down, dof.max_effort));
    }
    if (!uneven.empty())
      robot_.warnings.push_back(
          fmt::format("efforts differ by direction, unless closing is inferred and decides: {}",
                      some_of(uneven)));
  }

  /// Warns of degrees of freedom with several actuators, which count as one motor.
  void name_shared() {
    for (const auto& [dof, actuators] : by_dof_)
      if (actuators.size() > 1)
        robot_.warnings.push_back(fmt::format(
            "'{}' is driven by the actuators '{}': they are taken as one motor with the sum of "
            "their efforts",
            dof, fmt::join(actuators, "', '")));
  }

  /// Derivative of the tendon's length by each degree of freedom.
  std::map<std::string, double> gradient(const FixedTendon& tendon) {
    std::map<std::string, double> by_dof;
    for (const TendonTerm& term : tendon.terms) {
      const RobotJoint& spanned = *find_named(robot_.joints, term.joint);
      if (!spanned.dof.empty()) by_dof[spanned.dof] += term.coefficient * spanned.ratio;
    }
    return by_dof;
  }

  void drive_through_tendon(const MjcfActuator& actuator) {
    const FixedTendon& tendon = *find_named(tendons_, actuator.tendon);
    const std::map<std::string, double> by_dof = gradient(tendon);
    double squares = 0;
    for (const auto& [name, coefficient] : by_dof) squares += coefficient * coefficient;
    if (!(squares > 0)) return;
    // One degree of freedom: the actuator is its motor.
    if (by_dof.size() == 1) {
      RobotDof& dof = *find_named(robot_.dofs, by_dof.begin()->first);
      efforts_[dof.name] += actuator.effort.through(by_dof.begin()->second);
      moved_.insert(dof.name);
      by_dof_[dof.name].push_back(actuator.name);
      return;
    }
    // Several: they must be linear and not yet driven.
    for (const RobotJoint& joint : robot_.joints)
      if (!joint.curve.empty() && by_dof.count(joint.dof) > 0) {
        robot_.warnings.push_back(fmt::format(
            "tendon '{}' spans '{}', which '{}' follows along a curve: it is not read, and "
            "actuator '{}' drives nothing",
            tendon.name, joint.dof, joint.name, actuator.name));
        return;
      }
    for (const auto& [name, coefficient] : by_dof)
      if (moved_.count(name) > 0) {
        robot_.warnings.push_back(
            fmt::format("tendon '{}' spans '{}', which another tendon drives: "
                        "it is not read, and actuator '{}' drives nothing",
                        tendon.name, name, actuator.name));
        return;
      }
    join(tendon.name, by_dof, squares, actuator);
  }

  /// Replaces several degrees of freedom by one compliant one.
  void join(const std::string& tendon, const std::map<std::string, double>& by_dof, double squares,
            const MjcfActuator& actuator) {
    // A motor with the tendon's name.
    RobotDof shared;
    shared.name = tendon;
    while (find_named(robot_.dofs, shared.name) != nullptr) shared.name += " tendon";
    shared.kind = DriveCoupling::kCompliant;
    shared.speed = 1;
    efforts_[shared.name] = actuator.effort;
    shared.lower = -std::numeric_limits<double>::infinity();
    shared.upper = std::numeric_limits<double>::infinity();
    // Joints follow it as equal springs would let them.
    for (RobotJoint& moved : robot_.joints) {
      const auto part = by_dof.find(moved.dof);
      if (part == by_dof.end() || moved.dof.empty() || part->second == 0) continue;
      moved.ratio *= part->second / squares;
      moved.dof = shared.name;
      const JointRange range = range_through(moved);
      shared.lower = std::max(shared.lower, range.lower);
      shared.upper = std::min(shared.upper, range.upper);
    }
    if (shared.lower > shared.upper)
      throw DataError(
          source_.file.path(), 1,
          fmt::format("limits of the joints of tendon '{}' leave no way to move", tendon));
    // It takes the place of the first one that it replaces.
    const auto place =
        std::find_if(robot_.dofs.begin(), robot_.dofs.end(),
                     [&](const RobotDof& dof) { return by_dof.count(dof.name) > 0; });
    robot_.dofs.insert(place, shared);
    erase_where(robot_.dofs, [&](const RobotDof& dof) {
      const auto part = by_dof.find(dof.name);
      return part != by_dof.end() && part->second != 0;
    });
    moved_.insert(shared.name);
    by_dof_[shared.name].push_back(actuator.name);
  }

  /// Warns of degrees of freedom without actuator, if there are any actuators.
  void name_undriven() {
    std::vector<std::string> idle;
    for (const RobotDof& dof : robot_.dofs)
      if (moved_.count(dof.name) == 0) idle.push_back(dof.name);
    if (!idle.empty() && !actuators_.empty())
      robot_.warnings.push_back(
          fmt::format("no actuator drives {}; each is a degree of freedom of unknown effort",
                      fmt::join(idle, ", ")));
  }

  const MjcfSource& source_;
  RobotSpec& robot_;
  std::vector<FixedTendon> tendons_;
  MjcfCouplings couplings_;
  std::vector<MjcfActuator> actuators_;
  std::set<std::string> moved_;                             // degrees of freedom with an actuator
  std::map<std::string, EffortRange> efforts_;              // of each degree of freedom
  std::map<std::string, std::vector<std::string>> by_dof_;  // actuators of each degree of freedom
};

}  // namespace

void drive_mjcf(const MjcfSource& source, const std::vector<double>& ref, RobotSpec& robot) {
  MjcfDrive(source, ref, robot).run();
}

}  // namespace thenar::internal
