#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "base/numbers.h"
#include "grasp/robot/approach_direction.h"
#include "grasp/robot/digit_motion.h"
#include "grasp/robot/posed_surfaces.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Minimum cosine of the approach to the direction from the palm to half-closed tips [1]
constexpr double kMinForwardCosine = 0.96;
constexpr double kMinHingeDistance = 1e-3;  // distance above which two hinges are distinct [m]
constexpr int kOpeningPostures = 20;        // number of postures between closed and open
// Rotation or motion per unit of a drive up to which it counts as none [1], [m]
constexpr double kNoMotionOfDrive = 1e-9;
constexpr double kMinPalmOffset = 1e-6;  // offset of the tips up to which it has no direction [m]

/// Returns a rotation whose third column is a direction, and whose first is near `side`. (3, 3)
Eigen::Matrix3d frame_along(const Vector3d& direction, const Vector3d& side) {
  Eigen::Index smallest = 0;
  direction.cwiseAbs().minCoeff(&smallest);
  const bool parallel = side.cross(direction).norm() < 0.1;
  Eigen::Matrix3d R;
  R.col(0) =
      perpendicular_direction(parallel ? Vector3d(Vector3d::Unit(smallest)) : side, direction);
  R.col(1) = direction.cross(R.col(0));
  R.col(2) = direction;
  return R;
}

}  // namespace

/// Returns the axes of a digit's hinges that closing drives move; its slide, if it has none. (3,
/// axes)
Matrix3Xd DigitMotion::closing_axes(const HandDigit& digit, std::size_t option,
                                    const VectorXd& q) const {
  if (slides_only(digit, option)) return curl_motion(digit, option);
  const RobotHand& hand = digits_.grip().hand();
  // Coordinates that closing drives move.
  std::vector<bool> closing(hand.layout().coordinates.size(), false);
  for (std::size_t d = 0; d < digits_.drives().size(); ++d)
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves)
      if (options_[option].speed[d] != 0) closing[driven.coordinate] = true;
  // Axes of their hinges, from the tip inwards.
  std::vector<Matrix3Xd> axes;
  for (const int link : digits_.links_of(digit))
    if (!hand.is_prismatic(link) && closing[hand.coordinate_of(link)])
      axes.emplace_back(hand.axis(q, link));
  return join_columns(axes);
}

/// Returns whether a digit closes by translation alone.
bool DigitMotion::slides_only(const HandDigit& digit, std::size_t option) const {
  const auto only_translates = [&](int drive) {
    return digits_.tip_rotation(drive, digit).norm() < kNoMotionOfDrive;
  };
  const auto is_slide = [&](int link) { return digits_.grip().hand().is_prismatic(link); };
  return !curl_motion(digit, option).isZero(0) && all_of(digit.curls, only_translates) &&
         all_of(digits_.links_of(digit), is_slide);
}

/// Returns the approach direction near a rough one: perpendicular to the axes about which digits
/// close, along faces of sliding jaws or of the palm, or through the middle of two parallel hinges.
/// (3)
Vector3d DigitMotion::approach_near(const Vector3d& rough, std::size_t option,
                                    const ClosingAxes& axes,
                                    const std::vector<Pose<double>>& links) const {
  // The axes span a plane: their normal.
  if (axes.normal) {
    const double along = axes.normal->dot(rough);
    if (std::abs(along) >= kMinForwardCosine) return std::copysign(1.0, along) * *axes.normal;
  }
  // Faces of sliding jaws, then those of the palm.
  const Vector3d near = axes.line ? perpendicular_direction(rough, *axes.line) : rough;
  std::vector<std::size_t> sliding;
  for (const HandDigit& digit : digits_.digits())
    for (std::size_t s = 0; s < digits_.grip().surfaces().size(); ++s)
      if (digits_.grip().surfaces()[s].digit == digit.name && slides_only(digit, option))
        sliding.push_back(s);
  for (const std::vector<std::size_t>& surfaces : {sliding, palm_surfaces(digits_.grip())})
    if (const auto found = facing_direction(faces_of(digits_.grip(), surfaces, links), near,
                                            kMinForwardCosine, axes.line))
      return *found;
  // Perpendicular to the line between two parallel hinges.
  if (axes.line && digits_.digits().size() == 2) {
    const Vector3d middle = (digits_.digits()[1].root - digits_.digits()[0].root).cross(*axes.line);
    const double along = middle.normalized().dot(near);
    if (middle.norm() > kMinHingeDistance && std::abs(along) >= kMinForwardCosine)
      return std::copysign(1.0, along) * middle.normalized();
  }
  return near;
}

PalmApproach DigitMotion::forward_approach(std::size_t option) const {
  const VectorXd q = half_closed_posture(option);
  const std::vector<Pose<double>> links = digits_.grip().hand().pose(q);
  // Rough direction, from the centre of the palm towards the tips.
  const Eigen::Matrix3d hand = Eigen::Matrix3d::Identity();
  Vector3d ends = Vector3d::Zero();
  for (const HandDigit& digit : digits_.digits())
    ends += box_of(digits_.grip(), {digit.last}, links, hand).center() /
            static_cast<double>(digits_.digits().size());
  const Eigen::AlignedBox3d palm =
      box_of(digits_.grip(), palm_surfaces(digits_.grip()), links, hand);
  const Vector3d centre = palm.isEmpty() ? Vector3d(0, 0, 0) : Vector3d(palm.center());
  const Vector3d rough = ends - centre;
  // Refine it by faces near it, and by axes where digits close against each other.
  std::vector<Matrix3Xd> all;
  if (!roles(option).palm)
    for (const HandDigit& digit : digits_.digits()) all.push_back(closing_axes(digit, option, q));
  const Matrix3Xd axes = join_columns(all);
  PalmApproach approach;
  if (rough.norm() > kMinPalmOffset)
    approach.direction =
        snap_to_axis(approach_near(rough.normalized(), option, find_closing_axes(axes), links));
  // The point of approach is at the end of the palm's box.
  const Eigen::Matrix3d R =
      frame_along(approach.direction, axes.cols() > 0 ? Vector3d(axes.col(0)) : Vector3d::Zero());
  const Eigen::AlignedBox3d box = box_of(digits_.grip(), palm_surfaces(digits_.grip()), links, R);
  if (!box.isEmpty()) approach.point = R * (box.center() + Vector3d(0, 0, box.sizes().z() / 2));
  return approach;
}

/// Returns the direction in which the end of the only digit moves as it closes; zero: it is at
/// rest. (3)
Vector3d DigitMotion::last_tip_motion(std::size_t option, const VectorXd& q) const {
  const SampledSurface& end = digits_.grip().surfaces()[digits_.digits().front().last];
  Vector3d sum = Vector3d::Zero();
  if (end.link < 0) return sum;
  const auto J = digits_.grip().hand().jacobian(q, end.link, end.centre);
  for (std::size_t d = 0; d < digits_.drives().size(); ++d)
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves)
      sum += options_[option].speed[d] * driven.ratio * J.col(driven.coordinate).tail<3>();
  return sum.norm() > kNoMotionOfDrive ? Vector3d(sum.normalized()) : Vector3d::Zero();
}

/// Direction of a jaw, the only digit, perpendicular to its closing motion.
struct DigitMotion::JawPath {
  Vector3d direction;  // unit (3)
  bool has_face;       // whether a face of the palm is near it
};

/// Finds the direction from the palm to the end by approach_near(); nothing if one is in line with
/// the other.
std::optional<DigitMotion::JawPath> DigitMotion::jaw_path(std::size_t option,
                                                          const VectorXd& q) const {
  const std::vector<Pose<double>> links = digits_.grip().hand().pose(q);
  const HandDigit& digit = digits_.digits().front();
  const Vector3d motion = last_tip_motion(option, q);
  const Matrix3Xd palm = points_of(digits_.grip(), palm_surfaces(digits_.grip()), links),
                  end = points_of(digits_.grip(), {digit.last}, links);
  if (palm.cols() == 0 || motion.isZero(0)) return {};
  // Offset of the end from the palm, perpendicular to the closing motion.
  const Vector3d middle = (palm.rowwise().minCoeff() + palm.rowwise().maxCoeff()) / 2;
  const Vector3d inner = (end.rowwise().minCoeff() + end.rowwise().maxCoeff()) / 2;
  if ((inner - middle).cross(motion).norm() < kMinPalmOffset) return {};
  const Vector3d rough = perpendicular_direction(inner - middle, motion);
  const ClosingAxes axes = find_closing_axes(closing_axes(digit, option, q));
  const auto face = facing_direction(faces_of(digits_.grip(), palm_surfaces(digits_.grip()), links),
                                     rough, kMinForwardCosine, axes.line);
  return JawPath{snap_to_axis(approach_near(rough, option, axes, links)), face.has_value()};
}

std::optional<FixedJaw> DigitMotion::fixed_jaw(std::size_t option, const VectorXd& open) const {
  // The closed posture or, if the jaw could close beyond the fixed one, the last one along a face.
  const VectorXd shut = closed_posture(option);
  VectorXd q = shut;
  std::optional<JawPath> path = jaw_path(option, q);
  if (!path) return {};
  for (int k = 1; k <= kOpeningPostures && !path->has_face; ++k) {
    const VectorXd other = shut + (open - shut) * k / kOpeningPostures;
    if (const auto there = jaw_path(option, other); there && there->has_face)
      q = other, path = there;
  }
  const Vector3d direction = path->direction;
  const std::vector<Pose<double>> links = digits_.grip().hand().pose(q);
  const Matrix3Xd palm = points_of(digits_.grip(), palm_surfaces(digits_.grip()), links),
                  end = points_of(digits_.grip(), {digits_.digits().front().last}, links);
  // Height of the palm's face in front of the outer half of the end.
  const Vector3d out = perpendicular_direction(-last_tip_motion(option, q), direction),
                 side = direction.cross(out);
  const Eigen::RowVectorXd along_end = direction.transpose() * end,
                           beside_end = side.transpose() * end;
  const double half = (along_end.minCoeff() + along_end.maxCoeff()) / 2;
  double face = -kInfinity;
  for (const auto& p : palm.colwise())
    if (const double ahead = direction.dot(p), beside = side.dot(p);
        ahead >= half && ahead <= along_end.maxCoeff() && beside >= beside_end.minCoeff() &&
        beside <= beside_end.maxCoeff())
      face = std::max(face, out.dot(p));
  if (face == -kInfinity) return {};
  // Distance from the face to the outer half of the open jaw; to all of a sliding one.
  const Matrix3Xd away =
      points_of(digits_.grip(), {digits_.digits().front().last}, digits_.grip().hand().pose(open));
  const Eigen::RowVectorXd lever =
      (away.colwise() - digits_.digits().front().root).colwise().norm();
  const bool slides = slides_only(digits_.digits().front(), option);
  const double min_lever = slides ? 0 : (lever.minCoeff() + lever.maxCoeff()) / 2;
  double nearest = kInfinity;
  for (Eigen::Index i = 0; i < away.cols(); ++i)
    if (lever[i] >= min_lever) nearest = std::min(nearest, out.dot(away.col(i)) - face);
  // The jaw, with the point of its face at the end of the palm.
  FixedJaw jaw;
  jaw.direction = direction;
  jaw.opening_direction = out;
  jaw.face = direction * (direction.transpose() * palm).maxCoeff() + out * face +
             side * (beside_end.minCoeff() + beside_end.maxCoeff()) / 2;
  jaw.opening = std::max(nearest, 0.0);
  return jaw;
}

}  // namespace thenar
