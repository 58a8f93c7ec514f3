#include "data/io/robot/mjcf_couplings.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/lists.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/mjcf_parts.h"

namespace thenar::internal {
namespace {

// Largest share of a tendon's travel that its limits leave [1]
constexpr double kMaxTravelShare = 0.1;

std::string first_of(const pugi::xml_node& node, const std::vector<const char*>& attributes) {
  for (const char* attribute : attributes)
    if (!node.attribute(attribute).empty()) return node.attribute(attribute).value();
  return "world";
}

bool has_actuator(const std::vector<MjcfActuator>& actuators, const std::string& joint) {
  return any_of(actuators, [&](const MjcfActuator& actuator) { return actuator.joint == joint; });
}

bool is_driven(const std::vector<MjcfActuator>& actuators, const FixedTendon& tendon) {
  return any_of(actuators,
                [&](const MjcfActuator& actuator) { return actuator.tendon == tendon.name; });
}

}  // namespace

MjcfCouplings::MjcfCouplings(const MjcfSource& source, const std::vector<double>& ref,
                             const std::vector<FixedTendon>& tendons, RobotSpec& robot)
    : source_(source), refs_(ref), tendons_(tendons), robot_(robot) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) ref_[robot.joints[i].name] = ref[i];
}

void MjcfCouplings::read_equalities() {
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

/// Coupling  q1 - ref1 = a0 + a1 (q2 - ref2) + ..
void MjcfCouplings::couple(const pugi::xml_node& node, const MjcfElement& equality) {
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
    held_.push_back({first, "", 0, a[0] + ref_.at(first), equality.line()});
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
    next[0] += a[static_cast<std::size_t>(k)];
    c = std::move(next);
  }
  while (c.size() > 2 && c.back() == 0) c.pop_back();
  add_coupling(
      {first, second, c[1], c[0] + ref_.at(first), equality.line(), {c.begin() + 2, c.end()}},
      node);
}

/// Coupling  c1 (q1 - ref1) + c2 (q2 - ref2) = a0.
void MjcfCouplings::couple_through_tendon(const pugi::xml_node& node, const MjcfElement& equality) {
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
  add_coupling({follower.joint, leader.joint, ratio,
                offset + ref_.at(follower.joint) - ratio * ref_.at(leader.joint), equality.line()},
               node);
}

void MjcfCouplings::keep_limited_tendons(const std::vector<MjcfActuator>& actuators) {
  for (const FixedTendon& tendon : tendons_) {
    if (!tendon.limits) continue;
    const double slack = tendon.limits->upper - tendon.limits->lower;
    // Travel that the joints alone would allow.
    double travel = 0;
    for (const TendonTerm& term : tendon.terms) {
      const RobotJoint& joint = *find_named(robot_.joints, term.joint);
      travel += std::abs(term.coefficient) * (joint.upper - joint.lower);
    }
    if (tendon.terms.size() != 2 || slack > kMaxTravelShare * travel ||
        is_driven(actuators, tendon)) {
      robot_.warnings.push_back(
          fmt::format("limits of tendon '{}' ({:.4g} to {:.4g}) are not kept: its joints move "
                      "within their own",
                      tendon.name, tendon.limits->lower, tendon.limits->upper));
      continue;
    }
    // The joint with an actuator leads.
    couple_limited(tendon, slack,
                   has_actuator(actuators, tendon.terms[0].joint) ||
                       !has_actuator(actuators, tendon.terms[1].joint));
  }
}

void MjcfCouplings::couple_limited(const FixedTendon& tendon, double slack, bool first_leads) {
  const TendonTerm &leader = tendon.terms[first_leads ? 0 : 1],
                   &follower = tendon.terms[first_leads ? 1 : 0];
  // A joint follows only one other.
  const bool again = follows(follower.joint);
  if (follower.coefficient == 0 || again) {
    robot_.warnings.push_back(
        fmt::format("limits of tendon '{}' ({:.4g} to {:.4g}) are not kept: {}", tendon.name,
                    tendon.limits->lower, tendon.limits->upper,
                    again ? fmt::format("joint '{}' follows another already", follower.joint)
                          : fmt::format("its coefficient of joint '{}' is zero", follower.joint)));
    return;
  }
  // The tendon stays in the middle of its limits.
  const double middle = (tendon.limits->lower + tendon.limits->upper) / 2;
  couplings_.push_back({follower.joint, leader.joint, -leader.coefficient / follower.coefficient,
                        middle / follower.coefficient, tendon.line});
  robot_.warnings.push_back(fmt::format(
      "limits of tendon '{}' couple '{}' to '{}', which may differ by {:.3g} rad or m in the "
      "file",
      tendon.name, follower.joint, leader.joint, slack / 2 / std::abs(follower.coefficient)));
}

bool MjcfCouplings::follows(const std::string& joint) const {
  return any_of(couplings_, [&](const FollowerCoupling& each) { return each.joint == joint; });
}

/// Adds a coupling, unless its joint follows another already.
void MjcfCouplings::add_coupling(const FollowerCoupling& coupling, const pugi::xml_node& node) {
  if (follows(coupling.joint)) {
    source_.unread.note(node, fmt::format("joint '{}' follows another already; its equality with "
                                          "'{}' is not kept",
                                          coupling.joint, coupling.master));
  } else {
    couplings_.push_back(coupling);
  }
}

void MjcfCouplings::apply() {
  for (const FollowerCoupling& held : held_) {
    RobotJoint& fixed = *find_named(robot_.joints, held.joint);
    fixed.X_PJ = fixed.X_PJ * joint_motion(fixed, held.offset);
    fixed.kind = RobotJointKind::kFixed;
    fixed.lower = fixed.upper = 0;
  }
  couple_joints(robot_, couplings_, source_.file.path());
}

}  // namespace thenar::internal
