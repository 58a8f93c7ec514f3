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
const Vector3d& beside() {
  static const Vector3d kBeside = 1e-11 * Vector3d(1, 0.618, 0.382);
  return kBeside;
}

/// Calls with each node of a face: the corner, the node, and its weight in the corner.
template <class Call>
void for_nodes(const SurfaceFace& face, const Call& call) {
  for (Index corner = 0; corner < 4; ++corner)
    for (const NodeWeight& each : face.corners[static_cast<std::size_t>(corner)])
      call(corner, each.node, each.weight);
}

}  // namespace

void SkinSprings::find(const Shape& object, const Pose<double>& X_PO, const VectorXd& x,
                       const std::vector<double>& stiffness, double friction,
                       const Before& before) {
  const Matrix3Xd places = places_of(surface_, x);
  // Object moved aside by a hair, so that an edge along nodes lies on one side of them.
  Pose<double> X_beside = X_PO;
  X_beside.p += beside();
  friction_ = friction;
  energy_ = deepest_ = 0;
  pressed_.clear();
  push_ = shear_ = Matrix3Xd::Zero(3, places.cols());
  for (const SurfaceFace& face : surface_.faces) {
    // Stiffness per area at the face's corners.
    Eigen::Vector4d per_area = Eigen::Vector4d::Zero();
    for_nodes(face, [&](Index corner, int node, double weight) {
      per_area[corner] += weight * stiffness[static_cast<std::size_t>(node)] / surface_.area[node];
    });
    PressedFace springs =
        press_face(corners_of(face, places), per_area, face.area, object, X_beside);
    if (springs.points.empty()) continue;
    // Sums over faces, and forces on their nodes.
    energy_ += springs.energy;
    deepest_ = std::max(deepest_, springs.deepest);
    for_nodes(face, [&](Index corner, int node, double weight) {
      push_.col(node) += weight * springs.push.col(corner);
    });
    pressed_.push_back({&face, std::move(springs)});
  }
  // Friction, which needs the sum of a node's pushes.
  rubbing_.assign(surface_.nodes.size(), {});
  if (friction > 0) rub(X_PO, places, stiffness, before);
}

bool SkinSprings::changed_sides(const Shape& object, const Pose<double>& X_PO_before,
                                const Pose<double>& X_PO, const VectorXd& before,
                                double cosine) const {
  const Matrix3Xd places = places_of(surface_, before);
  const Pose<double> X_OP_before = X_PO_before.inverse();
  return std::any_of(pressed_.begin(), pressed_.end(), [&](const Pressed& each) {
    // Side of the object that was nearest to each pressed point.
    const FaceCorners was = corners_of(*each.face, places);
    const std::vector<PressedFace::Point>& points = each.springs.points;
    return std::any_of(points.begin(), points.end(), [&](const PressedFace::Point& point) {
      const Vector3d place = X_OP_before * Vector3d(was * point.shape);
      return object.nearest(place).normal.dot(X_PO.R.transpose() * point.normal) < cosine;
    });
  });
}

void SkinSprings::rub(const Pose<double>& X_PO, const Matrix3Xd& places,
                      const std::vector<double>& stiffness, const Before& before) {
  for (Index k = 0; k < places.cols(); ++k) {
    const double push = push_.col(k).norm();
    if (push <= 0) continue;
    Rubbing& node = rubbing_[static_cast<std::size_t>(k)];
    node.normal = push_.col(k) / push;
    // Friction: the last force minus a spring times the slip, cut to the cone.
    const auto across = [&](const Vector3d& v) {
      return Vector3d(v - v.dot(node.normal) * node.normal);
    };
    const double stick = kStickStiffnessRatio * stiffness[static_cast<std::size_t>(k)],
                 bound = friction_ * push;
    const Vector3d last = before.shear.col(k);
    node.push = push;
    node.trial = last - stick * (places.col(k) - X_PO * Vector3d(before.anchor.col(k)));
    const Vector3d trial = across(node.trial);
    const double size = trial.norm();
    node.slips = size > bound;
    node.cut = node.slips ? bound / size : 1;
    node.stick = node.cut * stick;
    // Direction of slip, and the last friction over the bound, for the slope.
    if (node.slips) {
      node.way = trial / size;
      node.last = across(last) / std::max(bound, across(last).norm());
    }
    shear_.col(k) = node.cut * trial;
  }
}

Matrix3d SkinSprings::own_slope(const Rubbing& node) {
  return node.stick * (Matrix3d::Identity() - node.normal * node.normal.transpose() -
                       node.last.dot(node.way) * node.way * node.way.transpose());
}

void SkinSprings::add_slopes(std::vector<double>& values) const {
  const auto free = [&](int node) { return surface_.nodes[static_cast<std::size_t>(node)]; };
  // Once for each pair of nodes; each place of a pattern is that of both orders.
  for (const Pressed& each : pressed_)
    for_nodes(*each.face, [&](Index row, int one, double weight) {
      for_nodes(*each.face, [&](Index column, int other, double share) {
        if (free(one) >= free(other))
          body_.add_block(values, free(one), free(other),
                          weight * share * each.springs.stiffness.block<3, 3>(3 * row, 3 * column));
      });
    });
  // Friction of each node by its own motion.
  for (std::size_t k = 0; k < rubbing_.size(); ++k)
    if (rubbing_[k].stick > 0)
      body_.add_block(values, surface_.nodes[k], surface_.nodes[k], own_slope(rubbing_[k]));
}

Matrix3Xd SkinSprings::push_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = Matrix3Xd::Zero(3, moved.cols());
  for (const Pressed& each : pressed_) {
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

Matrix3Xd SkinSprings::friction_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = push_loss(moved);
  for (std::size_t k = 0; k < rubbing_.size(); ++k) {
    const Rubbing& node = rubbing_[k];
    const auto column = static_cast<Index>(k);
    if (node.push <= 0) continue;
    const Vector3d n = node.normal, lost = out.col(column), move = moved.col(column);
    // Friction changes by the node's own slip, by the push that it loses, and as the push turns.
    const Vector3d slid = move - n.dot(move) * n, turn = (n.dot(lost) * n - lost) / node.push;
    Vector3d turned = -turn.dot(node.trial) * n - n.dot(node.trial) * turn;
    turned -= node.way.dot(turned) * node.way;
    out.col(column) = node.stick * (slid - node.way.dot(slid) * node.last) +
                      friction_ * n.dot(lost) * node.way - node.cut * turned;
  }
  return out;
}

Matrix3Xd SkinSprings::loss_left_out(const Matrix3Xd& moved) const {
  Matrix3Xd out = friction_loss(moved);
  for (std::size_t k = 0; k < rubbing_.size(); ++k) {
    const auto column = static_cast<Index>(k);
    if (rubbing_[k].stick > 0) out.col(column) -= own_slope(rubbing_[k]) * moved.col(column);
  }
  return out;
}

Matrix3Xd SkinSprings::loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = push_loss(moved);
  if (friction_ > 0) out += friction_loss(moved);
  return out;
}

}  // namespace thenar
