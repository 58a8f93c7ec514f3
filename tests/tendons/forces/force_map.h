#pragma once

/// Force of a pinned tip from tendon tensions, rebuilt from bare axes, on any scalar.
///
/// For fits and samplers: fixed sizes, no heap, axes as variables.

#include <array>

#include "base/spatial.h"

namespace thenar {

/// A hinge axis at the reference posture.
template <typename T>
struct Axis {
  Vec3<T> direction;  // unit (3)
  Vec3<T> point;      // any point of it [m] (3)
};

/// An axis near a reference, by the four numbers that a line has: tilts of its direction and
/// shifts of its point, both along e1 and e2.
/// @param frame  tangents() of the reference direction
/// @param by     tilt 1, tilt 2 [rad to first order], shift 1, shift 2 [m]; anything indexable
template <typename T, typename Four>
[[nodiscard]] Axis<T> moved_axis(const Axis<double>& reference, const Tangents& frame,
                                 const Four& by) {
  using std::sqrt;
  const T u = by[0], v = by[1], scale = T(1) / sqrt(T(1) + u * u + v * v);
  Axis<T> axis;
  for (int k = 0; k < 3; ++k) {
    axis.direction[k] = (reference.direction[k] + frame.e1[k] * u + frame.e2[k] * v) * scale;
    axis.point[k] = reference.point[k] + frame.e1[k] * by[2] + frame.e2[k] * by[3];
  }
  return axis;
}

/// R times the turn of a hinge by angle a, column by column, with  along = R d:
///   cos a  R e_k + (1 - cos a) d_k along + sin a  R (d x e_k).
/// Forced inline: the calls would cost a tenth of a force map.
template <typename T>
[[nodiscard]] inline __attribute__((always_inline)) Mat3<T> turned(const Mat3<T>& R,
                                                                   const Vec3<T>& along,
                                                                   const Vec3<T>& d, const T& a) {
  using std::cos;
  using std::sin;
  const T s = sin(a), c = cos(a);
  const Vec3<T> u = (T(1) - c) * along, sd = s * d;
  const auto x = R.col(0), y = R.col(1), z = R.col(2);
  Mat3<T> turned;
  turned.col(0) = c * x + d.x() * u + sd.z() * y - sd.y() * z;
  turned.col(1) = c * y + d.y() * u + sd.x() * z - sd.z() * x;
  turned.col(2) = c * z + d.z() * u + sd.y() * x - sd.x() * y;
  return turned;
}

/// Position Jacobian of the tip of a chain of N hinges in a row [m/rad] (3, N):
/// columns  axis x (tip - point), each where the hinge is now.
/// @param axes  from the base to the tip
/// @param tip   at the reference posture [m] (3)
/// @param q     (N) [rad]
template <typename T, std::size_t N, typename S>
[[nodiscard]] Eigen::Matrix<T, 3, N> serial_jacobian(
    const std::array<Axis<T>, N>& axes, const Vec3<T>& tip,
    const Eigen::Matrix<S, static_cast<int>(N), 1>& q) {
  std::array<Vec3<T>, N> direction, point;
  direction[0] = axes[0].direction;
  point[0] = axes[0].point;
  Mat3<T> R = rotation_about(axes[0].direction, T(q[0]));
  for (std::size_t i = 1; i < N; ++i) {
    // The point is fixed in the link before; only its distance from the last one turns.
    point[i] = point[i - 1] + R * (axes[i].point - axes[i - 1].point);
    direction[i] = R * axes[i].direction;
    R = turned(R, direction[i], axes[i].direction, T(q[i]));
  }
  const Vec3<T> p = point[N - 1] + R * (tip - axes[N - 1].point);
  Eigen::Matrix<T, 3, N> J;
  for (std::size_t i = 0; i < N; ++i) J.col(i) = direction[i].cross(p - point[i]);
  return J;
}

/// Tip force per unit tension.
template <typename T, int M>
struct ForceMap {
  Eigen::Matrix<T, M, 3> At;  // f = At' t; not finite if a square is 0  [N/N] (tendons, 3)
  Vec3<T> squares;            // of the columns of Q; one is 0 in a straight digit [m^2/rad^2] (3)
};

/// Solves  J' f = R' t  for f in least squares, for every unit tension at once.
///
/// By modified Gram-Schmidt on J' = Q U with orthogonal columns in Q and ones on U's diagonal, so
/// that errors grow with the condition of J and not with its square:  A = U^-1 (Q'Q)^-1 Q' R'.
/// @param J  tip position Jacobian                   (3, N) [m/rad]
/// @param R  moment arms -d(length)/dq, flexion +    (M, N) [m/rad]
/// Source: [ValeroCuevas1998] for the static model.
template <typename T, int N, int M, typename S>
[[nodiscard]] ForceMap<T, M> force_map(const Eigen::Matrix<T, 3, N>& J,
                                       const Eigen::Matrix<S, M, N>& R) {
  Eigen::Matrix<T, N, 3> Q = J.transpose();
  Mat3<T> U;
  Vec3<T> squares, inverse;
  for (int k = 0; k < 3; ++k) {
    squares[k] = Q.col(k).squaredNorm();
    inverse[k] = T(1) / squares[k];
    for (int l = k + 1; l < 3; ++l) {
      U(k, l) = Q.col(k).dot(Q.col(l)) * inverse[k];
      Q.col(l) -= U(k, l) * Q.col(k);
    }
  }
  Eigen::Matrix<T, M, 3> A = R.template cast<T>() * Q;  // transposed
  A.col(2) *= inverse[2];
  A.col(1) = A.col(1) * inverse[1] - U(1, 2) * A.col(2);
  A.col(0) = A.col(0) * inverse[0] - U(0, 1) * A.col(1) - U(0, 2) * A.col(2);
  return {A, squares};
}

}  // namespace thenar
