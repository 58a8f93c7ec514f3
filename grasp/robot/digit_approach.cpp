#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "grasp/robot/approach_direction.h"
#include "grasp/robot/digit_motion.h"
#include "grasp/robot/posed_surfaces.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Least cosine of the approach to the direction from the palm to half-closed ends [1].
constexpr double kNearAhead = 0.96;
constexpr double kTwoHinges = 1e-3;   // least distance of hinges that are two [m]
constexpr int kOpeningPostures = 20;  // postures between closed and open that are looked at
constexpr double kNoSpin = 1e-9;      // rotation per unit of a drive that counts as none [1]

/// Rotation whose third column is a direction, and whose first is across it, near `side`. (3, 3)
Eigen::Matrix3d frame_along(const Vector3d& direction, const Vector3d& side) {
  Eigen::Index least = 0;
  direction.cwiseAbs().minCoeff(&least);
  const bool parallel = side.cross(direction).norm() < 0.1;
  Eigen::Matrix3d R;
  R.col(0) = across(parallel ? Vector3d(Vector3d::Unit(least)) : side, direction);
  R.col(1) = direction.cross(R.col(0));
  R.col(2) = direction;
  return R;
}

}  // namespace

/// Axes of the hinges of a digit that closing drives move; of a digit without, its slide. (3, axes)
Matrix3Xd DigitMotion::closing_axes(const HandDigit& digit, std::size_t option,
                                    const VectorXd& q) const {
  if (slides_only(digit, option)) return curl_way(digit, option);
  const RobotHand& hand = digits_.grip().hand();
  std::vector<bool> closing(hand.layout().coordinates.size(), false);
  for (std::size_t d = 0; d < digits_.drives().size(); ++d)
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves)
      if (options_[option].speed[d] != 0)
        closing[static_cast<std::size_t>(driven.coordinate)] = true;
  std::vector<Matrix3Xd> axes;
  for (int link = digits_.grip().surfaces()[digit.last].link; link >= 0;
       link = hand.layout().parents[static_cast<std::size_t>(link)])
    if (!hand.is_prismatic(link) && closing[static_cast<std::size_t>(hand.coordinate_of(link))])
      axes.emplace_back(hand.axis(q, link));
  return side_by_side(axes);
}

/// Returns whether a digit closes along slides alone.
bool DigitMotion::slides_only(const HandDigit& digit, std::size_t option) const {
  const auto is_slide = [&](int link) { return digits_.grip().hand().is_prismatic(link); };
  bool any_hinge = false;
  for (int link = digits_.grip().surfaces()[digit.last].link; link >= 0;
       link = digits_.grip().hand().layout().parents[static_cast<std::size_t>(link)])
    any_hinge = any_hinge || !is_slide(link);
  return !curl_way(digit, option).isZero(0) &&
         std::all_of(digit.curls.begin(), digit.curls.end(),
                     [&](int d) {
                       return digits_.spin(static_cast<std::size_t>(d), digit).norm() < kNoSpin;
                     }) &&
         !any_hinge;
}

/// The direction of approach near a rough one: across the axes about which digits close, along
/// faces of jaws that slide or of the palm, or through the middle of two parallel hinges. (3)
Vector3d DigitMotion::approach_near(const Vector3d& rough, std::size_t option,
                                    const ClosingAxes& axes,
                                    const std::vector<Pose<double>>& links) const {
  // The only direction across all axes.
  if (axes.normal) {
    const double along = axes.normal->dot(rough);
    if (std::abs(along) >= kNearAhead) return std::copysign(1.0, along) * *axes.normal;
  }
  // Faces of sliding jaws, then those of the palm.
  const Vector3d near = axes.line ? across(rough, *axes.line) : rough;
  std::vector<std::size_t> sliding;
  for (const HandDigit& digit : digits_.all())
    for (std::size_t s = 0; s < digits_.grip().surfaces().size(); ++s)
      if (digits_.grip().surfaces()[s].digit == digit.name && slides_only(digit, option))
        sliding.push_back(s);
  for (const std::vector<std::size_t>& surfaces : {sliding, palm_surfaces(digits_.grip())})
    if (const auto found = facing_direction(faces_of(digits_.grip(), surfaces, links), near,
                                            kNearAhead, axes.line))
      return *found;
  // Across the line between two parallel hinges.
  if (axes.line && digits_.all().size() == 2) {
    const Vector3d middle = (digits_.all()[1].root - digits_.all()[0].root).cross(*axes.line);
    const double along = middle.normalized().dot(near);
    if (middle.norm() > kTwoHinges && std::abs(along) >= kNearAhead)
      return std::copysign(1.0, along) * middle.normalized();
  }
  return near;
}

PalmApproach DigitMotion::ahead(std::size_t option) const {
  const VectorXd q = half_closed(option);
  const std::vector<Pose<double>> links = digits_.grip().hand().pose(q);
  // Roughly from the centre of the palm towards the ends.
  const Eigen::Matrix3d hand = Eigen::Matrix3d::Identity();
  Vector3d ends = Vector3d::Zero();
  for (const HandDigit& digit : digits_.all())
    ends += box_of(digits_.grip(), {digit.last}, links, hand).center() /
            static_cast<double>(digits_.all().size());
  const Eigen::AlignedBox3d palm =
      box_of(digits_.grip(), palm_surfaces(digits_.grip()), links, hand);
  const Vector3d centre = palm.isEmpty() ? Vector3d(0, 0, 0) : Vector3d(palm.center());
  const Vector3d rough = ends - centre;
  // Along what faces near it tell, and axes where digits close at each other.
  std::vector<Matrix3Xd> all;
  if (!roles(option).palm)
    for (const HandDigit& digit : digits_.all()) all.push_back(closing_axes(digit, option, q));
  const Matrix3Xd axes = side_by_side(all);
  PalmApproach approach;
  if (rough.norm() > 1e-6)
    approach.direction =
        without_rounding(approach_near(rough.normalized(), option, find_closing_axes(axes), links));
  // From the end of the palm's box.
  const Eigen::Matrix3d R =
      frame_along(approach.direction, axes.cols() > 0 ? Vector3d(axes.col(0)) : Vector3d::Zero());
  const Eigen::AlignedBox3d box = box_of(digits_.grip(), palm_surfaces(digits_.grip()), links, R);
  if (!box.isEmpty()) approach.point = R * (box.center() + Vector3d(0, 0, box.sizes().z() / 2));
  return approach;
}

/// Direction in which the end of the only digit moves as it closes, from a posture; zero: none. (3)
Vector3d DigitMotion::last_way(std::size_t option, const VectorXd& q) const {
  const SampledSurface& end = digits_.grip().surfaces()[digits_.all().front().last];
  Vector3d sum = Vector3d::Zero();
  if (end.link < 0) return sum;
  const auto J = digits_.grip().hand().jacobian(q, end.link, end.centre);
  for (std::size_t d = 0; d < digits_.drives().size(); ++d)
    for (const DrivenCoordinate& driven : digits_.drives()[d].moves)
      sum += options_[option].speed[d] * driven.ratio * J.col(driven.coordinate).tail<3>();
  return sum.norm() > kNoSpin ? Vector3d(sum.normalized()) : Vector3d::Zero();
}

/// Direction of a jaw, the only digit, across the way in which it closes.
struct DigitMotion::JawWay {
  Vector3d direction;  // unit (3)
  bool faced;          // whether a face of the palm is near it
};

/// Returns the way from the palm to the end, as approach_near(); none: one lies in the way of the
/// other.
std::optional<DigitMotion::JawWay> DigitMotion::jaw_way(std::size_t option,
                                                        const VectorXd& q) const {
  const std::vector<Pose<double>> links = digits_.grip().hand().pose(q);
  const HandDigit& digit = digits_.all().front();
  const Vector3d way = last_way(option, q);
  const Matrix3Xd palm = points_of(digits_.grip(), palm_surfaces(digits_.grip()), links),
                  end = points_of(digits_.grip(), {digit.last}, links);
  if (palm.cols() == 0 || way.isZero(0)) return {};
  const Vector3d middle = (palm.rowwise().minCoeff() + palm.rowwise().maxCoeff()) / 2;
  const Vector3d inner = (end.rowwise().minCoeff() + end.rowwise().maxCoeff()) / 2;
  if ((inner - middle).cross(way).norm() < 1e-6) return {};
  const Vector3d rough = across(inner - middle, way);
  const ClosingAxes axes = find_closing_axes(closing_axes(digit, option, q));
  const auto face = facing_direction(faces_of(digits_.grip(), palm_surfaces(digits_.grip()), links),
                                     rough, kNearAhead, axes.line);
  return JawWay{without_rounding(approach_near(rough, option, axes, links)), face.has_value()};
}

std::optional<FixedJaw> DigitMotion::fixed_jaw(std::size_t option, const VectorXd& open) const {
  // Closed, or, where a jaw could close beyond the fixed one, as far as it lies along a face of it.
  const VectorXd shut = closed(option);
  VectorXd q = shut;
  std::optional<JawWay> way = jaw_way(option, q);
  if (!way) return {};
  for (int k = 1; k <= kOpeningPostures && !way->faced; ++k) {
    const VectorXd other = shut + (open - shut) * k / kOpeningPostures;
    if (const auto there = jaw_way(option, other); there && there->faced) q = other, way = there;
  }
  const Vector3d direction = way->direction;
  const std::vector<Pose<double>> links = digits_.grip().hand().pose(q);
  const Matrix3Xd palm = points_of(digits_.grip(), palm_surfaces(digits_.grip()), links),
                  end = points_of(digits_.grip(), {digits_.all().front().last}, links);
  // The face of the palm before the outer half of the end.
  const Vector3d out = across(-last_way(option, q), direction), side = direction.cross(out);
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
  // The outer half of the open jaw; all of one that slides.
  const Matrix3Xd away =
      points_of(digits_.grip(), {digits_.all().front().last}, digits_.grip().hand().pose(open));
  const Eigen::RowVectorXd lever = (away.colwise() - digits_.all().front().root).colwise().norm();
  const bool slides = slides_only(digits_.all().front(), option);
  const double least = slides ? 0 : (lever.minCoeff() + lever.maxCoeff()) / 2;
  double nearest = kInfinity;
  for (Eigen::Index i = 0; i < away.cols(); ++i)
    if (lever[i] >= least) nearest = std::min(nearest, out.dot(away.col(i)) - face);
  FixedJaw jaw;
  jaw.direction = direction;
  jaw.out = out;
  jaw.face = direction * (direction.transpose() * palm).maxCoeff() + out * face +
             side * (beside_end.minCoeff() + beside_end.maxCoeff()) / 2;
  jaw.opening = std::max(nearest, 0.0);
  return jaw;
}

}  // namespace thenar
