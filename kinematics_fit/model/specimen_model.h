#pragma once

/// Model of one specimen: a digit with its parameters set, for any scalar type.

#include <cmath>
#include <optional>
#include <vector>

#include "data/io/experiment.h"
#include "kinematics_fit/model/parameter.h"
#include "kinematics_fit/model/specimen_net.h"
#include "kinematics_fit/model/tip_constraint.h"

namespace thenar {

/// Digit as it was mounted in one experiment.
template <typename T>
struct SpecimenModel {
  TendonModel<T> digit;
  std::optional<SpecimenNet<T>> net;  // net that replaces a hood; empty: none
  VectorX<T> angle_error;             // angle error in all postures [rad] (coordinates)
  MatrixX<T> posture_error;  // additional angle error in each posture [rad] (coordinates, postures)
  T out_of_plane = T(0);     // length that scales out-of-plane moments [m]
  VectorX<T> gain;           // tension at the digit per stated tension [1] (muscles)
  MatrixX<T> unexplained;    // tip force that the geometry does not explain, per stated tension, in
                             // the tip's axes [1] (3, muscles)
  MatrixX<T> posture_unexplained;  // additional unexplained force in each posture, muscles of one
                                   // posture side by side [1] (3, muscles x postures)
  Vec3<T> sensor_tilt = Vec3<T>::Zero();  // rotation vector in digit axes [rad] (3)
};

/// Copies a model to another scalar type; all its numbers are constants.
template <typename T>
[[nodiscard]] SpecimenModel<T> cast_model(const TendonModel<double>& from, int postures) {
  // Copy topology and constants.
  SpecimenModel<T> to;
  to.digit.coordinates = from.coordinates;
  to.digit.tip_link = from.tip_link;
  to.digit.tip = from.tip.cast<T>();
  to.digit.tip_axes = from.tip_axes.cast<T>();
  to.digit.constant_arms = from.constant_arms.cast<T>();
  to.digit.pulls = from.pulls;
  to.digit.bends = from.bends;
  to.digit.knuckle = from.knuckle;
  to.digit.friction = from.friction.cast<T>();
  to.digit.hood = from.hood;
  // Convert hinges, paths and hood.
  for (const Hinge<double>& hinge : from.tree)
    to.digit.tree.push_back({hinge.parent, hinge.coordinate, hinge.ratio, hinge.offset,
                             hinge.direction.cast<T>(), hinge.point.cast<T>()});
  for (const TendonPath<double>& path : from.paths) {
    to.digit.paths.emplace_back();
    for (const PathNode<double>& node : path)
      to.digit.paths.back().push_back({node.link, node.p.cast<T>()});
  }
  for (const HoodShare<double>& share : from.hood_shares)
    to.digit.hood_shares.push_back(
        {share.muscle, share.side, T(share.into_hood), T(share.to_central), T(share.slope)});
  // Set no angle errors, and tensions as stated.
  to.angle_error = VectorX<T>::Zero(from.coordinates);
  to.posture_error = MatrixX<T>::Zero(from.coordinates, postures);
  to.gain = VectorX<T>::Ones(static_cast<Eigen::Index>(from.pulls.size()));
  to.unexplained = MatrixX<T>::Zero(3, to.gain.size());
  to.posture_unexplained = MatrixX<T>::Zero(3, to.gain.size() * postures);
  return to;
}

/// Shifts everything distal to hinge `i` along the bone that the hinge moves. Points on that bone
/// shift in proportion to their position along it.
template <typename T>
void lengthen_bone(const TendonModel<double>& from, int i, const T& by, TendonModel<T>& to) {
  const auto beyond = [&](int link) {
    while (link > i) link = from.tree[link].parent;
    return link == i;
  };
  // Find the end of the bone: the next hinge in distal direction, or the tip.
  Eigen::Vector3d end = from.tip;
  for (int next = static_cast<int>(from.tree.size()) - 1; next > i; --next)
    if (beyond(next) && (from.tree[next].point - from.tree[i].point).norm() > 1e-6)
      end = from.tree[next].point;
  // Shift of a point, in proportion to its position along the bone.
  const Eigen::Vector3d bone = end - from.tree[i].point;
  const double length = bone.norm();
  if (length == 0) return;
  const auto shift = [&](const Eigen::Vector3d& p) -> Vec3<T> {
    const double along = (p - from.tree[i].point).dot(bone) / (length * length);
    return (bone / length).cast<T>() * (by * T(std::min(1.0, std::max(0.0, along))));
  };
  // Shift hinges, path points and the tip distal to the hinge.
  for (std::size_t k = i + 1; k < from.tree.size(); ++k)
    if (beyond(static_cast<int>(k))) to.tree[k].point += shift(from.tree[k].point);
  for (std::size_t s = 0; s < from.paths.size(); ++s)
    for (std::size_t k = 0; k < from.paths[s].size(); ++k)
      if (beyond(from.paths[s][k].link)) to.paths[s][k].p += shift(from.paths[s][k].p);
  if (beyond(from.tip_link)) to.tip += shift(from.tip);
}

/// Sets one parameter of a model that still has the initial value of that parameter. Axis
/// directions are not normalised; normalise_axes() does so, which makes the two tilts a gnomonic
/// chart about the initial direction.
template <typename T>
void set_parameter(const TendonModel<double>& from, const Parameter& p, const T& value,
                   SpecimenModel<T>& to) {
  const auto along_digit = [&](int c) { return Vec3<T>(from.tip_axes.col(c).cast<T>() * value); };
  switch (p.kind) {
    case ParameterKind::kAxisDirection:
    case ParameterKind::kAxisPoint: {
      // Tilts add tangents to the direction, shifts add tangents or the axis itself to the point.
      const Eigen::Vector3d& d = from.tree[p.item].direction;
      const Tangents e = tangents(d);
      const Eigen::Vector3d along = p.component == 0 ? e.e1 : p.component == 1 ? e.e2 : d;
      Hinge<T>& hinge = to.digit.tree[p.item];
      (p.kind == ParameterKind::kAxisPoint ? hinge.point : hinge.direction) +=
          along.cast<T>() * value;
      break;
    }
    case ParameterKind::kPathPoint:
      to.digit.paths[p.item][p.point].p += along_digit(p.component);
      if (to.net) move_with_path(from.paths[p.item][p.point], along_digit(p.component), *to.net);
      break;
    case ParameterKind::kArm:
      to.digit.constant_arms(p.item, p.component) = value;
      break;
    case ParameterKind::kHoodEntry:
      to.digit.hood_shares[p.item].into_hood =
          shift_fraction(T(from.hood_shares[p.item].into_hood), value);
      break;
    case ParameterKind::kHoodCentral:
      to.digit.hood_shares[p.item].to_central =
          shift_fraction(T(from.hood_shares[p.item].to_central), value);
      break;
    case ParameterKind::kHoodSlope:
      to.digit.hood_shares[p.item].slope = value;
      break;
    case ParameterKind::kFriction:
      to.digit.friction[p.item] = value;
      break;
    case ParameterKind::kOutOfPlane:
      to.out_of_plane = value;
      break;
    case ParameterKind::kLength:
      lengthen_bone(from, p.item, value, to.digit);
      break;
    case ParameterKind::kTip:
      to.digit.tip += along_digit(p.component);
      break;
    case ParameterKind::kSensorTilt:
      to.sensor_tilt[p.component] = value;
      break;
    case ParameterKind::kAngle:
      to.angle_error[p.item] = value;
      break;
    case ParameterKind::kPostureAngle:
      to.posture_error(p.item, p.point) = value;
      break;
    case ParameterKind::kGain:
      to.gain[p.item] = value;
      break;
    case ParameterKind::kTipForce:
      to.unexplained(p.component, p.item) = value;
      break;
    case ParameterKind::kPostureForce:
      to.posture_unexplained(p.component, p.point * to.gain.size() + p.item) = value;
      break;
    case ParameterKind::kNetStiffness:
    case ParameterKind::kNetSlack:
    case ParameterKind::kNetPlace:
    case ParameterKind::kNetRadius:
    case ParameterKind::kNetEntry:
    case ParameterKind::kNetCentral:
    case ParameterKind::kNetSlope:
      set_net_parameter(from.tip_axes, p, value, *to.net);
      break;
  }
}

/// Normalises all axis directions.
template <typename T>
void normalise_axes(SpecimenModel<T>& model) {
  for (Hinge<T>& hinge : model.digit.tree) hinge.direction.normalize();
}

}  // namespace thenar
