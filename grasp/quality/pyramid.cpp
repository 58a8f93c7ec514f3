#include "grasp/quality/pyramid.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

using Axes = decltype(WrenchCap::A);

/// Vertices in terms of the axes (axes, vertices) of a cap with that many axes.
Eigen::MatrixXd vertices_in(Eigen::Index axes, int edges) {
  if (axes == 0) return Eigen::MatrixXd(0, 1);
  if (axes == 1) return Eigen::RowVector2d(1, -1);
  Eigen::MatrixXd z = Eigen::MatrixXd::Zero(axes, edges + 2 * (axes - 2));
  for (int k = 0; k < edges; ++k) {
    const double angle = 2 * M_PI * k / edges;
    z.col(k).head<2>() << std::cos(angle), std::sin(angle);
  }
  if (axes == 3) z.bottomRightCorner<1, 2>() << 1, -1;
  return z;
}

Eigen::MatrixXd vertices_about(Eigen::Index axes, int edges) {
  if (axes < 2) return vertices_in(axes, edges);
  const Eigen::MatrixXd ring = vertices_in(2, edges) / std::cos(M_PI / edges);
  if (axes == 2) return ring;
  Eigen::MatrixXd z(3, 2 * edges);
  z << ring, ring, Eigen::RowVectorXd::Ones(edges), -Eigen::RowVectorXd::Ones(edges);
  return z;
}

template <typename Vertices>
WrenchSet cut(const WrenchSet& set, int edges, Vertices vertices) {
  require(edges >= 3, "a pyramid has at least 3 edges, got {}", edges);
  int contact = 0;  // a number nobody has yet
  for (const WrenchCap& cap : set.caps) contact = std::max(contact, cap.contact + 1);
  WrenchSet out;
  for (const WrenchCap& cap : set.caps) {
    const int number = cap.contact < 0 ? contact++ : cap.contact;
    const Eigen::MatrixXd z = vertices(cap.A.cols(), edges);
    for (Eigen::Index k = 0; k < z.cols(); ++k)
      out.caps.push_back({cap.c + cap.A * z.col(k), Axes(6, 0), number});
  }
  return out;
}

}  // namespace

WrenchSet pyramids(const WrenchSet& set, int edges) { return cut(set, edges, vertices_in); }

WrenchSet pyramids_about(const WrenchSet& set, int edges) {
  return cut(set, edges, vertices_about);
}

}  // namespace thenar
