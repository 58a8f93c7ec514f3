#include "data/io/robot/import_couplings.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"

namespace thenar::internal {
namespace {

const Coupling* coupling_of(const std::vector<Coupling>& couplings, const std::string& joint) {
  for (const Coupling& coupling : couplings)
    if (coupling.joint == joint) return &coupling;
  return nullptr;
}

/// The coupling to the joint that follows none.
Coupling to_root(const std::vector<Coupling>& couplings, Coupling step, const std::string& path) {
  std::set<std::string> met{step.joint};
  while (const Coupling* next = coupling_of(couplings, step.master)) {
    if (!met.insert(step.master).second)
      throw DataError(
          path, step.line,
          fmt::format("joint '{}' follows itself, through {}", step.joint, fmt::join(met, ", ")));
    step.offset += step.ratio * next->offset;
    step.ratio *= next->ratio;
    step.master = next->master;
  }
  return step;
}

void follow(RobotSpec& robot, RobotJoint& joint, const Coupling& coupling,
            const std::string& path) {
  const RobotJoint* root = find_joint(robot, coupling.master);
  if (root == nullptr)
    throw DataError(path, coupling.line,
                    fmt::format("joint '{}' follows '{}', and there is no such joint", joint.name,
                                coupling.master));
  joint.ratio = coupling.ratio;
  joint.offset = coupling.offset;
  if (root->kind == RobotJointKind::kFixed || coupling.ratio == 0) {
    joint.dof.clear();  // it stands still
    joint.ratio = 1;
    joint.lower = joint.upper = joint.offset;
  } else {
    joint.dof = coupling.master;
  }
}

/// Tightens the range of a degree of freedom to what a follower can go along with.
void tighten(RobotSpec& robot, RobotDof& dof, RobotJoint& joint) {
  const Range through = range_through(joint);
  const double lower = std::max(dof.lower, through.lower),
               upper = std::min(dof.upper, through.upper);
  // Decimals of a file: 0.333 * 2.4 is no tighter limit than 0.8.
  const double slack = 1e-3 * (dof.upper - dof.lower);
  if (lower <= dof.lower + slack && upper >= dof.upper - slack) return;
  if (lower < upper) {
    robot.warnings.push_back(fmt::format(
        "'{}' moves from {:.6g} to {:.6g} instead of {:.6g} to {:.6g}: further would take '{}', "
        "which follows it, beyond its limits",
        dof.name, lower, upper, dof.lower, dof.upper, joint.name));
    dof.lower = lower;
    dof.upper = upper;
    return;
  }
  const double a = joint.ratio * dof.lower + joint.offset,
               b = joint.ratio * dof.upper + joint.offset;
  robot.warnings.push_back(fmt::format(
      "limits of '{}' ({:.6g} to {:.6g}) leave '{}', which it follows, no way to move; they are "
      "taken as {:.6g} to {:.6g}",
      joint.name, joint.lower, joint.upper, dof.name, std::min(a, b), std::max(a, b)));
  joint.lower = std::min(a, b);
  joint.upper = std::max(a, b);
}

}  // namespace

Range range_through(const RobotJoint& joint) {
  const double a = (joint.lower - joint.offset) / joint.ratio,
               b = (joint.upper - joint.offset) / joint.ratio;
  return {std::min(a, b), std::max(a, b)};
}

RobotJoint* find_joint(RobotSpec& robot, const std::string& name) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&](const RobotJoint& joint) { return joint.name == name; });
  return found == robot.joints.end() ? nullptr : &*found;
}

RobotDof* find_dof(RobotSpec& robot, const std::string& name) {
  const auto found = std::find_if(robot.dofs.begin(), robot.dofs.end(),
                                  [&](const RobotDof& dof) { return dof.name == name; });
  return found == robot.dofs.end() ? nullptr : &*found;
}

void couple_joints(RobotSpec& robot, const std::vector<Coupling>& couplings,
                   const std::string& path) {
  for (RobotJoint& joint : robot.joints) {
    if (joint.kind == RobotJointKind::kFixed) continue;
    if (const Coupling* own = coupling_of(couplings, joint.name)) {
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
  for (RobotJoint& joint : robot.joints)
    if (RobotDof* dof = find_dof(robot, joint.dof); dof != nullptr && dof->name != joint.name)
      tighten(robot, *dof, joint);
}

void order_tree(RobotSpec& robot, const std::string& path) {
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
