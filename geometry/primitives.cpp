#include "geometry/primitives.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

Eigen::AlignedBox3d box_of(const Vector3d& half) { return {-half, half}; }

class Sphere final : public Shape {
 public:
  explicit Sphere(double radius) : radius_(radius) {}
  [[nodiscard]] double distance(const Vector3d& p) const override { return p.norm() - radius_; }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    const double norm = p.norm();
    return {norm - radius_, norm > 0 ? Vector3d(p / norm) : Vector3d::UnitZ(), true};
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override {
    return box_of(Vector3d::Constant(radius_));
  }

 private:
  double radius_;
};

/// Distance to a box of any dimension from excess = |p| - half: positive
/// outside.
template <typename Vector>
double box_distance(const Vector& excess) {
  const double deepest = excess.maxCoeff();
  return deepest > 0 ? excess.cwiseMax(0.0).norm() : deepest;
}

/// Gradient of box_distance() with respect to |p|.
template <typename Vector>
Vector box_gradient(const Vector& excess) {
  Eigen::Index side;
  if (excess.maxCoeff(&side) > 0) return excess.cwiseMax(0.0).normalized();
  return Vector::Unit(side);
}

class Box final : public Shape {
 public:
  explicit Box(const Vector3d& edges) : half_(edges / 2) {}
  [[nodiscard]] double distance(const Vector3d& p) const override {
    return box_distance(Vector3d(p.cwiseAbs() - half_));
  }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    const Vector3d excess = p.cwiseAbs() - half_;
    Vector3d normal = box_gradient(excess);
    for (int i = 0; i < 3; ++i) normal(i) = std::copysign(normal(i), p(i));
    return {box_distance(excess), normal, true};
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return box_of(half_); }

 private:
  Vector3d half_;
};

/// A direction of the half plane (rho, z) through p, in space.
Vector3d turned_to(const Vector3d& p, double rho, const Vector2d& direction) {
  const Vector2d radial = rho > 0 ? Vector2d(p.head<2>() / rho) : Vector2d::UnitX();
  return {direction.x() * radial.x(), direction.x() * radial.y(), direction.y()};
}

class Cylinder final : public Shape {
 public:
  Cylinder(double radius, double height) : half_(radius, height / 2) {}
  [[nodiscard]] double distance(const Vector3d& p) const override {
    return box_distance(excess(p));
  }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    const Vector2d e = excess(p);
    Vector2d normal = box_gradient(e);
    normal.y() = std::copysign(normal.y(), p.z());
    return {box_distance(e), turned_to(p, p.head<2>().norm(), normal), true};
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override {
    return box_of({half_.x(), half_.x(), half_.y()});
  }

 private:
  [[nodiscard]] Vector2d excess(const Vector3d& p) const {
    return {p.head<2>().norm() - half_.x(), std::abs(p.z()) - half_.y()};
  }
  Vector2d half_;
};

class TaperedCapsule final : public Shape {
 public:
  TaperedCapsule(double lower, double upper, double length)
      : lower_(lower), upper_(upper), half_(length / 2) {
    // Where a ball holds the other, the line shrinks to nothing at its pole.
    sin_ = std::clamp((lower - upper) / length, -1.0, 1.0);
    cos_ = std::sqrt((1 - sin_) * (1 + sin_));
    side_ = length * cos_;
  }
  [[nodiscard]] double distance(const Vector3d& p) const override {
    const double rho = p.head<2>().norm(), z = p.z() + half_;
    const double foot = cos_ * z - sin_ * rho;
    if (is_lower(foot)) return std::hypot(rho, z) - lower_;
    if (is_upper(foot)) return std::hypot(rho, p.z() - half_) - upper_;
    return cos_ * rho + sin_ * z - lower_;
  }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    const double rho = p.head<2>().norm(), z = p.z() + half_;
    const double foot = cos_ * z - sin_ * rho;
    if (is_lower(foot)) return ball(p, -half_, lower_);
    if (is_upper(foot)) return ball(p, half_, upper_);
    return {cos_ * rho + sin_ * z - lower_, turned_to(p, rho, {cos_, sin_}), true};
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override {
    const double r = std::max(lower_, upper_);
    return {Vector3d(-r, -r, std::min(-half_ - lower_, half_ - upper_)),
            Vector3d(r, r, std::max(half_ + upper_, lower_ - half_))};
  }

 private:
  [[nodiscard]] bool is_lower(double foot) const { return sin_ >= 1 || (sin_ > -1 && foot <= 0); }
  [[nodiscard]] bool is_upper(double foot) const { return sin_ <= -1 || foot >= side_; }
  static NearestSurface ball(const Vector3d& p, double z, double radius) {
    const Vector3d arm(p.x(), p.y(), p.z() - z);
    const double norm = arm.norm();
    return {norm - radius, norm > 0 ? Vector3d(arm / norm) : Vector3d::UnitX(), true};
  }

  double lower_, upper_, half_;
  double sin_, cos_;  // of the angle between side and axis
  double side_;       // length of the side [m]
};

class Ellipsoid final : public Shape {
 public:
  explicit Ellipsoid(const Vector3d& semi_axes)
      : e_(semi_axes), least_(semi_axes.minCoeff()), shift_(e_.cwiseAbs2().array() - sq(least_)) {}
  [[nodiscard]] double distance(const Vector3d& p) const override {
    const Foot foot = find_foot(p.cwiseAbs());
    return foot.t * foot.slope.norm();
  }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    const Foot foot = find_foot(p.cwiseAbs());
    const double norm = foot.slope.norm();
    Vector3d normal = foot.slope / norm;
    for (int i = 0; i < 3; ++i) normal(i) = std::copysign(normal(i), p(i));
    return {foot.t * norm, normal, true};
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return box_of(e_); }

 private:
  /// y = x + t slope  with  slope_i = x_i / e_i^2.
  struct Foot {
    double t;
    Vector3d slope;
  };
  static double sq(double a) { return a * a; }

  /// Finds the foot of y, with s = t + least^2, so that no digits are lost near the root's pole.
  [[nodiscard]] Foot find_foot(const Vector3d& y) const {
    // Choose a start to the left of the root.
    const Vector3d ey = e_.cwiseProduct(y);
    const double start = (ey - shift_).maxCoeff();
    if (start <= 0) {
      // On the plane across the least axis, perhaps above the foci: the foot
      // leaves the plane.
      const Vector3d ratio = (shift_.array() > 0).select(ey.cwiseQuotient(shift_), 0.0);
      if (ratio.squaredNorm() <= 1) return inner_foot(ratio);
    }
    // Apply Newton's method to the inverse root of the sum.
    double s = std::max(start, 0.0);
    for (int i = 0; i < 50; ++i) {
      const Vector3d span = shift_.array() + s;
      const Vector3d ratio = (ey.array() > 0).select(ey.cwiseQuotient(span), 0.0);
      const double sum = ratio.squaredNorm(), excess = std::sqrt(sum) - 1;
      const double step =
          excess * sum /
          (ratio.array() > 0).select(ratio.cwiseAbs2().cwiseQuotient(span), 0.0).sum();
      s += step;
      if (!(step > 1e-16 * s)) break;
    }
    return {s - sq(least_), y.cwiseQuotient(Vector3d(shift_.array() + s))};
  }

  /// @param ratio  of the foot to the semi-axes, but for the least
  [[nodiscard]] Foot inner_foot(const Vector3d& ratio) const {
    Eigen::Index thin;
    e_.minCoeff(&thin);
    Vector3d slope = ratio.cwiseQuotient(e_);
    slope(thin) = std::sqrt(1 - ratio.squaredNorm()) / least_;
    return {-sq(least_), slope};
  }

  Vector3d e_;
  double least_;
  Vector3d shift_;  // e_i^2 - least^2 [m^2] (3)
};

}  // namespace

std::shared_ptr<const Shape> build_sphere(double radius) {
  return std::make_shared<Sphere>(radius);
}
std::shared_ptr<const Shape> build_box(const Vector3d& edges) {
  return std::make_shared<Box>(edges);
}
std::shared_ptr<const Shape> build_cylinder(double radius, double height) {
  return std::make_shared<Cylinder>(radius, height);
}
std::shared_ptr<const Shape> build_tapered_capsule(double lower, double upper, double length) {
  return std::make_shared<TaperedCapsule>(lower, upper, length);
}
std::shared_ptr<const Shape> build_ellipsoid(const Vector3d& semi_axes) {
  return std::make_shared<Ellipsoid>(semi_axes);
}

}  // namespace thenar
