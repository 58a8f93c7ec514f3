#include "live/world/hand_joints.h"

#include <Eigen/Geometry>

#include "base/error.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/robot/robot_hand.h"

namespace thenar {
namespace {

constexpr double kMinColumnNorm = 1e-12;  // norm of a Jacobian column below which nothing moves
constexpr double kScrewTolerance = 1e-9;  // relative pitch below which a motion is a rotation [1]

/// Returns the Jacobian column of a coordinate at a link's origin: angular, then linear velocity,
/// in the base's frame.
Eigen::Matrix<double, 6, 1> jacobian_column(const Hand& hand, const Eigen::VectorXd& q, int link,
                                            int coordinate) {
  return hand.jacobian(q, link, Eigen::Vector3d::Zero()).col(coordinate);
}

/// Returns the first link that a coordinate moves, counted from the base; -1: none.
int first_moved_link(const Hand& hand, const Eigen::VectorXd& q, int coordinate) {
  const int links = static_cast<int>(hand.layout().parents.size());
  for (int link = 0; link < links; ++link)
    if (jacobian_column(hand, q, link, coordinate).norm() > kMinColumnNorm) return link;
  return -1;
}

/// Returns true if a link is `root` or a descendant of it.
bool is_in_subtree(const HandLayout& layout, int link, int root) {
  while (link > root) link = layout.parents[link];
  return link == root;
}

/// Returns the centre of the surface of a link, or else of its first descendant with a surface
/// [m] (3).
Eigen::Vector3d link_centre(const Hand& hand, int link) {
  const HandLayout& layout = hand.layout();
  // Find the surface of the first link in the subtree: links are numbered from the base.
  const LinkSurface* found = nullptr;
  for (const LinkSurface& surface : hand.surfaces()) {
    if (!is_in_subtree(layout, surface.link, link) || surface.solid->visual.empty()) continue;
    if (found == nullptr || surface.link < found->link) found = &surface;
  }
  // Return the centre of its bounding box.
  if (found == nullptr) return Eigen::Vector3d::Zero();
  const Eigen::Matrix3Xd& vertices = found->solid->visual.vertices;
  return (vertices.rowwise().minCoeff() + vertices.rowwise().maxCoeff()) / 2;
}

/// Computes the axis of a coordinate from the Jacobian of the first link that it moves.
HandJoint joint_of_coordinate(const Hand& hand, const Eigen::VectorXd& q, int coordinate,
                              int link) {
  HandJoint joint{coordinate, link};
  // Without angular velocity (w) the joint slides, with velocity v.
  const Eigen::Matrix<double, 6, 1> column = jacobian_column(hand, q, link, coordinate);
  const Eigen::Vector3d w = column.head<3>(), v = column.tail<3>();
  const Pose<double> X = hand.pose(q)[link];
  joint.slides = w.norm() <= kMinColumnNorm;
  // The axis of a prismatic joint runs through the centre of the link.
  const Eigen::Vector3d centre = link_centre(hand, link);
  if (joint.slides) {
    joint.axis = X.R.transpose() * v.normalized();
    joint.point = centre;
    return joint;
  }
  // A screw motion, with v along w, is not supported.
  require(std::abs(w.dot(v)) <= kScrewTolerance * w.norm() * std::max(v.norm(), w.norm()),
          "joint '{}' turns and slides at once", hand.layout().coordinates[coordinate]);
  // Compute the axis of rotation, and its point nearest to the centre.
  joint.axis = X.R.transpose() * w.normalized();
  const Eigen::Vector3d on_axis = X.inverse() * (X.p + w.cross(v) / w.squaredNorm());
  joint.point = on_axis + joint.axis * joint.axis.dot(centre - on_axis);
  return joint;
}

}  // namespace

std::vector<HandJoint> hand_joints(const Hand& hand) {
  const HandLayout& layout = hand.layout();
  // Evaluate at the open posture: nonlinear couplings hold only within the limits.
  const Eigen::VectorXd q = open_posture(layout);
  std::vector<HandJoint> joints;
  for (int c = 0; c < static_cast<int>(layout.coordinates.size()); ++c)
    if (const int link = first_moved_link(hand, q, c); link >= 0)
      joints.push_back(joint_of_coordinate(hand, q, c, link));
  return joints;
}

std::vector<JointCoupling> joint_couplings(const Hand& hand) {
  const HandLayout& layout = hand.layout();
  // Only the drives of robots couple joints.
  std::vector<JointCoupling> couplings(layout.coordinates.size());
  if (dynamic_cast<const RobotHand*>(&hand) == nullptr) return couplings;
  for (const Drive& drive : layout.drives)
    for (std::size_t i = 1; i < drive.moves.size(); ++i) {
      const DrivenCoordinate &first = drive.moves.front(), &other = drive.moves[i];
      if (other.coordinate != first.coordinate && first.ratio != 0)
        couplings[other.coordinate] = {first.coordinate, other.ratio / first.ratio};
    }
  return couplings;
}

}  // namespace thenar
