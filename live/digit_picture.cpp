#include "live/digit_picture.h"

#include <utility>

namespace thenar {

DigitPicture::DigitPicture(const Subject& subject, const std::string& name,
                           std::shared_ptr<const DigitTendons> tendons, const Eigen::VectorXd& q,
                           DigitLook look)
    : tendons_(std::move(tendons)),
      bodies_(digit_bodies(subject, name, tendons_->digit(), look)),
      lines_(subject, name, tendons_) {
  const TendonDigit& digit = tendons_->digit();
  shape_.bodies = bodies_.bodies;
  shape_.joints = bodies_.joints;
  shape_.lines = lines_.lines();
  shape_.arrows = axis_arrows(digit.names.hinges);
  aim_at_digit(bodies_, digit.model, pose_tree(digit.model.tree, q), shape_);
}

LiveInstant DigitPicture::instant(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                  const NetEquilibrium& rest) const {
  // Compute the link poses once; bodies, lines and arrows follow from them.
  const TendonModel<double>& model = tendons_->digit().model;
  const TreeState<double> state = pose_tree(model.tree, q);
  LiveInstant instant;
  instant.bodies = body_poses(bodies_, state);
  instant.joints = hinge_angles(model, q);
  instant.line_points = lines_.points(state, rest);
  for (Eigen::Vector3d& p : instant.line_points) p = bodies_.X_WS * p;
  instant.tensions = lines_.tensions(q, t, rest);
  instant.arrows = axis_vectors(bodies_, model, state);
  return instant;
}

}  // namespace thenar
