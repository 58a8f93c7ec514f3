#pragma once

/// Distance between two joint axes, on any scalar.

#include "hand/chain.h"

namespace thenar {

/// Sine below which two axes count as parallel: 0.06 degrees [1].
inline constexpr double kParallel = 1e-3;

/// Computes the squared length of the common normal of two hinges in the reference posture [m^2],
///   d^2 = ((w . n)^2 + e^2 |w_perp|^2) / (|n|^2 + e^2),   n = a x b,  w = q - p,  e = kParallel,
/// which changes smoothly into the perpendicular distance |w_perp| where axes become parallel and
/// the common normal loses its direction. The square is differentiable also where axes meet.
/// @param first   hinge with axis through p along a, |a| = 1  [m], [1]
/// @param second  hinge with axis through q along b, |b| = 1  [m], [1]
/// @return        d^2, not negative [m^2]
template <typename T>
[[nodiscard]] T squared_axis_distance(const Hinge<T>& first, const Hinge<T>& second) {
  const T e2(kParallel * kParallel);
  const Vec3<T> w = second.point - first.point;
  const Vec3<T> n = first.direction.cross(second.direction);
  const Vec3<T> w_perp = w - first.direction * first.direction.dot(w);
  const T along = w.dot(n);
  return (along * along + e2 * w_perp.squaredNorm()) / (n.squaredNorm() + e2);
}

}  // namespace thenar
