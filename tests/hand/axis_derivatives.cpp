#include "tests/hand/axis_derivatives.h"

#include <cmath>

namespace thenar {
namespace {

/// Returns whether hinge i moves link j.
bool moves(const Tree<double>& tree, int i, int j) {
  while (j > i) j = tree[j].parent;
  return i == j;
}

/// Hinge whose axis varies, with the data of its rotation.
class MovedAxis {
 public:
  explicit MovedAxis(const AxisQuestion& question)
      : question_(question),
        hinge_(question.tree[question.hinge]),
        state_(question.state[question.hinge]),
        angle_(hinge_.ratio * question.q[hinge_.coordinate] + hinge_.offset),
        tangents_(tangents(hinge_.direction)) {
    if (hinge_.parent >= 0) R_parent_ = question.state[hinge_.parent].X.R;
  }

  /// Computes the derivative of a point beyond the hinge.
  [[nodiscard]] ByAxis point(const Eigen::Vector3d& x) const {
    ByAxis D = direction(x - state_.point);
    D.rightCols<3>() = R_parent_ - state_.X.R;
    return D;
  }

  /// Computes the derivative of a direction beyond the hinge.
  [[nodiscard]] ByAxis direction(const Eigen::Vector3d& now) const {
    const Eigen::Vector3d& d = hinge_.direction;
    // Differentiate Rodrigues' formula by a tilt of the axis.
    const Eigen::Vector3d v = state_.X.R.transpose() * now;
    const auto tilt = [&](const Eigen::Vector3d& e) -> Eigen::Vector3d {
      return R_parent_ * (std::sin(angle_) * e.cross(v) +
                          (1 - std::cos(angle_)) * (e * d.dot(v) + d * e.dot(v)));
    };
    ByAxis D = ByAxis::Zero();
    D << tilt(tangents_.e1), tilt(tangents_.e2), Eigen::Matrix3d::Zero();
    return D;
  }

  /// Computes the derivative of the present direction of hinge j.
  [[nodiscard]] ByAxis axis_of(int j) const {
    // Return zero for hinges nearer the base; those beyond move as directions do.
    if (!moves(question_.tree, question_.hinge, j)) return ByAxis::Zero();
    if (j != question_.hinge) return direction(question_.state[j].axis);
    ByAxis D;
    D << R_parent_ * tangents_.e1, R_parent_ * tangents_.e2, Eigen::Matrix3d::Zero();
    return D;
  }

  /// Computes the derivative of the present point of hinge j.
  [[nodiscard]] ByAxis point_of(int j) const {
    // Return zero for hinges nearer the base; those beyond move as points do.
    if (!moves(question_.tree, question_.hinge, j)) return ByAxis::Zero();
    if (j != question_.hinge) return point(question_.state[j].point);
    ByAxis D = ByAxis::Zero();
    D.rightCols<3>() = R_parent_;
    return D;
  }

 private:
  const AxisQuestion& question_;
  const Hinge<double>& hinge_;
  const LinkState<double>& state_;
  double angle_;  // angle of the hinge [rad]
  Tangents tangents_;
  Eigen::Matrix3d R_parent_ = Eigen::Matrix3d::Identity();
};

}  // namespace

ByAxis position_by_axis(const AxisQuestion& question, int link, const Eigen::Vector3d& x) {
  if (!moves(question.tree, question.hinge, link)) return ByAxis::Zero();
  return MovedAxis(question).point(x);
}

std::vector<ByAxis> position_jacobian_by_axis(const AxisQuestion& question, int link,
                                              const Eigen::Vector3d& x) {
  std::vector<ByAxis> result(static_cast<std::size_t>(question.q.size()), ByAxis::Zero());
  const Tree<double>& tree = question.tree;
  if (!moves(tree, question.hinge, link)) return result;

  // Compute the derivative of the point.
  const MovedAxis moved_axis(question);
  const ByAxis dx = moved_axis.point(x);
  // Apply the product rule over axis, point of the hinge and point of the link.
  for_each_hinge_to_base(tree, link, [&](int j) {
    const LinkState<double>& own = question.state[j];
    const ByAxis d_axis = moved_axis.axis_of(j), d_point = moved_axis.point_of(j);
    ByAxis& column = result[tree[j].coordinate];
    for (int k = 0; k < 5; ++k)
      column.col(k) += tree[j].ratio * (d_axis.col(k).cross(x - own.point) +
                                        own.axis.cross(dx.col(k) - d_point.col(k)));
  });
  return result;
}

std::vector<ByAxis> rotation_jacobian_by_axis(const AxisQuestion& question, int link) {
  std::vector<ByAxis> result(static_cast<std::size_t>(question.q.size()), ByAxis::Zero());
  const Tree<double>& tree = question.tree;
  if (!moves(tree, question.hinge, link)) return result;

  const MovedAxis moved_axis(question);
  for_each_hinge_to_base(tree, link, [&](int j) {
    result[tree[j].coordinate] += tree[j].ratio * moved_axis.axis_of(j);
  });
  return result;
}

}  // namespace thenar
