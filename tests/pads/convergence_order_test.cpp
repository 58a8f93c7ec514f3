// Orders at which elements approach a solution of finite strain that is known everywhere.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/pads/body_newton.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A displacement with shears up to 0.3, and the body force that it needs.
struct KnownSolution {
  Tissue tissue;
  static constexpr double kSize = 0.2;

  [[nodiscard]] static Vector3d displacement(const Vector3d& X) {
    return kSize * Vector3d(std::sin(1.5 * X[1] + 0.5 * X[2]), 0.8 * std::cos(X[0] + X[2]),
                            0.6 * std::sin(X[0] - 1.2 * X[1]));
  }
  [[nodiscard]] static Matrix3d deformation(const Vector3d& X) {
    const double c = std::cos(1.5 * X[1] + 0.5 * X[2]), s = -0.8 * std::sin(X[0] + X[2]),
                 d = 0.6 * std::cos(X[0] - 1.2 * X[1]);
    Matrix3d G;
    G << 0, 1.5 * c, 0.5 * c, s, 0, s, d, -1.2 * d, 0;
    return Matrix3d::Identity() + kSize * G;
  }
  /// First Piola-Kirchhoff stress.
  [[nodiscard]] Matrix3d stress(const Vector3d& X) const {
    const Matrix3d F = deformation(X);
    IsochoricResponse iso;
    isochoric_response(tissue, F, false, iso);
    const double J = F.determinant();
    const double p = volumetric_response(bulk_modulus(tissue), J).pressure;
    return (tensor_of(iso.stress) + p * J * Matrix3d::Identity()) * F.inverse().transpose();
  }
  /// -Div P, by differences of fourth order.
  [[nodiscard]] Vector3d body_force(const Vector3d& X) const {
    constexpr double kStep = 1e-3;
    Vector3d out(0, 0, 0);
    for (int j = 0; j < 3; ++j) {
      const Vector3d e = kStep * Vector3d::Unit(j);
      out -=
          (8 * (stress(X + e) - stress(X - e)) - (stress(X + 2 * e) - stress(X - 2 * e))).col(j) /
          (12 * kStep);
    }
    return out;
  }
};

/// Nodes of all elements of a mesh.
std::vector<std::vector<int>> element_nodes(const HexMesh& mesh, HexElement kind) {
  std::vector<std::vector<int>> out;
  std::set<int> parents;
  for (const int index : mesh.active()) {
    const HexCell& cell = mesh.cells()[static_cast<std::size_t>(index)];
    if (kind != HexElement::kQuadratic)
      out.emplace_back(cell.corners.begin(), cell.corners.end());
    else
      parents.insert(cell.parent);
  }
  for (const int index : parents) {
    std::vector<int> nodes(27);
    for (int child = 0; child < 8; ++child)
      for (int corner = 0; corner < 8; ++corner)
        nodes[lattice_index(child, corner)] =
            mesh.cells()[static_cast<std::size_t>(
                             mesh.cells()[static_cast<std::size_t>(index)].first_child + child)]
                .corners[static_cast<std::size_t>(corner)];
    out.push_back(std::move(nodes));
  }
  return out;
}

struct Errors {
  double strain = 0, displacement = 0;  // root of the integral of their squares
};

/// Solves on cells^3 crooked elements whose boundary has the known displacement.
Errors errors_of(HexElement kind, int cells, double poisson_ratio) {
  KnownSolution known{neo_hookean(1, poisson_ratio)};
  const std::vector<double> axis = even_axis(0, 1, cells);
  HexMesh mesh = graded_box(axis, axis, axis, [](const Vector3d& p) -> Vector3d {
    // Crooked, and alike at all sizes.
    const double wave = 0.04 * std::sin(5 * p[0]) * std::cos(4 * p[1]) * std::sin(3 + 4 * p[2]);
    return p + wave * Vector3d(1, -0.7, 0.8);
  });
  if (kind == HexElement::kQuadratic) mesh.refine(std::vector<int>(mesh.active()));
  const std::vector<bool> none(static_cast<std::size_t>(mesh.nodes()), false);
  const TissueBody body(mesh, kind, {known.tissue}, none);
  // Faces of one element alone are the boundary.
  std::map<std::array<int, 4>, int> count;
  for (const int index : mesh.active())
    for (std::array<int, 4> face : hex_faces()) {
      for (int& each : face)
        each =
            mesh.cells()[static_cast<std::size_t>(index)].corners[static_cast<std::size_t>(each)];
      std::sort(face.begin(), face.end());
      ++count[face];
    }
  HeldComponents held(static_cast<std::size_t>(body.unknowns()), false);
  VectorXd x = VectorXd::Zero(body.unknowns()), load = x;
  for (const auto& [face, times] : count)
    for (const int node : face)
      if (times == 1)
        for (std::size_t c = 0; c < 3; ++c)
          held[3 * static_cast<std::size_t>(body.free_index(node)) + c] = true;
  // All begins near the answer; how Newton's method gets there is another test's.
  for (std::size_t i = 0; i < body.free_nodes().size(); ++i)
    x.segment<3>(static_cast<Eigen::Index>(3 * i)) =
        KnownSolution::displacement(mesh.place(body.free_nodes()[i]));
  // Loads of the body force, and places of Gauss points.
  const std::vector<std::vector<int>> elements = element_nodes(mesh, kind);
  std::vector<ElementShape> shapes;
  std::vector<Vector3d> places;
  for (const std::vector<int>& nodes : elements) {
    Matrix3Xd X(3, static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t a = 0; a < nodes.size(); ++a)
      X.col(static_cast<Eigen::Index>(a)) = mesh.place(nodes[a]);
    shapes.push_back(element_shape(kind, X));
    for (std::size_t q = 0; q < shapes.back().volume.size(); ++q) {
      Vector3d at(0, 0, 0);
      for (std::size_t a = 0; a < nodes.size(); ++a)
        at += shape_value(kind, q, a) * mesh.place(nodes[a]);
      places.push_back(at);
      const Vector3d force = shapes.back().volume[q] * known.body_force(at);
      for (std::size_t a = 0; a < nodes.size(); ++a)
        load.segment<3>(3 * body.free_index(nodes[a])) += shape_value(kind, q, a) * force;
    }
  }
  EXPECT_GE(bring_to_rest(body, held, load, x), 0) << name_of(kind) << cells;
  // Against the known solution at Gauss points.
  Errors out;
  const Matrix3Xd u = body.node_displacements(x, {});
  std::size_t point = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    Matrix3Xd own(3, static_cast<Eigen::Index>(elements[e].size()));
    for (std::size_t a = 0; a < elements[e].size(); ++a)
      own.col(static_cast<Eigen::Index>(a)) = u.col(elements[e][a]);
    for (std::size_t q = 0; q < shapes[e].volume.size(); ++q, ++point) {
      Vector3d here(0, 0, 0);
      for (std::size_t a = 0; a < elements[e].size(); ++a)
        here += shape_value(kind, q, a) * own.col(static_cast<Eigen::Index>(a));
      const Vector3d& at = places[point];
      out.displacement +=
          shapes[e].volume[q] * (here - KnownSolution::displacement(at)).squaredNorm();
      out.strain +=
          shapes[e].volume[q] *
          (element_deformation(shapes[e], own, q) - KnownSolution::deformation(at)).squaredNorm();
    }
  }
  return {std::sqrt(out.strain), std::sqrt(out.displacement)};
}

/// What halving the cells does, as powers of the size.
Errors orders_of(HexElement kind, int cells, double poisson_ratio) {
  const Errors coarse = errors_of(kind, cells, poisson_ratio),
               fine = errors_of(kind, 2 * cells, poisson_ratio);
  return {std::log2(coarse.strain / fine.strain),
          std::log2(coarse.displacement / fine.displacement)};
}

// Theory: degree of the element in strain (and the energy norm), one more in displacement.

TEST(ConvergenceOrder, OfDisplacementElements) {
  const Errors order = orders_of(HexElement::kDisplacement, 4, 0.3);
  EXPECT_NEAR(order.strain, 1, 0.1);
  EXPECT_NEAR(order.displacement, 2, 0.15);
}

TEST(ConvergenceOrder, OfMeanDilatation) {
  const Errors order = orders_of(HexElement::kMeanDilatation, 4, 0.49);
  EXPECT_NEAR(order.strain, 1, 0.1);
  EXPECT_NEAR(order.displacement, 2, 0.15);
}

TEST(ConvergenceOrder, OfCentroidDilatation) {
  const Errors order = orders_of(HexElement::kCentroidDilatation, 4, 0.49);
  EXPECT_NEAR(order.strain, 1, 0.1);
  EXPECT_NEAR(order.displacement, 2, 0.15);
}

TEST(ConvergenceOrder, OfQuadraticElements) {
  const Errors order = orders_of(HexElement::kQuadratic, 2, 0.49);
  EXPECT_NEAR(order.strain, 2, 0.2);
  EXPECT_NEAR(order.displacement, 3, 0.3);
}

}  // namespace
}  // namespace thenar
