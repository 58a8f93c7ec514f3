#include "live/world/hand_joints.h"

#include <Eigen/Geometry>

#include "base/error.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/robot/robot_hand.h"

namespace thenar {
namespace {

constexpr double kStill = 1e-12;  // a column below this moves nothing [1] or [m]

/// The column of a coordinate at a link's origin: angular velocity and velocity, of the base.
Eigen::Matrix<double, 6, 1> column_of(const Hand& hand, const Eigen::VectorXd& q, int link,
                                      int coordinate) {
  return hand.jacobian(q, link, Eigen::Vector3d::Zero()).col(coordinate);
}

/// The link next to the base that a coordinate moves; -1: none. Parents come before children.
int first_moved_link(const Hand& hand, const Eigen::VectorXd& q, int coordinate) {
  const int links = static_cast<int>(hand.layout().parents.size());
  for (int link = 0; link < links; ++link)
    if (column_of(hand, q, link, coordinate).norm() > kStill) return link;
  return -1;
}

/// Returns true if a link is `root` or hangs on it.
bool hangs_on(const HandLayout& layout, int link, int root) {
  while (link > root) link = layout.parents[link];
  return link == root;
}

/// Middle of the surface of a link, or where it has none of the first link beyond that has one
/// [m] (3)
Eigen::Vector3d middle_of_link(const Hand& hand, int link) {
  const HandLayout& layout = hand.layout();
  // Prefer the surface nearest to the joint: links are numbered from the base.
  const LinkSurface* found = nullptr;
  for (const LinkSurface& surface : hand.surfaces()) {
    if (!hangs_on(layout, surface.link, link) || surface.solid->visual.empty()) continue;
    if (found == nullptr || surface.link < found->link) found = &surface;
  }
  if (found == nullptr) return Eigen::Vector3d::Zero();
  const Eigen::Matrix3Xd& vertices = found->solid->visual.vertices;
  return (vertices.rowwise().minCoeff() + vertices.rowwise().maxCoeff()) / 2;
}

HandJoint joint_at(const Hand& hand, const Eigen::VectorXd& q, int coordinate, int link) {
  HandJoint joint{coordinate, link};
  // The column of the Jacobian tells turning (w) from sliding (v).
  const Eigen::Matrix<double, 6, 1> column = column_of(hand, q, link, coordinate);
  const Eigen::Vector3d w = column.head<3>(), v = column.tail<3>();
  const Pose<double> X = hand.pose(q)[link];
  joint.slides = w.norm() <= kStill;
  // Along the way of a slide, through the middle of what slides.
  const Eigen::Vector3d middle = middle_of_link(hand, link);
  if (joint.slides) {
    joint.axis = X.R.transpose() * v.normalized();
    joint.point = middle;
    return joint;
  }
  // A screw motion has v along w, and no axis in the sense of a joint.
  require(std::abs(w.dot(v)) <= 1e-9 * w.norm() * std::max(v.norm(), w.norm()),
          "joint '{}' turns and slides at once", hand.layout().coordinates[coordinate]);
  // The axis of a turn, at the point nearest to what turns.
  joint.axis = X.R.transpose() * w.normalized();
  const Eigen::Vector3d on_axis = X.inverse() * (X.p + w.cross(v) / w.squaredNorm());
  joint.point = on_axis + joint.axis * joint.axis.dot(middle - on_axis);
  return joint;
}

}  // namespace

std::vector<HandJoint> hand_joints(const Hand& hand) {
  const HandLayout& layout = hand.layout();
  // Within the limits, where curved couplings hold.
  const Eigen::VectorXd q = open_posture(layout);
  std::vector<HandJoint> joints;
  for (int c = 0; c < static_cast<int>(layout.coordinates.size()); ++c)
    if (const int link = first_moved_link(hand, q, c); link >= 0)
      joints.push_back(joint_at(hand, q, c, link));
  return joints;
}

std::vector<JointLead> joint_leads(const Hand& hand) {
  const HandLayout& layout = hand.layout();
  // Only robots couple joints by a drive; tendons of human hands do not.
  std::vector<JointLead> leads(layout.coordinates.size());
  if (dynamic_cast<const RobotHand*>(&hand) == nullptr) return leads;
  for (const Drive& drive : layout.drives)
    for (std::size_t i = 1; i < drive.moves.size(); ++i) {
      const DrivenCoordinate &first = drive.moves.front(), &other = drive.moves[i];
      if (other.coordinate != first.coordinate && first.ratio != 0)
        leads[other.coordinate] = {first.coordinate, other.ratio / first.ratio};
    }
  return leads;
}

}  // namespace thenar
