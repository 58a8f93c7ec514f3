#include "grasp/contact/friction_pyramid.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

using Axes = decltype(WrenchCap::A);

/// m-gon (2, m) in the unit circle, its first corner at (1, 0).
Eigen::Matrix2Xd polygon(int edges) {
  Eigen::Matrix2Xd z(2, edges);
  for (int k = 0; k < edges; ++k) {
    const double angle = 2 * M_PI * k / edges;
    z.col(k) << std::cos(angle), std::sin(angle);
  }
  return z;
}

/// Vertices in terms of the axes (axes, vertices) of a cap with that many axes.
Eigen::MatrixXd vertices_in(Eigen::Index axes, int edges) {
  if (axes == 0) return Eigen::MatrixXd(0, 1);
  if (axes == 1) return Eigen::RowVector2d(1, -1);
  Eigen::MatrixXd z = Eigen::MatrixXd::Zero(axes, edges + 2 * (axes - 2));
  z.topLeftCorner(2, edges) = polygon(edges);
  if (axes == 3) z.bottomRightCorner<1, 2>() << 1, -1;
  return z;
}

int bands(int edges) { return (edges + 1) / 2; }

/// Vertices in terms of the axes (axes, vertices), ellipsoids cut by m meridians and m / 2 bands of
/// latitude.
Eigen::MatrixXd vertices_even(Eigen::Index axes, int edges) {
  if (axes < 3) return vertices_in(axes, edges);
  Eigen::MatrixXd z = Eigen::MatrixXd::Zero(3, edges * (bands(edges) - 1) + 2);
  // The two poles come last; each ring of latitude is a polygon.
  z.bottomRightCorner<1, 2>() << 1, -1;
  for (int i = 1; i < bands(edges); ++i) {
    const double latitude = M_PI * i / bands(edges) - M_PI / 2;
    auto ring = z.middleCols(edges * (i - 1), edges);
    ring.topRows<2>() = std::cos(latitude) * polygon(edges);
    ring.row(2).setConstant(std::sin(latitude));
  }
  return z;
}

/// Computes the vertices of vertices_even(), enlarged until the polytope contains the disc or
/// ellipsoid: divided by its inradius.
Eigen::MatrixXd vertices_about(Eigen::Index axes, int edges) {
  Eigen::MatrixXd z = vertices_even(axes, edges);
  if (axes >= 2) z /= std::cos(M_PI / edges);
  if (axes == 3) z /= std::cos(M_PI / (2 * bands(edges)));
  return z;
}

template <typename Vertices>
WrenchSet cut(const WrenchSet& set, int edges, Vertices vertices) {
  require(edges >= 3, "a pyramid has at least 3 edges, got {}", edges);
  int contact = 0;  // first number that no contact has yet
  for (const WrenchCap& cap : set.caps) contact = std::max(contact, cap.contact + 1);
  WrenchSet out;
  for (const WrenchCap& cap : set.caps) {
    // Vertices of one cap share the limit of its contact.
    const int number = cap.contact < 0 ? contact++ : cap.contact;
    const Eigen::MatrixXd z = vertices(cap.A.cols(), edges);
    for (Eigen::Index k = 0; k < z.cols(); ++k)
      out.caps.push_back(
          {ScaledWrench::from_coordinates(cap.c.vector() + cap.A * z.col(k)), Axes(6, 0), number});
  }
  return out;
}

}  // namespace

WrenchSet pyramids(const WrenchSet& set, int edges) { return cut(set, edges, vertices_in); }

WrenchSet polytopes_in(const WrenchSet& set, int edges) { return cut(set, edges, vertices_even); }

WrenchSet polytopes_about(const WrenchSet& set, int edges) {
  return cut(set, edges, vertices_about);
}

}  // namespace thenar
