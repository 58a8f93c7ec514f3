#include "base/spatial.h"

namespace thenar {

template struct Pose<double>;

Wrench& Wrench::operator+=(const Wrench& b) {
  moment += b.moment;
  force += b.force;
  return *this;
}

Wrench wrench_of_force(const Eigen::Vector3d& p, const Eigen::Vector3d& f) {
  return {p.cross(f), f};
}

Tangents tangents(const Eigen::Vector3d& d) {
  const double sign = std::copysign(1.0, d.z());
  const double a = -1.0 / (sign + d.z()), b = d.x() * d.y() * a;
  return {{1 + sign * d.x() * d.x() * a, sign * b, -sign * d.x()},
          {b, sign + d.y() * d.y() * a, -d.y()}};
}

Eigen::Matrix3d basis_along(const Eigen::Vector3d& d) {
  const Tangents across = tangents(d);
  Eigen::Matrix3d R;
  R << across.e1, across.e2, d;
  return R;
}

Pose<double> frame_with_z(const Eigen::Vector3d& direction, const Eigen::Vector3d& point) {
  return {basis_along(direction), point};
}

}  // namespace thenar
