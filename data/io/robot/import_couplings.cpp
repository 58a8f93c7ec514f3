#include "data/io/robot/import_couplings.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/robot/link_poses.h"

namespace thenar::internal {
namespace {

const FollowerCoupling* coupling_of(const std::vector<FollowerCoupling>& couplings,
                                    const std::string& joint) {
  for (const FollowerCoupling& coupling : couplings)
    if (coupling.joint == joint) return &coupling;
  return nullptr;
}

/// Largest degree of a composed polynomial: one of degree 4, as files may state, of another.
constexpr std::size_t kMaxComposedDegree = 16;

/// Replaces p(v) by p(next(v)).
/// @throws DataError if the degree is too high: degrees multiply along a chain of joints.
void through(FollowerCoupling& step, const FollowerCoupling& next, const std::string& path) {
  // Coefficients from the constant up.
  const auto coefficients = [](const FollowerCoupling& coupling) {
    std::vector<double> c{coupling.offset, coupling.ratio};
    c.insert(c.end(), coupling.curve.begin(), coupling.curve.end());
    return c;
  };
  const std::vector<double> p = coefficients(step), inner = coefficients(next);
  // Refuse degrees without use.
  const std::size_t degree = (p.size() - 1) * (inner.size() - 1);
  if (degree > kMaxComposedDegree)
    throw DataError(
        path, step.line,
        fmt::format("joint '{}' follows '{}' through '{}' along a polynomial of degree "
                    "{}, more than {}: let it follow '{}' along one of its own",
                    step.joint, next.master, next.joint, degree, kMaxComposedDegree, next.master));
  std::vector<double> sum{0};  // Horner's scheme on polynomials
  for (auto c = p.rbegin(); c != p.rend(); ++c) {
    std::vector<double> product(sum.size() + inner.size() - 1, 0);
    for (std::size_t i = 0; i < sum.size(); ++i)
      for (std::size_t j = 0; j < inner.size(); ++j) product[i + j] += sum[i] * inner[j];
    product[0] += *c;
    sum = std::move(product);
  }
  // Without trailing zeros, but with a linear term.
  while (sum.size() > 2 && sum.back() == 0) sum.pop_back();
  sum.resize(std::max<std::size_t>(sum.size(), 2), 0);
  step.offset = sum[0];
  step.ratio = sum[1];
  step.curve.assign(sum.begin() + 2, sum.end());
}

/// Coupling to the joint that follows no other.
FollowerCoupling to_root(const std::vector<FollowerCoupling>& couplings, FollowerCoupling step,
                         const std::string& path) {
  // Follow the masters; coming back is an error.
  std::set<std::string> met{step.joint};
  while (const FollowerCoupling* next = coupling_of(couplings, step.master)) {
    if (!met.insert(step.master).second)
      throw DataError(
          path, step.line,
          fmt::format("joint '{}' follows itself, through {}", step.joint, fmt::join(met, ", ")));
    through(step, *next, path);
    step.master = next->master;
  }
  return step;
}

void follow(RobotSpec& robot, RobotJoint& joint, const FollowerCoupling& coupling,
            const std::string& path) {
  // The master must exist.
  const RobotJoint* root = find_named(robot.joints, coupling.master);
  if (root == nullptr)
    throw DataError(path, coupling.line,
                    fmt::format("joint '{}' follows '{}', and there is no such joint", joint.name,
                                coupling.master));
  joint.ratio = coupling.ratio;
  joint.offset = coupling.offset;
  joint.curve = coupling.curve;
  // A follower of a fixed joint stands still.
  if (root->kind == RobotJointKind::kFixed || (coupling.ratio == 0 && coupling.curve.empty())) {
    joint.dof.clear();  // it stands still
    joint.curve.clear();
    joint.ratio = 1;
    joint.lower = joint.upper = joint.offset;
  } else {
    joint.dof = coupling.master;
  }
}

/// Longest interval of a degree of freedom in its range that keeps a joint, which follows it along
/// a curve, within its limits. Lower exceeds upper if there is none.
JointRange range_along(const RobotJoint& joint, const RobotDof& dof) {
  // Intervals of a motor's range at which a coupling is checked
  constexpr int kRangeIntervals = 1000;
  const double slack = 1e-3 * (joint.upper - joint.lower);
  const auto at = [&](int i) { return dof.lower + (dof.upper - dof.lower) * i / kRangeIntervals; };
  // Longest run of admissible places.
  JointRange best{1, 0};
  for (int i = 0; i <= kRangeIntervals; ++i) {
    int end = i;
    for (; end <= kRangeIntervals; ++end) {
      const double value = joint_value(joint, at(end));
      if (value < joint.lower - slack || value > joint.upper + slack) break;
    }
    if (end > i && at(end - 1) - at(i) > best.upper - best.lower) best = {at(i), at(end - 1)};
    i = std::max(i, end);
  }
  return best;
}

/// Tightens the range of a degree of freedom so that a follower keeps its limits.
void tighten(RobotSpec& robot, RobotDof& dof, RobotJoint& joint) {
  const JointRange through = joint.curve.empty() ? range_through(joint) : range_along(joint, dof);
  const double lower = std::max(dof.lower, through.lower),
               upper = std::min(dof.upper, through.upper);
  // Rounding in files: 0.333 * 2.4 is no tighter limit than 0.8.
  const double slack = 1e-3 * (dof.upper - dof.lower);
  if (lower <= dof.lower + slack && upper >= dof.upper - slack) return;
  // A smaller range remains.
  if (lower < upper) {
    robot.warnings.push_back(fmt::format(
        "'{}' moves from {:.6g} to {:.6g} instead of {:.6g} to {:.6g}: further would take '{}', "
        "which follows it, beyond its limits",
        dof.name, lower, upper, dof.lower, dof.upper, joint.name));
    dof.lower = lower;
    dof.upper = upper;
    return;
  }
  // Nothing would remain: widen the follower's limits instead.
  const double a = joint_value(joint, dof.lower), b = joint_value(joint, dof.upper);
  robot.warnings.push_back(fmt::format(
      "limits of '{}' ({:.6g} to {:.6g}) leave '{}', which it follows, no way to move; they are "
      "taken as {:.6g} to {:.6g}",
      joint.name, joint.lower, joint.upper, dof.name, std::min(a, b), std::max(a, b)));
  joint.lower = std::min(a, b);
  joint.upper = std::max(a, b);
}

}  // namespace

JointRange range_through(const RobotJoint& joint) {
  const double a = (joint.lower - joint.offset) / joint.ratio,
               b = (joint.upper - joint.offset) / joint.ratio;
  return {std::min(a, b), std::max(a, b)};
}

void widen_limits(RobotJoint& joint, const RobotDof& dof, int intervals) {
  for (int i = 0; i <= intervals; ++i) {
    const double value = joint_value(joint, dof.lower + (dof.upper - dof.lower) * i / intervals);
    joint.lower = std::min(joint.lower, value);
    joint.upper = std::max(joint.upper, value);
  }
}

void couple_joints(RobotSpec& robot, const std::vector<FollowerCoupling>& couplings,
                   const std::string& path) {
  // Followers share the degree of freedom of their root; other joints get their own.
  for (RobotJoint& joint : robot.joints) {
    if (joint.kind == RobotJointKind::kFixed) continue;
    if (const FollowerCoupling* own = coupling_of(couplings, joint.name)) {
      follow(robot, joint, to_root(couplings, *own, path), path);
      continue;
    }
    joint.dof = joint.name;
    RobotDof dof;
    dof.name = joint.name;
    dof.lower = joint.lower;
    dof.upper = joint.upper;
    dof.speed = 1;
    robot.dofs.push_back(dof);
  }
  // Ranges that followers can follow, and limits that contain their curves.
  for (RobotJoint& joint : robot.joints)
    if (RobotDof* dof = find_named(robot.dofs, joint.dof);
        dof != nullptr && dof->name != joint.name)
      tighten(robot, *dof, joint);
  for (RobotJoint& joint : robot.joints)
    if (!joint.curve.empty()) widen_limits(joint, *find_named(robot.dofs, joint.dof), 1000);
}

void order_tree(RobotSpec& robot, const std::string& path) {
  // Exactly one link is carried by no joint: the base.
  std::set<std::string> carried;
  for (const RobotJoint& joint : robot.joints) carried.insert(joint.child);
  std::vector<std::string> roots;
  for (const RobotLink& link : robot.links)
    if (carried.count(link.name) == 0) roots.push_back(link.name);
  if (roots.size() != 1)
    throw DataError(path, 1,
                    roots.empty()
                        ? "every link is carried by a joint; wanted a base"
                        : fmt::format("wanted one base, got links that no joint carries: {}",
                                      fmt::join(roots, ", ")));
  std::stable_partition(robot.links.begin(), robot.links.end(),
                        [&](const RobotLink& link) { return link.name == roots[0]; });

  // Repeatedly take the first joint whose parent is placed.
  std::set<std::string> placed{roots[0]};
  auto next = robot.joints.begin();
  while (next != robot.joints.end()) {
    const auto found = std::find_if(next, robot.joints.end(), [&](const RobotJoint& joint) {
      return placed.count(joint.parent) > 0;
    });
    if (found == robot.joints.end())
      throw DataError(path, 1,
                      fmt::format("joint '{}' hangs on no base: links in a ring", next->name));
    placed.insert(found->child);
    std::rotate(next, found, found + 1);
    ++next;
  }
}

}  // namespace thenar::internal
