#include "pads/node_contacts.h"

#include <algorithm>

#include "base/lists.h"

namespace thenar {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

void update_contacts(PressIterate& iterate) {
  iterate.gaps.update(*iterate.object.shape, iterate.state.X_PO, iterate.state.x);
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k) {
    SkinNodeContact& c = iterate.contacts[k];
    const double stiffness = iterate.node_stiffness[k];
    // Augment the normal force:  max(0, normal force - stiffness gap).
    c.normal_force = std::max(0.0, iterate.state.normal_force[k] - stiffness * iterate.gaps.gap(k));
    c.friction_force.setZero();
    c.slips = c.normal_force > 0;
    c.friction_scale = 0;
    if (c.normal_force <= 0 || iterate.object.friction <= 0) continue;
    // Augment the friction by a spring times the slip, and scale it back to the cone.
    const Vector3d last = iterate.tangential(k, iterate.state.friction_force.col(k));
    const Vector3d trial = last - stiffness * iterate.node_slip(k);
    const double bound = iterate.object.friction * c.normal_force, size = trial.norm();
    c.slips = size > bound;
    c.friction_scale = c.slips ? bound / size : 1;
    c.slip_direction = c.last_friction_ratio = Vector3d(0, 0, 0);
    // Keep the direction of slip and the last friction for the slope.
    if (c.slips) {
      c.slip_direction = trial / size;
      c.last_friction_ratio = last / std::max(bound, last.norm());
    }
    c.friction_force = c.friction_scale * trial;
  }
}

Matrix3Xd normal_forces(const PressIterate& iterate) {
  VectorXd forces(static_cast<Eigen::Index>(iterate.contacts.size()));
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    forces[k] = iterate.contacts[k].normal_force;
  return iterate.gaps.nodal_forces(forces);
}

IterateAction assess_iterate(PressIterate& iterate, const Matrix3Xd& u, PressOutcome& out) {
  update_contacts(iterate);
  iterate.measure_residual(normal_forces(iterate), out);
  if (iterate.is_converged(out)) {
    iterate.accept(u, out);
    return IterateAction::kEnded;
  }
  if (!iterate.goal.force || iterate.total_force != 0) return IterateAction::kStep;
  return iterate.move_to_contact(out) ? IterateAction::kMoved : IterateAction::kEnded;
}

Matrix3d own_stiffness(const PressIterate& iterate, std::size_t k) {
  const SkinNodeContact& c = iterate.contacts[k];
  if (c.normal_force <= 0) return Matrix3d::Zero();
  // Add the stiffness of friction in the tangent plane, reduced along the slip, to the normal one.
  const Vector3d own = iterate.gaps.own_gradient(k), normal = iterate.gaps.normal(k);
  const Matrix3d plane =
      Matrix3d::Identity() - normal * normal.transpose() -
      c.last_friction_ratio.dot(c.slip_direction) * c.slip_direction * c.slip_direction.transpose();
  return iterate.node_stiffness[k] * (own * own.transpose() + c.friction_scale * plane);
}

void add_own_stiffness(PressIterate& iterate) {
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    iterate.add_node_block(k, own_stiffness(iterate, k));
}

Vector3d lost_friction(const PressIterate& iterate, std::size_t k, const Vector3d& moved,
                       double lost) {
  const SkinNodeContact& c = iterate.contacts[k];
  const Vector3d slid = iterate.tangential(k, moved);
  return iterate.node_stiffness[k] * c.friction_scale *
             (slid - c.slip_direction.dot(slid) * c.last_friction_ratio) +
         iterate.object.friction * lost * c.slip_direction;
}

Matrix3Xd contact_force_loss(const PressIterate& iterate, const Matrix3Xd& moved) {
  // Sum the normal forces lost as gaps open, then friction.
  VectorXd lost = iterate.gaps.gap_changes(moved);
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    lost[k] *= iterate.contacts[k].normal_force > 0 ? iterate.node_stiffness[k] : 0;
  Matrix3Xd out = iterate.gaps.nodal_forces(lost);
  for (std::size_t k = 0; iterate.object.friction > 0 && k < iterate.contacts.size(); ++k) {
    if (iterate.contacts[k].normal_force > 0)
      out.col(k) += lost_friction(iterate, k, Vector3d(moved.col(k)), lost[k]);
  }
  return out;
}

std::vector<ContactState> contact_states(const PressIterate& iterate) {
  return transformed(iterate.contacts, [](const SkinNodeContact& c) {
    if (c.normal_force <= 0) return ContactState::kOpen;
    return c.slips ? ContactState::kSlips : ContactState::kSticks;
  });
}

bool has_sliding_nodes(const PressIterate& iterate) {
  return iterate.object.friction > 0 &&
         any_of(iterate.contacts, [](const SkinNodeContact& c) { return c.slips; });
}

}  // namespace thenar
