#include "pads/node_contacts.h"

#include <algorithm>

namespace thenar {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

void find_contacts(PressIterate& at) {
  at.gaps.find(*at.object.shape, at.now.X_PO, at.now.x);
  for (std::size_t k = 0; k < at.contacts.size(); ++k) {
    TouchingNode& c = at.contacts[k];
    const auto column = static_cast<Eigen::Index>(k);
    // Augmented normal force  (normal - stiffness gap)+.
    c.push = std::max(0.0, at.now.normal[column] - at.stiffness[k] * at.gaps.gap(k));
    c.shear.setZero();
    c.slips = c.push > 0;
    c.cut = 0;
    if (c.push <= 0 || at.object.friction <= 0) continue;
    // Friction: the last force minus a spring times the slip, cut to the cone.
    const Vector3d trial =
        at.across(k, Vector3d(at.now.shear.col(column))) - at.stiffness[k] * at.slip_of(k);
    const double bound = at.object.friction * c.push, size = trial.norm();
    c.slips = size > bound;
    c.cut = c.slips ? bound / size : 1;
    c.way = c.last = Vector3d(0, 0, 0);
    // Direction of slip, and the last friction over the bound, for the slope.
    if (c.slips) {
      c.way = trial / size;
      const Vector3d last = at.across(k, Vector3d(at.now.shear.col(column)));
      c.last = last / std::max(bound, last.norm());
    }
    c.shear = c.cut * trial;
  }
}

Matrix3Xd normal_forces(const PressIterate& at) {
  VectorXd push(static_cast<Eigen::Index>(at.contacts.size()));
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    push[static_cast<Eigen::Index>(k)] = at.contacts[k].push;
  return at.gaps.spread(push);
}

IterateTurn judge_iterate(PressIterate& at, const Matrix3Xd& u, PressOutcome& out) {
  find_contacts(at);
  at.measure(normal_forces(at), out);
  if (at.is_solved(out)) {
    at.end(u, out);
    return IterateTurn::kEnded;
  }
  if (!at.goal.force || at.scale != 0) return IterateTurn::kStep;
  return at.go_to_touch(out) ? IterateTurn::kMoved : IterateTurn::kEnded;
}

Matrix3d own_slope(const PressIterate& at, std::size_t k) {
  const TouchingNode& c = at.contacts[k];
  if (c.push <= 0) return Matrix3d::Zero();
  // Normal stiffness, and that of friction in the tangent plane, less along the slip.
  const Vector3d own = at.gaps.own_slope(k), normal = at.gaps.normal(k);
  const Matrix3d plane = Matrix3d::Identity() - normal * normal.transpose() -
                         c.last.dot(c.way) * c.way * c.way.transpose();
  return at.stiffness[k] * (own * own.transpose() + c.cut * plane);
}

void add_own_slopes(PressIterate& at) {
  for (std::size_t k = 0; k < at.contacts.size(); ++k) at.add_block(k, own_slope(at, k));
}

Vector3d lost_shear(const PressIterate& at, std::size_t k, const Vector3d& moved, double lost) {
  const TouchingNode& c = at.contacts[k];
  const Vector3d slid = at.across(k, moved);
  return at.stiffness[k] * c.cut * (slid - c.way.dot(slid) * c.last) +
         at.object.friction * lost * c.way;
}

Matrix3Xd contact_loss(const PressIterate& at, const Matrix3Xd& moved) {
  // Normal forces lost as gaps open, then friction.
  VectorXd lost = at.gaps.change(moved);
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    lost[static_cast<Eigen::Index>(k)] *= at.contacts[k].push > 0 ? at.stiffness[k] : 0;
  Matrix3Xd out = at.gaps.spread(lost);
  for (std::size_t k = 0; at.object.friction > 0 && k < at.contacts.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    if (at.contacts[k].push > 0)
      out.col(column) += lost_shear(at, k, Vector3d(moved.col(column)), lost[column]);
  }
  return out;
}

std::vector<int> contact_states(const PressIterate& at) {
  std::vector<int> out;
  for (const TouchingNode& c : at.contacts) out.push_back(c.push <= 0 ? 0 : c.slips ? 2 : 1);
  return out;
}

bool some_slip(const PressIterate& at) {
  return at.object.friction > 0 && std::any_of(at.contacts.begin(), at.contacts.end(),
                                               [](const TouchingNode& c) { return c.slips; });
}

}  // namespace thenar
