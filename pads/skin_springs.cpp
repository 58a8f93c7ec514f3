#include "pads/skin_springs.h"

#include <algorithm>
#include <utility>

#include "base/lists.h"

namespace thenar {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Tangential stiffness of sticking nodes over that of the normal springs [1]
constexpr double kStickStiffnessRatio = 0.125;

/// Returns a tiny offset of the object [m] (3), with which an edge along a line of nodes lies on
/// the same side of them for all faces.
const Vector3d& edge_offset() {
  static const Vector3d kEdgeOffset = 1e-11 * Vector3d(1, 0.618, 0.382);
  return kEdgeOffset;
}

/// Calls a function for each node of a face with the corner, the node and its weight in the corner.
template <class Call>
void for_each_node(const SurfaceFace& face, const Call& call) {
  for (Index corner = 0; corner < 4; ++corner)
    for (const NodeWeight& each : face.corners[corner]) call(corner, each.node, each.weight);
}

}  // namespace

void SkinSprings::update(const Shape& object, const Pose<double>& X_PO, const VectorXd& x,
                         const std::vector<double>& stiffness, double friction,
                         const FrictionStart& start) {
  const Matrix3Xd places = deformed_positions(surface_, x);
  // Offset the object, and reset the sums.
  Pose<double> X_offset = X_PO;
  X_offset.p += edge_offset();
  friction_ = friction;
  energy_ = max_depth_ = 0;
  pressed_.clear();
  normal_forces_ = friction_forces_ = Matrix3Xd::Zero(3, places.cols());
  for (const SurfaceFace& face : surface_.faces) {
    // Interpolate the stiffness per area at the face's corners.
    Eigen::Vector4d per_area = Eigen::Vector4d::Zero();
    for_each_node(face, [&](Index corner, int node, double weight) {
      per_area[corner] += weight * stiffness[node] / surface_.area[node];
    });
    PressedFace springs =
        press_face(corner_positions(face, places), per_area, face.area, object, X_offset);
    if (springs.points.empty()) continue;
    // Sum the energy and the forces on nodes.
    energy_ += springs.energy;
    max_depth_ = std::max(max_depth_, springs.deepest);
    for_each_node(face, [&](Index corner, int node, double weight) {
      normal_forces_.col(node) += weight * springs.push.col(corner);
    });
    pressed_.push_back({&face, std::move(springs)});
  }
  // Compute friction, which needs the total normal force of each node.
  node_friction_.assign(surface_.nodes.size(), {});
  if (friction > 0) update_friction(X_PO, places, stiffness, start);
}

bool SkinSprings::has_changed_sides(const Shape& object, const Pose<double>& X_PO_before,
                                    const Pose<double>& X_PO, const VectorXd& before,
                                    double cosine) const {
  const Matrix3Xd places = deformed_positions(surface_, before);
  const Pose<double> X_OP_before = X_PO_before.inverse();
  return any_of(pressed_, [&](const PressedPart& each) {
    // Compare the object's normal at each pressed point with that at the earlier position.
    const FaceCorners earlier = corner_positions(*each.face, places);
    return any_of(each.springs.points, [&](const PressedFace::Point& point) {
      const Vector3d place = X_OP_before * Vector3d(earlier * point.shape);
      return object.nearest(place).normal.dot(X_PO.R.transpose() * point.normal) < cosine;
    });
  });
}

void SkinSprings::update_friction(const Pose<double>& X_PO, const Matrix3Xd& places,
                                  const std::vector<double>& stiffness,
                                  const FrictionStart& start) {
  for (Index k = 0; k < places.cols(); ++k) {
    const double normal_force = normal_forces_.col(k).norm();
    if (normal_force <= 0) continue;
    NodeFriction& node = node_friction_[k];
    node.normal = normal_forces_.col(k) / normal_force;
    // Subtract a spring times the slip from the last friction, and scale it back to the cone.
    const auto tangential = [&](const Vector3d& v) {
      return Vector3d(v - v.dot(node.normal) * node.normal);
    };
    const double spring = kStickStiffnessRatio * stiffness[k], bound = friction_ * normal_force;
    const Vector3d last = start.friction.col(k);
    node.normal_force = normal_force;
    node.trial_force = last - spring * (places.col(k) - X_PO * Vector3d(start.anchor.col(k)));
    const Vector3d trial = tangential(node.trial_force);
    const double size = trial.norm();
    node.slips = size > bound;
    node.scale = node.slips ? bound / size : 1;
    node.stiffness = node.scale * spring;
    // Keep the direction of slip and the last friction for the slope.
    if (node.slips) {
      node.slip_direction = trial / size;
      node.last_ratio = tangential(last) / std::max(bound, tangential(last).norm());
    }
    friction_forces_.col(k) = node.scale * trial;
  }
}

Matrix3d SkinSprings::own_stiffness(const NodeFriction& node) {
  return node.stiffness * (Matrix3d::Identity() - node.normal * node.normal.transpose() -
                           node.last_ratio.dot(node.slip_direction) * node.slip_direction *
                               node.slip_direction.transpose());
}

void SkinSprings::add_stiffness(std::vector<double>& values) const {
  const auto free = [&](int node) { return surface_.nodes[node]; };
  // Add the block of each pair of nodes once, as the tangent is symmetric.
  for (const PressedPart& each : pressed_)
    for_each_node(*each.face, [&](Index row, int one, double weight) {
      for_each_node(*each.face, [&](Index column, int other, double share) {
        if (free(one) >= free(other))
          body_.add_block(values, free(one), free(other),
                          weight * share * each.springs.stiffness.block<3, 3>(3 * row, 3 * column));
      });
    });
  // Add the friction of each node by its own motion.
  for (std::size_t k = 0; k < node_friction_.size(); ++k)
    if (node_friction_[k].stiffness > 0)
      body_.add_block(values, surface_.nodes[k], surface_.nodes[k],
                      own_stiffness(node_friction_[k]));
}

Matrix3Xd SkinSprings::normal_force_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = Matrix3Xd::Zero(3, moved.cols());
  for (const PressedPart& each : pressed_) {
    // Interpolate the motion at the corners, and distribute the forces lost there to the nodes.
    FaceCorners there = FaceCorners::Zero();
    for_each_node(*each.face, [&](Index corner, int node, double weight) {
      there.col(corner) += weight * moved.col(node);
    });
    const FaceCorners lost = (each.springs.stiffness * there.reshaped()).reshaped(3, 4);
    for_each_node(*each.face, [&](Index corner, int node, double weight) {
      out.col(node) += weight * lost.col(corner);
    });
  }
  return out;
}

Matrix3Xd SkinSprings::friction_force_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = normal_force_loss(moved);
  for (std::size_t k = 0; k < node_friction_.size(); ++k) {
    const NodeFriction& node = node_friction_[k];
    if (node.normal_force <= 0) continue;
    const Vector3d n = node.normal, lost = out.col(k), move = moved.col(k);
    // Friction changes by the node's slip, the loss of normal force, and the turn of the normal.
    const Vector3d slid = move - n.dot(move) * n,
                   turn = (n.dot(lost) * n - lost) / node.normal_force;
    Vector3d turned = -turn.dot(node.trial_force) * n - n.dot(node.trial_force) * turn;
    turned -= node.slip_direction.dot(turned) * node.slip_direction;
    out.col(k) = node.stiffness * (slid - node.slip_direction.dot(slid) * node.last_ratio) +
                 friction_ * n.dot(lost) * node.slip_direction - node.scale * turned;
  }
  return out;
}

Matrix3Xd SkinSprings::unfactored_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = friction_force_loss(moved);
  for (std::size_t k = 0; k < node_friction_.size(); ++k) {
    if (node_friction_[k].stiffness > 0)
      out.col(k) -= own_stiffness(node_friction_[k]) * moved.col(k);
  }
  return out;
}

Matrix3Xd SkinSprings::force_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = normal_force_loss(moved);
  if (friction_ > 0) out += friction_force_loss(moved);
  return out;
}

}  // namespace thenar
