#include "grasp/contact/friction_pyramid.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

using Axes = decltype(WrenchCap::A);

/// Returns an m-gon (2, m) in the unit circle, with its first corner at (1, 0).
Eigen::Matrix2Xd polygon(int edges) {
  Eigen::Matrix2Xd z(2, edges);
  for (int k = 0; k < edges; ++k) {
    const double angle = 2 * M_PI * k / edges;
    z.col(k) << std::cos(angle), std::sin(angle);
  }
  return z;
}

/// Returns the vertices of a pyramid in terms of a cap's axes (axes, vertices).
Eigen::MatrixXd pyramid_vertices(Eigen::Index axes, int edges) {
  if (axes == 0) return Eigen::MatrixXd(0, 1);
  if (axes == 1) return Eigen::RowVector2d(1, -1);
  Eigen::MatrixXd z = Eigen::MatrixXd::Zero(axes, edges + 2 * (axes - 2));
  z.topLeftCorner(2, edges) = polygon(edges);
  if (axes == 3) z.bottomRightCorner<1, 2>() << 1, -1;
  return z;
}

int band_count(int edges) { return (edges + 1) / 2; }

/// Returns inscribed vertices in terms of the axes (axes, vertices); ellipsoids are cut by m
/// meridians and m / 2 bands of latitude.
Eigen::MatrixXd inscribed_vertices(Eigen::Index axes, int edges) {
  if (axes < 3) return pyramid_vertices(axes, edges);
  Eigen::MatrixXd z = Eigen::MatrixXd::Zero(3, edges * (band_count(edges) - 1) + 2);
  // The two poles come last; each ring of latitude is a polygon.
  z.bottomRightCorner<1, 2>() << 1, -1;
  for (int i = 1; i < band_count(edges); ++i) {
    const double latitude = M_PI * i / band_count(edges) - M_PI / 2;
    auto ring = z.middleCols(edges * (i - 1), edges);
    ring.topRows<2>() = std::cos(latitude) * polygon(edges);
    ring.row(2).setConstant(std::sin(latitude));
  }
  return z;
}

/// Returns the inscribed vertices divided by the inradius, so that the polytope contains the disc
/// or ellipsoid.
Eigen::MatrixXd circumscribed_vertices(Eigen::Index axes, int edges) {
  Eigen::MatrixXd z = inscribed_vertices(axes, edges);
  if (axes >= 2) z /= std::cos(M_PI / edges);
  if (axes == 3) z /= std::cos(M_PI / (2 * band_count(edges)));
  return z;
}

/// Replaces each cap by the polytope of its vertices.
template <typename Vertices>
WrenchSet replace_caps(const WrenchSet& set, int edges, Vertices vertices) {
  require(edges >= 3, "a pyramid has at least 3 edges, got {}", edges);
  int contact = 0;  // first unused number of a contact
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

WrenchSet friction_pyramids(const WrenchSet& set, int edges) {
  return replace_caps(set, edges, pyramid_vertices);
}

WrenchSet inscribed_polytopes(const WrenchSet& set, int edges) {
  return replace_caps(set, edges, inscribed_vertices);
}

WrenchSet circumscribed_polytopes(const WrenchSet& set, int edges) {
  return replace_caps(set, edges, circumscribed_vertices);
}

}  // namespace thenar
