#include "geometry/superellipsoid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/spatial.h"
#include "geometry/nearest_grid.h"
#include "geometry/tessellate.h"
#include "geometry/triangle_tree.h"

namespace thenar {
namespace {

using Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;

/// x^k for x >= 0; ellipsoids and cylinders need no logarithm.
class Power {
 public:
  explicit Power(double k)
      : k_(k),
        kind_(k == 1     ? kSame
              : k == 2   ? kSquare
              : k == 0.5 ? kRoot
                         : kAny) {}
  double operator()(double x) const {
    switch (kind_) {
      case kSame:
        return x;
      case kSquare:
        return x * x;
      case kRoot:
        return std::sqrt(x);
      case kAny:
        break;
    }
    return std::pow(x, k_);
  }

 private:
  double k_;
  enum { kSame, kSquare, kRoot, kAny } kind_;
};

/// Norm N with its derivatives, in the first octant.
class Norm {
 public:
  Norm(const Vector3d& semi_axes, const Vector2d& exponents)
      : inverse_(semi_axes.cwiseInverse()),
        p_(2 / exponents(1)),
        q_(2 / exponents(0)),
        to_p_(p_),
        to_q_(q_),
        to_ratio_(q_ / p_),
        to_norm_(1 / q_) {}

  struct Value {
    double norm;        // N(x) [1]
    Vector3d gradient;  // along that of N, unit (3)
    Matrix3d bend;      // of the normal along the surface N(x) = const, before projection [1/m]
  };

  /// The surface point farthest along n: the gradient of the dual norm, whose exponents are
  /// p / (p - 1) and q / (q - 1).
  [[nodiscard]] Vector3d support(const Vector3d& n) const {
    const Vector3d w = n.cwiseQuotient(inverse_);
    const Vector2d disc = dual_shares({w.x(), w.y()}, p_);
    const Vector2d whole = dual_shares({disc.dot(w.head<2>()), w.z()}, q_);
    return Vector3d(whole.x() * disc.x(), whole.x() * disc.y(), whole.y()).cwiseQuotient(inverse_);
  }

  /// Computes the norm N and its derivatives, with T = N^q = s^(q/p) + (z/c)^q, s = (x/a)^p +
  /// (y/b)^p.
  [[nodiscard]] Value value(const Vector3d& x) const {
    // Move points onto a plane of symmetry that is so near that powers would underflow.
    Vector3d u = x.cwiseProduct(inverse_);
    u = (u.array() < 1e-12 * u.maxCoeff()).select(0.0, u);
    // Compute powers of the coordinates, and the chain rule's factors.
    const Powers at = powers(u);
    const double ratio = q_ / p_, over = at.s > 0 ? at.disc / at.s : 0;
    const double f1 = ratio * over, f2 = at.s > 0 ? ratio * (ratio - 1) * over / at.s : 0;
    // Compute gradient and Hessian of T.
    const Vector2d s1(p_ * slope(at.a, u.x()), p_ * slope(at.b, u.y()));
    Vector3d g(f1 * s1.x(), f1 * s1.y(), q_ * slope(at.c, u.z()));
    Matrix3d H = Matrix3d::Zero();
    H.topLeftCorner<2, 2>() = f2 * s1 * s1.transpose();
    H(0, 0) += f1 * p_ * bend(at.a, u.x(), p_);
    H(1, 1) += f1 * p_ * bend(at.b, u.y(), p_);
    H(2, 2) = q_ * bend(at.c, u.z(), q_);
    // Scale to a unit normal.
    g = g.cwiseProduct(inverse_);
    const double steep = g.norm();
    return {to_norm_(at.disc + at.c), g / steep,
            inverse_.asDiagonal() * (H / steep) * inverse_.asDiagonal()};
  }

 private:
  /// The point of |u|^k + |v|^k = 1 farthest along w, both >= 0.
  static Vector2d dual_shares(const Vector2d& w, double k) {
    // Scale by the largest, so that no power overflows.
    const double most = w.maxCoeff();
    if (!(most > 0)) return {1, 0};
    if (k == 1) return w.x() >= w.y() ? Vector2d(1, 0) : Vector2d(0, 1);
    const Vector2d share = (w / most).array().pow(1 / (k - 1));
    return share / std::pow((share.array() * w.array() / most).sum(), 1 / k);
  }

  struct Powers {
    double a, b, s, disc, c;  // (x/a)^p, (y/b)^p, their sum, its power q/p, (z/c)^q
  };
  [[nodiscard]] Powers powers(const Vector3d& u) const {
    Powers at;
    at.a = to_p_(u.x());
    at.b = to_p_(u.y());
    at.s = at.a + at.b;
    at.disc = to_ratio_(at.s);
    at.c = to_q_(u.z());
    return at;
  }
  /// u^(k - 1) from u^k; of a sharp edge (k = 1, u = 0) the normal between its sides.
  static double slope(double power, double u) { return u > 0 ? power / u : 0; }
  /// (k - 1) u^(k - 2) from u^k; what is sharp is as good as very sharp.
  static double bend(double power, double u, double k) {
    return u > 0 && k > 1 ? std::min((k - 1) * power / (u * u), 1e9) : 0;
  }

  Vector3d inverse_;  // of the semi-axes [1/m]
  double p_, q_;
  Power to_p_, to_q_, to_ratio_, to_norm_;
};

/// A surface point, its normal, and what they say of the distance.
struct Bound {
  double distance = -std::numeric_limits<double>::infinity();  // n . (p - x) [m]
  double gap = std::numeric_limits<double>::infinity();        // |p - x| - |distance| [m]
  Vector3d normal{0, 0, 1};
  Vector3d x{0, 0, 0};  // [m]
};

/// One step of Newton's method along the surface from x with normal and bend `at`:
///   (I + d K) step = (p - x) along the surface,  K the curvature at x.
/// Zero where the curvature forbids it.
Vector3d newton_step(const Norm::Value& at, const Vector3d& arm) {
  // Compute the curvature in the tangent plane.
  const Eigen::Matrix<double, 3, 2> basis = basis_along(at.gradient).leftCols<2>();
  const Eigen::Matrix2d M = Eigen::Matrix2d::Identity() +
                            at.gradient.dot(arm) * at.norm * (basis.transpose() * at.bend * basis);
  // Solve the 2 x 2 system, if it is positive definite.
  const Vector2d along = basis.transpose() * arm;
  const double det = M.determinant();
  if (!(det > 1e-9 && M.trace() > 0)) return Vector3d::Zero();
  return basis *
         Vector2d(M(1, 1) * along.x() - M(0, 1) * along.y(),
                  M(0, 0) * along.y() - M(1, 0) * along.x()) /
         det;
}

/// The best bound that Newton's method finds from the surface point x / N(x), before it has to go
/// back or its gap is small enough [m].
/// @param at  norm.value(x)
Bound improve(const Norm& norm, const Vector3d& p, Vector3d x, Norm::Value at, int most,
              double enough) {
  Bound best;
  for (int i = 0; i < most; ++i) {
    // Scale onto the surface; its tangent plane bounds the distance.
    if (i > 0) at = norm.value(x);
    x /= at.norm;
    const Vector3d arm = p - x;
    const double distance = at.gradient.dot(arm);
    if (!(distance > best.distance)) break;
    best = {distance, arm.norm() - std::abs(distance), at.gradient, x};
    if (best.gap <= enough) break;
    // Take Newton's step along the surface.
    x = (x + newton_step(at, arm)).cwiseMax(0.0);
  }
  return best;
}

/// Outside, from a bound: the normal is taken from the way to the surface point and the surface
/// point from the normal in turn, which settles where the surface bends more sharply than p is far.
Bound settle(const Norm& norm, const Vector3d& p, Bound best, int most, double enough) {
  for (int i = 0; i < most && best.gap > enough; ++i) {
    // Find the support point in the direction from the surface to p.
    const Vector3d n = (p - best.x).normalized().cwiseMax(0.0).normalized();
    const Vector3d x = norm.support(n);
    const double distance = n.dot(p - x);
    if (!(distance > best.distance)) break;
    best = {distance, (p - x).norm() - distance, n, x};
  }
  return best;
}

/// Shape for the tessellation, with distances by the norm alone.
class Rough final : public Shape {
 public:
  Rough(const Norm& norm, Vector3d semi_axes) : norm_(norm), semi_axes_(std::move(semi_axes)) {}
  [[nodiscard]] double distance(const Vector3d& p) const override { return nearest(p).distance; }
  /// Returns the nearest surface towards the origin, at the distance between p and the surface
  /// along its normal.
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    const Norm::Value at = norm_.value(p.cwiseAbs());
    const Vector3d sign = p.unaryExpr([](double a) { return std::copysign(1.0, a); });
    return {(1 - 1 / at.norm) * at.gradient.dot(p.cwiseAbs()), sign.cwiseProduct(at.gradient)};
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return {-semi_axes_, semi_axes_}; }

 private:
  const Norm& norm_;
  Vector3d semi_axes_;
};

class Superellipsoid final : public Shape {
 public:
  Superellipsoid(const Vector3d& semi_axes, const Vector2d& exponents)
      : semi_axes_(semi_axes),
        size_(semi_axes.maxCoeff()),
        norm_(semi_axes, exponents),
        tree_(octant(norm_, semi_axes, kTessellation * size_)),
        grid_(tree_, 1) {}

  double distance(const Vector3d& p) const override { return find(p.cwiseAbs()).distance; }
  NearestSurface nearest(const Vector3d& p) const override {
    NearestSurface near = find(p.cwiseAbs());
    for (int i = 0; i < 3; ++i) near.normal(i) = std::copysign(near.normal(i), p(i));
    return near;
  }
  Eigen::AlignedBox3d bounds() const override { return {-semi_axes_, semi_axes_}; }
  double accuracy() const override { return 2.1 * kTessellation * size_; }

 private:
  // Error of the tessellation, over the largest semi-axis [1]
  static constexpr double kTessellation = 1.4e-4;
  // Gap over the largest semi-axis up to which it counts as none [1]
  static constexpr double kEnough = 1e-12;

  static TriangleMesh octant(const Norm& norm, const Vector3d& semi_axes, double tolerance) {
    return tessellate_octant(Rough(norm, semi_axes), tolerance);
  }

  NearestSurface find(const Vector3d& p) const {
    const Norm::Value at = norm_.value(p);
    const double norm = at.norm, enough = kEnough * size_;
    // Outside, apply Newton's method from the radial point.
    if (norm > 1) {
      const Bound bound = outside(p, p, at);
      if (bound.gap <= enough) return {bound.distance, bound.normal, true};
    }
    // Otherwise start at the tessellation's nearest point.
    const internal::NearestTriangle near = grid_.nearest(p, tree_);
    const double rough = std::copysign(std::sqrt(near.foot.squared), norm - 1);
    const Vector3d x = near.foot.point.cwiseMax(0.0);
    const Norm::Value there = norm_.value(x);
    const Bound bound = norm > 1 ? outside(p, x, there) : improve(norm_, p, x, there, 4, enough);
    // Accept a bound that agrees with the tessellation within the tessellation's error.
    if (std::abs(bound.distance - rough) <= 1.05 * kTessellation * size_)
      return {bound.distance, bound.normal, true};
    // Otherwise return the distance of the tessellation.
    const Vector3d way = (p - near.foot.point).cwiseMax(0.0);
    return {rough, rough > 0 && way.norm() > 0 ? Vector3d(way.normalized()) : bound.normal};
  }

  /// @param at  norm_.value(x)
  Bound outside(const Vector3d& p, const Vector3d& x, const Norm::Value& at) const {
    const double enough = kEnough * size_;
    Bound bound = improve(norm_, p, x, at, 6, enough);
    for (int i = 0; i < 2 && bound.gap > enough; ++i) {
      bound = settle(norm_, p, bound, 6, enough);
      const Bound again = improve(norm_, p, bound.x, norm_.value(bound.x), 6, enough);
      if (again.distance > bound.distance) bound = again;
    }
    return bound;
  }

  Vector3d semi_axes_;
  double size_;
  Norm norm_;
  internal::TriangleTree tree_;
  internal::NearestGrid grid_;
};

}  // namespace

std::shared_ptr<const Shape> build_superellipsoid(const Vector3d& semi_axes,
                                                  const Vector2d& exponents) {
  return std::make_shared<Superellipsoid>(semi_axes, exponents);
}

Vector3d superellipsoid_support(const Vector3d& semi_axes, const Vector2d& exponents,
                                const Vector3d& n) {
  const Vector3d octant = n.unaryExpr([](double d) { return std::copysign(1.0, d); });
  return octant.cwiseProduct(Norm(semi_axes, exponents).support(n.cwiseAbs()));
}

}  // namespace thenar
