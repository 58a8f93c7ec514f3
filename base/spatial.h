#pragma once

/// Rigid motions on any scalar (double, Ceres' Jet, or a vector of lanes), and wrenches.

#include <cmath>
#include <iterator>
#include <type_traits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace thenar {

template <typename T>
using Vec3 = Eigen::Matrix<T, 3, 1>;
template <typename T>
using Mat3 = Eigen::Matrix<T, 3, 3>;
template <typename T>
using VectorX = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <typename T>
using MatrixX = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// Returns the vectors that a function makes of each entry of a list as columns (rows, entries).
template <typename List, typename Make>
[[nodiscard]] auto as_columns(const List& list, const Make& make) {
  using Column = std::decay_t<decltype(make(*std::begin(list)))>;
  constexpr int rows = Column::RowsAtCompileTime;
  Eigen::Matrix<typename Column::Scalar, rows, Eigen::Dynamic> columns(rows, std::size(list));
  Eigen::Index i = 0;
  for (const auto& each : list) columns.col(i++) = make(each);
  return columns;
}

/// Returns the vectors of a list as columns (rows, entries).
template <typename Vector>
[[nodiscard]] auto as_columns(const std::vector<Vector>& list) {
  return as_columns(list, [](const Vector& each) -> const Vector& { return each; });
}

/// Appends a column to a matrix.
template <typename Matrix, typename Column>
void append_column(Matrix& matrix, const Column& column) {
  matrix.conservativeResize(column.size(), matrix.cols() + 1);
  matrix.rightCols(1) = column;
}

/// Appends an entry to a vector.
template <typename Vector>
void append_entry(Vector& vector, double entry) {
  vector.conservativeResize(vector.size() + 1);
  vector(vector.size() - 1) = entry;
}

/// Rigid transform X_AB from coordinates of frame B to those of frame A:  p_A = R_AB p_B + p_AB.
template <typename T>
struct Pose {
  Mat3<T> R = Mat3<T>::Identity();  // rotation R_AB                    (3, 3)
  Vec3<T> p = Vec3<T>::Zero();      // origin of B in A              [m] (3)

  [[nodiscard]] Vec3<T> operator*(const Vec3<T>& point) const { return R * point + p; }
  [[nodiscard]] Pose operator*(const Pose& b) const;
  [[nodiscard]] Pose inverse() const;
};

template <typename T>
Pose<T> Pose<T>::operator*(const Pose& b) const {
  return {R * b.R, R * b.p + p};
}
template <typename T>
Pose<T> Pose<T>::inverse() const {
  return {R.transpose(), -(R.transpose() * p)};
}
extern template struct Pose<double>;  // in spatial.cpp, as most files multiply poses

/// Returns the rotation by Rodrigues' formula  R = I + sin(a) [d] + (1 - cos(a)) [d]^2.
/// @param d  unit axis (3);  @param a  angle [rad]
template <typename T>
[[nodiscard]] Mat3<T> rotation_about(const Vec3<T>& d, const T& a) {
  using std::cos;
  using std::sin;
  // Rodrigues' formula: R = c 1 + s [d]x + (1 - c) d d'.
  const T s = sin(a), c = cos(a), v = T(1) - c;
  Mat3<T> R;
  R << c + v * d.x() * d.x(), v * d.x() * d.y() - s * d.z(), v * d.x() * d.z() + s * d.y(),
      v * d.x() * d.y() + s * d.z(), c + v * d.y() * d.y(), v * d.y() * d.z() - s * d.x(),
      v * d.x() * d.z() - s * d.y(), v * d.y() * d.z() + s * d.x(), c + v * d.z() * d.z();
  return R;
}

/// Returns the motion of a hinge: a rotation by `a` about the axis with unit direction `d` through
/// `point`.
template <typename T>
[[nodiscard]] Pose<T> screw_motion(const Vec3<T>& d, const Vec3<T>& point, const T& a) {
  const Mat3<T> R = rotation_about(d, a);
  return {R, point - R * point};
}

/// Moment and force on a body. As six numbers the moment comes first.
struct Wrench {
  Eigen::Vector3d moment{0, 0, 0};  // moment about a stated point [N m] (3)
  Eigen::Vector3d force{0, 0, 0};   // [N] (3)

  Wrench& operator+=(const Wrench& b);
};

/// Returns the wrench about the origin of a force at a point.
/// @param p  point [m] (3);  @param f  force [N] (3)
[[nodiscard]] Wrench wrench_of_force(const Eigen::Vector3d& p, const Eigen::Vector3d& f);

/// Two unit vectors that complete `d` to a right-handed frame (e1, e2, d). Source: [Duff2017]:
/// continuous except at d.z = 0-, exact to rounding.
struct Tangents {
  Eigen::Vector3d e1;  // first tangent  (3)
  Eigen::Vector3d e2;  // second tangent (3)
};
[[nodiscard]] Tangents tangents(const Eigen::Vector3d& d);

/// Returns the rotation to the frame (e1, e2, d) of the tangents of `d`. (3, 3)
[[nodiscard]] Eigen::Matrix3d basis_along(const Eigen::Vector3d& d);

/// Returns a frame at a point whose axes are the tangents of a unit direction and, as z, the
/// direction itself.
[[nodiscard]] Pose<double> frame_with_z(const Eigen::Vector3d& direction,
                                        const Eigen::Vector3d& point);

}  // namespace thenar
