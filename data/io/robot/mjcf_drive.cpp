#include "base/lists.h"
#include "data/io/robot/mjcf_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/words.h"
#include "data/io/robot/import_couplings.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/mjcf_actuators.h"

namespace thenar::internal {
namespace {

constexpr double kSameEffort = 1e-6;  // Relative difference up to which efforts are equal [1]
// Largest share of a tendon's travel that its limits leave [1]
constexpr double kMaxTravelShare = 0.1;

/// Gives joints their couplings, degrees of freedom and efforts.
class MjcfDrive {
 public:
  MjcfDrive(const MjcfSource& source, const std::vector<double>& ref, RobotSpec& robot)
      : source_(source), robot_(robot), refs_(ref) {
    for (std::size_t i = 0; i < robot.joints.size(); ++i) ref_[robot.joints[i].name] = ref[i];
  }

  void run() {
    // Read all that couples or drives.
    tendons_ = read_fixed_tendons(source_, robot_);
    read_equalities();
    actuators_ = read_actuators(source_, robot_, tendons_);
    // Couple joints, then drive through tendons, then directly.
    keep_limited_tendons();
    hold_joints();
    couple_joints(robot_, couplings_, source_.file.path());
    for (const MjcfActuator& actuator : actuators_)
      if (!actuator.tendon.empty()) drive_through_tendon(actuator);
    for (const MjcfActuator& actuator : actuators_)
      if (!actuator.joint.empty()) drive_joint(actuator);
    set_efforts();
    // Names for the user, and loops last, as they need the motors.
    name_shared();
    close_loops(robot_, loops_, moved_);
    name_undriven();
  }

 private:
  void read_equalities() {
    for (const pugi::xml_node section : source_.file.root().children("equality"))
      for (const pugi::xml_node node : section.children()) {
        if (node.type() != pugi::node_element) continue;
        const MjcfElement equality(source_, node, "");
        const std::string kind = node.name();
        const std::string name = node.attribute("name").value();
        // Inactive equalities are only noted.
        if (equality.text("active", "true") == "false") {
          source_.unread.note(node, fmt::format("<{}> '{}' is not active", kind, name));
          // Couplings of joints and tendons, and closed loops.
        } else if (kind == "joint") {
          couple(node, equality);
        } else if (kind == "tendon") {
          couple_through_tendon(node, equality);
        } else if (kind == "connect" || kind == "weld") {
          if (std::optional<LoopClosure> loop = read_loop(source_, node, robot_, refs_))
            loops_.push_back(std::move(*loop));
        } else {
          source_.unread.note(
              node, fmt::format("<{}> between '{}' and '{}' is not kept: a robot here is a tree",
                                kind, first_of(node, {"body1", "site1", "geom1", "name"}),
                                first_of(node, {"body2", "site2", "geom2"})));
        }
      }
  }

  static std::string first_of(const pugi::xml_node& node,
                              const std::vector<const char*>& attributes) {
    for (const char* attribute : attributes)
      if (!node.attribute(attribute).empty()) return node.attribute(attribute).value();
    return "world";
  }

  /// Coupling  q1 - ref1 = a0 + a1 (q2 - ref2) + ..
  void couple(const pugi::xml_node& node, const MjcfElement& equality) {
    std::vector<double> a = equality.numbers("polycoef");
    if (a.empty()) a = {0, 1};
    a.resize(5, 0);
    // One joint is held, two are coupled.
    const std::string first = required_text(source_.file, node, "joint1");
    const std::string second = node.attribute("joint2").value();
    if (!has_joint(source_, robot_, node, first) ||
        (!second.empty() && !has_joint(source_, robot_, node, second)))
      return;
    if (second.empty()) {
      held_.push_back({first, "", 0, a[0] + ref_.at(first), equality.line(), {}});
      return;
    }
    // The same polynomial in q2 itself, by Horner's scheme.
    std::vector<double> c{a[4]};
    for (int k = 3; k >= 0; --k) {
      std::vector<double> next(c.size() + 1, 0);
      for (std::size_t i = 0; i < c.size(); ++i) {
        next[i + 1] += c[i];
        next[i] -= c[i] * ref_.at(second);
      }
      next[0] += a[k];
      c = std::move(next);
    }
    while (c.size() > 2 && c.back() == 0) c.pop_back();
    add_coupling(
        {first, second, c[1], c[0] + ref_.at(first), equality.line(), {c.begin() + 2, c.end()}},
        node);
  }

  /// Coupling  c1 (q1 - ref1) + c2 (q2 - ref2) = a0.
  void couple_through_tendon(const pugi::xml_node& node, const MjcfElement& equality) {
    const FixedTendon* tendon = find_named(tendons_, required_text(source_.file, node, "tendon1"));
    if (tendon == nullptr || tendon->terms.size() != 2 || !node.attribute("tendon2").empty()) {
      source_.unread.note(node,
                          "<tendon> equality of other than one fixed tendon of two joints is not "
                          "kept");
      return;
    }
    // Solved for the second joint.
    const std::vector<double> a = equality.numbers("polycoef");
    const TendonTerm& leader = tendon->terms[0];
    const TendonTerm& follower = tendon->terms[1];
    if (follower.coefficient == 0) source_.file.fail(node, "a coefficient of the tendon is zero");
    const double ratio = -leader.coefficient / follower.coefficient;
    const double offset = (a.empty() ? 0 : a[0]) / follower.coefficient;
    add_coupling({follower.joint,
                  leader.joint,
                  ratio,
                  offset + ref_.at(follower.joint) - ratio * ref_.at(leader.joint),
                  equality.line(),
                  {}},
                 node);
  }

  /// Couples the two joints of tendons without actuator whose length can hardly change,
  ///   c1 q1 + c2 q2 = middle of the limits;  for others a warning says that limits are not kept.
  void keep_limited_tendons() {
    for (const FixedTendon& tendon : tendons_) {
      if (!tendon.limits) continue;
      const double slack = tendon.limits->upper - tendon.limits->lower;
      // Travel that the joints alone would allow.
      double travel = 0;
      for (const TendonTerm& term : tendon.terms) {
        const RobotJoint& joint = *find_joint(robot_, term.joint);
        travel += std::abs(term.coefficient) * (joint.upper - joint.lower);
      }
      if (tendon.terms.size() != 2 || slack > kMaxTravelShare * travel || is_driven(tendon)) {
        robot_.warnings.push_back(
            fmt::format("limits of tendon '{}' ({:.4g} to {:.4g}) are not kept: its joints move "
                        "within their own",
                        tendon.name, tendon.limits->lower, tendon.limits->upper));
        continue;
      }
      couple_limited(tendon, slack);
    }
  }

  void couple_limited(const FixedTendon& tendon, double slack) {
    // The joint with an actuator leads.
    const bool first_leads =
        has_actuator(tendon.terms[0].joint) || !has_actuator(tendon.terms[1].joint);
    const TendonTerm &leader = tendon.terms[first_leads ? 0 : 1],
                     &follower = tendon.terms[first_leads ? 1 : 0];
    // A joint follows only one other.
    const bool again = any_of(
        couplings_, [&](const FollowerCoupling& other) { return other.joint == follower.joint; });
    if (follower.coefficient == 0 || again) {
      robot_.warnings.push_back(fmt::format(
          "limits of tendon '{}' ({:.4g} to {:.4g}) are not kept: {}", tendon.name,
          tendon.limits->lower, tendon.limits->upper,
          again ? fmt::format("joint '{}' follows another already", follower.joint)
                : fmt::format("its coefficient of joint '{}' is zero", follower.joint)));
      return;
    }
    // The tendon stays in the middle of its limits.
    const double middle = (tendon.limits->lower + tendon.limits->upper) / 2;
    couplings_.push_back({follower.joint,
                          leader.joint,
                          -leader.coefficient / follower.coefficient,
                          middle / follower.coefficient,
                          tendon.line,
                          {}});
    robot_.warnings.push_back(fmt::format(
        "limits of tendon '{}' couple '{}' to '{}', which may differ by {:.3g} rad or m in the "
        "file",
        tendon.name, follower.joint, leader.joint, slack / 2 / std::abs(follower.coefficient)));
  }

  [[nodiscard]] bool has_actuator(const std::string& joint) const {
    return any_of(actuators_,
                  [&](const MjcfActuator& actuator) { return actuator.joint == joint; });
  }

  [[nodiscard]] bool is_driven(const FixedTendon& tendon) const {
    return any_of(actuators_,
                  [&](const MjcfActuator& actuator) { return actuator.tendon == tendon.name; });
  }

  /// Adds a coupling, unless its joint follows another already.
  void add_coupling(const FollowerCoupling& coupling, const pugi::xml_node& node) {
    const bool again = any_of(
        couplings_, [&](const FollowerCoupling& other) { return other.joint == coupling.joint; });
    if (again) {
      source_.unread.note(node, fmt::format("joint '{}' follows another already; its equality with "
                                            "'{}' is not kept",
                                            coupling.joint, coupling.master));
    } else {
      couplings_.push_back(coupling);
    }
  }

  /// Fixes joints that an equality holds at a value.
  void hold_joints() {
    for (const FollowerCoupling& held : held_) {
      RobotJoint& fixed = *find_joint(robot_, held.joint);
      fixed.X_PJ = fixed.X_PJ * joint_motion(fixed, held.offset);
      fixed.kind = RobotJointKind::kFixed;
      fixed.lower = fixed.upper = 0;
    }
  }

  void drive_joint(const MjcfActuator& actuator) {
    const RobotJoint& driven = *find_joint(robot_, actuator.joint);
    RobotDof* dof = find_dof(robot_, driven.dof);
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
      const RobotJoint& spanned = *find_joint(robot_, term.joint);
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
      RobotDof& dof = *find_dof(robot_, by_dof.begin()->first);
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
    while (find_dof(robot_, shared.name) != nullptr) shared.name += " tendon";
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
  const std::vector<double>& refs_;  // values of joints in the file's posture [rad] or [m]
  std::map<std::string, double> ref_;
  std::vector<LoopClosure> loops_;
  std::vector<FixedTendon> tendons_;
  std::vector<FollowerCoupling> couplings_, held_;
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
