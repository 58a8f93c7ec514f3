#include "data/io/mesh/transformed_primitive.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <Eigen/SVD>

namespace thenar {
namespace {

// Relative difference of equal numbers with seven digits [1]
constexpr double kEqualityTolerance = 1e-6;
constexpr double kRotationRounding = 1e-12;  // Largest deviation of R R' from the identity [1]

bool is_same(double a, double b) { return std::abs(a - b) <= kEqualityTolerance * std::max(a, b); }

/// Rotation nearest to almost orthogonal unit columns. A mirrored third axis is reversed, because
/// the solids are symmetric.
Eigen::Matrix3d nearest_rotation(Eigen::Matrix3d columns) {
  if (columns.determinant() < 0) columns.col(2) *= -1;
  if ((columns * columns.transpose()).isIdentity(kRotationRounding)) return columns;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(columns, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

/// Sizes under factors along the solid's axes; nothing if it becomes another kind of solid.
std::optional<Eigen::Vector3d> stretched(const ShapeSpec& solid, const Eigen::Vector3d& factor) {
  const bool round = is_same(factor.x(), factor.y());
  const double across = (factor.x() + factor.y()) / 2;
  switch (solid.kind) {
    case ShapeKind::kSphere:
      if (!round || !is_same(across, factor.z())) return {};
      return Eigen::Vector3d(solid.size.x() * factor.mean(), 0, 0);
    case ShapeKind::kCylinder:
      if (!round) return {};
      return Eigen::Vector3d(solid.size.x() * across, solid.size.y() * factor.z(), 0);
    case ShapeKind::kBox:
      return Eigen::Vector3d(solid.size.cwiseProduct(factor));
    default:
      return {};
  }
}

bool has_sizes(const ShapeSpec& solid) {
  const Eigen::Index count = solid.kind == ShapeKind::kSphere     ? 1
                             : solid.kind == ShapeKind::kCylinder ? 2
                                                                  : 3;
  return solid.size.allFinite() && solid.size.head(count).minCoeff() > 0 &&
         solid.X_BS.p.allFinite() && solid.X_BS.R.allFinite();
}

}  // namespace

std::optional<ShapeSpec> place_primitive(const ShapeSpec& solid, const Eigen::Affine3d& map) {
  // Images of the solid's axes.
  const Eigen::Matrix3d A = map.linear() * solid.X_BS.R;
  const Eigen::Vector3d factor = A.colwise().norm();
  if (!A.allFinite() || !(factor.minCoeff() > 0)) return {};

  // The axes must stay perpendicular, and the sizes those of the same solid.
  const Eigen::Matrix3d columns = A * factor.cwiseInverse().asDiagonal();
  if (!(columns.transpose() * columns).isIdentity(kEqualityTolerance)) return {};

  const std::optional<Eigen::Vector3d> size = stretched(solid, factor);
  if (!size) return {};
  ShapeSpec placed = solid;
  placed.size = *size;
  placed.X_BS = {nearest_rotation(columns), map * solid.X_BS.p};
  if (!has_sizes(placed)) return {};
  return placed;
}

ShapeSpec scaled_primitive(ShapeSpec solid, double scale) {
  solid.size *= scale;
  solid.X_BS.p *= scale;
  return solid;
}

double shortest_decimal(float value) {
  std::array<char, 64> text{};
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double decimal = value;
  std::from_chars(text.data(), end, decimal);
  return decimal;
}

}  // namespace thenar
