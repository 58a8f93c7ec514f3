#include "pads/point_springs.h"

#include <algorithm>

namespace thenar {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double kFarNode = 2;  // distance of a node, over the size of a face [1]

}  // namespace

void PointSprings::find(const Shape& object, const Pose<double>& X_PO, const VectorXd& x,
                        const std::vector<double>& stiffness, double friction,
                        const Before& before) {
  const Pose<double> X_OP = X_PO.inverse();
  const Matrix3Xd places = places_of(surface_, x);
  // Points whose nodes are all far from the object are left out.
  VectorXd distance(places.cols());
  for (Eigen::Index k = 0; k < places.cols(); ++k)
    distance[k] = object.distance(X_OP * Vector3d(places.col(k)));
  friction_ = friction;
  energy_ = deepest_ = 0;
  inside_.clear();
  push_ = shear_ = Matrix3Xd::Zero(3, places.cols());
  for (const SurfacePoint& point : surface_.grid) {
    const bool far = std::all_of(
        point.nodes.begin(), point.nodes.end(),
        [&](const NodeWeight& each) { return distance[each.node] > kFarNode * point.size; });
    if (far) continue;
    const NearestSurface at = object.nearest(X_OP * place_of(point, places));
    const double depth = -at.distance;
    if (depth <= 0) continue;
    double k = 0;
    for (const NodeWeight& each : point.nodes)
      k += each.weight * point.area / surface_.area[each.node] *
           stiffness[static_cast<std::size_t>(each.node)];
    inside_.push_back({&point, X_PO.R * at.normal, k});
    energy_ += 0.5 * k * depth * depth;
    deepest_ = std::max(deepest_, depth);
    for (const NodeWeight& each : point.nodes)
      push_.col(each.node) += each.weight * k * depth * inside_.back().normal;
  }
  rubbing_.assign(surface_.nodes.size(), {});
  if (friction > 0) rub(X_PO, places, stiffness, before);
}

bool PointSprings::changed_sides(const Shape& object, const Pose<double>& X_PO_before,
                                 const Pose<double>& X_PO, const VectorXd& before,
                                 double cosine) const {
  const Matrix3Xd places = places_of(surface_, before);
  return std::any_of(inside_.begin(), inside_.end(), [&](const Inside& each) {
    const Vector3d was = X_PO_before.inverse() * place_of(*each.point, places);
    return object.nearest(was).normal.dot(X_PO.R.transpose() * each.normal) < cosine;
  });
}

void PointSprings::rub(const Pose<double>& X_PO, const Matrix3Xd& places,
                       const std::vector<double>& stiffness, const Before& before) {
  for (Eigen::Index k = 0; k < places.cols(); ++k) {
    const double push = push_.col(k).norm();
    if (push <= 0) continue;
    Rubbing& node = rubbing_[static_cast<std::size_t>(k)];
    node.normal = push_.col(k) / push;
    // The force within the cone that is nearest to the last less the slip.
    const auto across = [&](const Vector3d& v) {
      return Vector3d(v - v.dot(node.normal) * node.normal);
    };
    const double stick = stiffness[static_cast<std::size_t>(k)], bound = friction_ * push;
    const Vector3d last = before.shear.col(k);
    node.push = push;
    node.trial = last - stick * (places.col(k) - X_PO * Vector3d(before.anchor.col(k)));
    const Vector3d trial = across(node.trial);
    const double size = trial.norm();
    node.slips = size > bound;
    node.cut = node.slips ? bound / size : 1;
    node.stick = node.cut * stick;
    if (node.slips) {
      node.way = trial / size;
      node.last = across(last) / std::max(bound, across(last).norm());
    }
    shear_.col(k) = node.cut * trial;
  }
}

Matrix3d PointSprings::own_slope(const Rubbing& node) {
  return node.stick * (Matrix3d::Identity() - node.normal * node.normal.transpose() -
                       node.last.dot(node.way) * node.way * node.way.transpose());
}

void PointSprings::add_slopes(std::vector<double>& values) const {
  const auto free = [&](int node) { return surface_.nodes[static_cast<std::size_t>(node)]; };
  for (const Inside& each : inside_) {
    const Matrix3d block = each.stiffness * each.normal * each.normal.transpose();
    const std::vector<NodeWeight>& nodes = each.point->nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        body_.add_block(values, free(nodes[i].node), free(nodes[j].node),
                        nodes[i].weight * nodes[j].weight * block);
  }
  for (std::size_t k = 0; k < rubbing_.size(); ++k)
    if (rubbing_[k].stick > 0)
      body_.add_block(values, surface_.nodes[k], surface_.nodes[k], own_slope(rubbing_[k]));
}

Matrix3Xd PointSprings::push_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = Matrix3Xd::Zero(3, moved.cols());
  for (const Inside& each : inside_) {
    double opened = 0;
    for (const NodeWeight& node : each.point->nodes)
      opened += node.weight * each.normal.dot(moved.col(node.node));
    for (const NodeWeight& node : each.point->nodes)
      out.col(node.node) += node.weight * each.stiffness * opened * each.normal;
  }
  return out;
}

Matrix3Xd PointSprings::friction_loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = push_loss(moved);
  for (std::size_t k = 0; k < rubbing_.size(); ++k) {
    const Rubbing& node = rubbing_[k];
    const auto column = static_cast<Eigen::Index>(k);
    if (node.push <= 0) continue;
    const Vector3d n = node.normal, lost = out.col(column), move = moved.col(column);
    // By its own motion and by what it loses of its push; as that turns, so does friction.
    const Vector3d slid = move - n.dot(move) * n, turn = (n.dot(lost) * n - lost) / node.push;
    Vector3d turned = -turn.dot(node.trial) * n - n.dot(node.trial) * turn;
    turned -= node.way.dot(turned) * node.way;
    out.col(column) = node.stick * (slid - node.way.dot(slid) * node.last) +
                      friction_ * n.dot(lost) * node.way - node.cut * turned;
  }
  return out;
}

Matrix3Xd PointSprings::loss_left_out(const Matrix3Xd& moved) const {
  Matrix3Xd out = friction_loss(moved);
  for (std::size_t k = 0; k < rubbing_.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    if (rubbing_[k].stick > 0) out.col(column) -= own_slope(rubbing_[k]) * moved.col(column);
  }
  return out;
}

Matrix3Xd PointSprings::loss(const Matrix3Xd& moved) const {
  Matrix3Xd out = push_loss(moved);
  if (friction_ > 0) out += friction_loss(moved);
  return out;
}

}  // namespace thenar
