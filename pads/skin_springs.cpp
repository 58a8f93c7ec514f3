#include "pads/skin_springs.h"

#include <algorithm>
#include <utility>

namespace thenar {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Stiffness of sticking friction, over that of the normal springs [1]
constexpr double kStickStiffnessRatio = 0.125;

/// Returns the offset at which the object is evaluated [m] (3), so that an edge along nodes lies on
/// the same side of these nodes for all faces.
const Vector3d& edge_offset() {
  static const Vector3d kEdgeOffset = 1e-11 * Vector3d(1, 0.618, 0.382);
  return kEdgeOffset;
}

/// Calls with each node of a face: the corner, the node, and its weight in the corner.
template <class Call>
void for_nodes(const SurfaceFace& face, const Call& call) {
  for (Index corner = 0; corner < 4; ++corner)
    for (const NodeWeight& each : face.corners[static_cast<std::size_t>(corner)])
      call(corner, each.node, each.weight);
}

}  // namespace

void SkinSprings::update(const Shape& object, const Pose<double>& X_PO, const VectorXd& x,
                         const std::vector<double>& stiffness, double friction,
                         const FrictionStart& start) {
  const Matrix3Xd places = deformed_positions(surface_, x);
  // Object moved aside by a hair, so that an edge along nodes lies on one side of them.
  Pose<double> X_offset = X_PO;
  X_offset.p += edge_offset();
  friction_ = friction;
  energy_ = max_depth_ = 0;
  pressed_.clear();
  normal_forces_ = friction_forces_ = Matrix3Xd::Zero(3, places.cols());
  for (const SurfaceFace& face : surface_.faces) {
    // Stiffness per area at the face's corners.
    Eigen::Vector4d per_area = Eigen::Vector4d::Zero();
    for_nodes(face, [&](Index corner, int node, double weight) {
      per_area[corner] += weight * stiffness[static_cast<std::size_t>(node)] / surface_.area[node];
    });
    PressedFace springs =
        press_face(corner_positions(face, places), per_area, face.area, object, X_offset);
    if (springs.points.empty()) continue;
    // Sums over faces, and forces on their nodes.
    energy_ += springs.energy;
    max_depth_ = std::max(max_depth_, springs.deepest);
    for_nodes(face, [&](Index corner, int node, double weight) {
      normal_forces_.col(node) += weight * springs.push.col(corner);
    });
    pressed_.push_back({&face, std::move(springs)});
  }
  // Friction, which needs the sum of a node's pushes.
  node_friction_.assign(surface_.nodes.size(), {});
  if (friction > 0) update_friction(X_PO, places, stiffness, start);
}

bool SkinSprings::has_changed_sides(const Shape& object, const Pose<double>& X_PO_before,
                                    const Pose<double>& X_PO, const VectorXd& before,
                                    double cosine) const {
  const Matrix3Xd places = deformed_positions(surface_, before);
  const Pose<double> X_OP_before = X_PO_before.inverse();
  return std::any_of(pressed_.begin(), pressed_.end(), [&](const PressedPart& each) {
    // Side of the object that was nearest to each pressed point.
    const FaceCorners was = corner_positions(*each.face, places);
    const std::vector<PressedFace::Point>& points = each.springs.points;
    return std::any_of(points.begin(), points.end(), [&](const PressedFace::Point& point) {
      const Vector3d place = X_OP_before * Vector3d(was * point.shape);
      return object.nearest(place).normal.dot(X_PO.R.transpose() * point.normal) < cosine;
    });
  });
}

void SkinSprings::update_friction(const Pose<double>& X_PO, const Matrix3Xd& places,
                                  const std::vector<double>& stiffness,
                                  const FrictionStart& start) {
  for (Index k = 0; k < places.cols(); ++k) {
    const double push = normal_forces_.col(k).norm();
    if (push <= 0) continue;
    NodeFriction& node = node_friction_[static_cast<std::size_t>(k)];
    node.normal = normal_forces_.col(k) / push;
    // Friction: the last force minus a spring times the slip, cut to the cone.
    const auto across = [&](const Vector3d& v) {
      return Vector3d(v - v.dot(node.normal) * node.normal);
    };
    const double stick = kStickStiffnessRatio * stiffness[static_cast<std::size_t>(k)],
                 bound = friction_ * push;
    const Vector3d last = start.friction.col(k);
    node.normal_force = push;
    node.trial_force = last - stick * (places.col(k) - X_PO * Vector3d(start.anchor.col(k)));
    const Vector3d trial = across(node.trial_force);
    const double size = trial.norm();
    node.slips = size > bound;
    node.scale = node.slips ? bound / size : 1;
    node.stiffness = node.scale * stick;
    // Direction of slip, and the last friction over the bound, for the slope.
    if (node.slips) {
      node.slip_direction = trial / size;
      node.last_ratio = across(last) / std::max(bound, across(last).norm());
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
  const auto free = [&](int node) { return surface_.nodes[static_cast<std::size_t>(node)]; };
  // Once for each pair of nodes; each place of a pattern is that of both orders.
  for (const PressedPart& each : pressed_)
    for_nodes(*each.face, [&](Index row, int one, double weight) {
      for_nodes(*each.face, [&](Index column, int other, double share) {
        if (free(one) >= free(other))
          body_.add_block(values, free(one), free(other),
                          weight * share * each.springs.stiffness.block<3, 3>(3 * row, 3 * column));
      });
    });
  // Friction of each node by its own motion.
  for (std::size_t k = 0; k < node_friction_.size(); ++k)
    if (node_friction_[k].stiffness > 0)
      body_.add_block(values, surface_.nodes[k], surface_.nodes[k],
                      own_stiffness(node_friction_[k]));
}

Matrix3Xd SkinSprings::normal_force_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = Matrix3Xd::Zero(3, moved.cols());
  for (const PressedPart& each : pressed_) {
    // Motion of the corners, forces lost there, and these on the nodes.
    FaceCorners there = FaceCorners::Zero();
    for_nodes(*each.face, [&](Index corner, int node, double weight) {
      there.col(corner) += weight * moved.col(node);
    });
    const FaceCorners lost = (each.springs.stiffness * there.reshaped()).reshaped(3, 4);
    for_nodes(*each.face, [&](Index corner, int node, double weight) {
      out.col(node) += weight * lost.col(corner);
    });
  }
  return out;
}

Matrix3Xd SkinSprings::friction_force_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = normal_force_loss(moved);
  for (std::size_t k = 0; k < node_friction_.size(); ++k) {
    const NodeFriction& node = node_friction_[k];
    const auto column = static_cast<Index>(k);
    if (node.normal_force <= 0) continue;
    const Vector3d n = node.normal, lost = out.col(column), move = moved.col(column);
    // Friction changes by the node's own slip, by the push that it loses, and as the push turns.
    const Vector3d slid = move - n.dot(move) * n,
                   turn = (n.dot(lost) * n - lost) / node.normal_force;
    Vector3d turned = -turn.dot(node.trial_force) * n - n.dot(node.trial_force) * turn;
    turned -= node.slip_direction.dot(turned) * node.slip_direction;
    out.col(column) = node.stiffness * (slid - node.slip_direction.dot(slid) * node.last_ratio) +
                      friction_ * n.dot(lost) * node.slip_direction - node.scale * turned;
  }
  return out;
}

Matrix3Xd SkinSprings::unfactored_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = friction_force_loss(moved);
  for (std::size_t k = 0; k < node_friction_.size(); ++k) {
    const auto column = static_cast<Index>(k);
    if (node_friction_[k].stiffness > 0)
      out.col(column) -= own_stiffness(node_friction_[k]) * moved.col(column);
  }
  return out;
}

Matrix3Xd SkinSprings::force_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = normal_force_loss(moved);
  if (friction_ > 0) out += friction_force_loss(moved);
  return out;
}

}  // namespace thenar
