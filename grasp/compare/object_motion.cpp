#include "grasp/compare/object_motion.h"

#include <vector>

#include <Eigen/SVD>

#include "grasp/closing/describe_grasp.h"
#include "grasp/quality/grasp_matrix.h"

namespace thenar {
namespace {

/// Computes velocities of the hand along unit components of contact forces (k, coordinates),
/// torques divided by the object's radius, from a torque map, which includes friction and torsion.
Eigen::MatrixXd unit_velocities(const std::vector<Contact>& contacts, const GraspBody& object,
                                const Eigen::MatrixXd& T) {
  Eigen::MatrixXd J = T.transpose();
  Eigen::Index row = 0;
  for (const Contact& contact : contacts) {
    ++row;
    for (int k = 0; k < 2 && contact.friction > 0; ++k) J.row(row++) /= contact.friction;
    if (contact.torsion > 0) J.row(row++) *= object.torque_scale / contact.torsion;
  }
  return J;
}

/// Returns the unit of drives; each has that of the first coordinate that it moves.
std::string unit_of(const Hand& hand, const Eigen::VectorXd& q, const Eigen::MatrixXd& ratios) {
  bool turning = false, sliding = false;
  for (Eigen::Index d = 0; d < ratios.cols(); ++d) {
    Eigen::Index first = 0;
    (void)(ratios.col(d).array() != 0).maxCoeff(&first);
    (slides(hand, q, static_cast<int>(first)) ? sliding : turning) = true;
  }
  return turning && sliding ? "m/rad or m/m" : sliding ? "m/m" : "m/rad";
}

}  // namespace

Eigen::MatrixXd drive_ratios(const Hand& hand, const Eigen::VectorXd& q) {
  const HandLayout& layout = hand.layout();
  const auto n = static_cast<Eigen::Index>(layout.coordinates.size());
  // A column for each drive that moves a coordinate.
  std::vector<Eigen::VectorXd> columns;
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(n);
  for (const Drive& drive : layout.drives) {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(n);
    for (const DrivenCoordinate& driven : drive.moves) column[driven.coordinate] = driven.ratio;
    if (column.isZero(0)) continue;
    moved += column.cwiseAbs();
    columns.push_back(column);
  }
  // A column for each other coordinate with an actuator.
  const Actuation actuation = hand.actuation(q);
  for (Eigen::Index c = 0; c < n; ++c)
    if (moved[c] == 0 && !actuation.B.row(c).isZero(0))
      columns.emplace_back(Eigen::VectorXd::Unit(n, c));
  Eigen::MatrixXd ratios(n, columns.size());
  for (std::size_t d = 0; d < columns.size(); ++d) ratios.col(d) = columns[d];
  return ratios;
}

ObjectMotion object_motion(const Hand& hand, const Eigen::VectorXd& q,
                           const std::vector<Contact>& contacts, const GraspBody& object,
                           const Eigen::MatrixXd& T) {
  const Eigen::MatrixXd ratios = drive_ratios(hand, q);
  const NoSlipMobility motion =
      no_slip_mobility(grasp_matrix(contacts, object.com, object.torque_scale),
                       unit_velocities(contacts, object, T) * ratios);
  Eigen::VectorXd speeds;
  if (motion.object.cols() > 0)
    speeds = Eigen::JacobiSVD<Eigen::MatrixXd>(motion.object).singularValues();
  const Manipulability found = manipulability(motion.object);
  speeds.tail(speeds.size() - found.rank).setZero();  // rounding errors
  return {found, speeds, static_cast<int>(ratios.cols()), unit_of(hand, q, ratios)};
}

}  // namespace thenar
