// Tests for pads/element_sums.cpp: four points at a time against one by one.

#include "pads/element_sums.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Core>
#include <Eigen/LU>

#include "pads/tissue.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double kSumRounding = 1e-11;  // of sums of some hundred products near 1 [1]

/// Random gradients, displacements and stresses of an element.
struct RandomElement {
  RandomElement(int its_nodes, int its_points, unsigned seed)
      : nodes(its_nodes), points(its_points) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 3 * nodes * points; ++i) gradient.push_back(unit(rng));
    for (int i = 0; i < 3 * nodes; ++i) u.push_back(0.05 * unit(rng));
    for (double& each : stress.tau) each = unit(rng);
    for (double& each : stress.c) each = unit(rng);
    point_kinematics(nodes, points, gradient.data(), u.data(), at);
  }
  [[nodiscard]] Vector3d vector_of(const double* values, int a, int q) const {
    Vector3d out;
    for (int j = 0; j < 3; ++j) out[j] = values[(3 * a + j) * points + q];
    return out;
  }
  [[nodiscard]] Matrix3d F(int q) const {
    Matrix3d out = Matrix3d::Identity();
    for (int a = 0; a < nodes; ++a)
      out += Eigen::Map<const Vector3d>(&u[static_cast<std::size_t>(3 * a)]) *
             vector_of(gradient.data(), a, q).transpose();
    return out;
  }
  [[nodiscard]] Matrix3d tau(int q) const {
    Voigt out;
    for (int p = 0; p < 6; ++p) out[p] = stress.tau[p * points + q];
    return tensor_of(out);
  }
  [[nodiscard]] VoigtTangent tangent(int q) const {
    VoigtTangent out;
    for (int p = 0; p < 6; ++p)
      for (int r = p; r < 6; ++r)
        out(p, r) = out(r, p) = stress.c[tangent_entry(p, r) * points + q];
    return out;
  }
  /// B of a node, Voigt strains (xx, yy, zz, xy, yz, zx) of its displacement (6, 3).
  [[nodiscard]] Eigen::Matrix<double, 6, 3> B(int a, int q) const {
    const Vector3d g = vector_of(at.g, a, q);
    Eigen::Matrix<double, 6, 3> out;
    for (int i = 0; i < 3; ++i) {
      const Matrix3d slope = Vector3d::Unit(i) * g.transpose();
      out.col(i) = voigt_of(slope + slope.transpose());
      out.col(i).head<3>() /= 2;
    }
    return out;
  }

  int nodes, points;
  std::vector<double> gradient, u;
  PointStresses stress{};
  PointKinematics at{};
};

std::vector<RandomElement> both_kinds() { return {{8, 8, 1}, {27, 28, 2}}; }

TEST(ElementSums, DeformationGradientsAndTheirInverses) {
  for (const RandomElement& element : both_kinds())
    for (int q = 0; q < element.points; ++q) {
      const Matrix3d F = element.F(q);
      Matrix3d found;
      for (int k = 0; k < 9; ++k) found(k % 3, k / 3) = element.at.F[k * element.points + q];
      EXPECT_TRUE(matrix_near(found, F, kSumRounding));
      EXPECT_NEAR(element.at.J[q], F.determinant(), kSumRounding);
      // F' g = dN/dX
      for (int a = 0; a < element.nodes; ++a)
        EXPECT_TRUE(matrix_near(F.transpose() * element.vector_of(element.at.g, a, q),
                                element.vector_of(element.gradient.data(), a, q), kSumRounding));
    }
}

// tau : grad(v) = f . v  for every motion v of the nodes; and what was there stays.
TEST(ElementSums, ForcesDoTheWorkOfStresses) {
  for (const RandomElement& element : both_kinds()) {
    std::vector<double> force(static_cast<std::size_t>(3 * element.nodes), 0.5);
    add_forces(element.nodes, element.points, element.at.g, element.stress, force.data());
    for (int a = 0; a < element.nodes; ++a) {
      Vector3d wanted = Vector3d::Constant(0.5);
      for (int q = 0; q < element.points; ++q)
        wanted += element.tau(q) * element.vector_of(element.at.g, a, q);
      EXPECT_TRUE(matrix_near(Eigen::Map<const Vector3d>(&force[static_cast<std::size_t>(3 * a)]),
                              wanted, kSumRounding));
    }
  }
}

// Blocks a <= b of  sum B_a' c B_b + (g_a . tau g_b) 1.
TEST(ElementSums, StiffnessIsMaterialAndGeometric) {
  for (const RandomElement& element : both_kinds()) {
    const int n = 3 * element.nodes;
    MatrixXd K = MatrixXd::Zero(n, n);
    add_stiffness(element.nodes, element.points, element.at.g, element.stress, K.data());
    for (int b = 0; b < element.nodes; ++b)
      for (int a = 0; a <= b; ++a) {
        Matrix3d wanted = Matrix3d::Zero();
        for (int q = 0; q < element.points; ++q) {
          wanted += element.B(a, q).transpose() * element.tangent(q) * element.B(b, q);
          wanted += element.vector_of(element.at.g, a, q)
                        .dot(element.tau(q) * element.vector_of(element.at.g, b, q)) *
                    Matrix3d::Identity();
        }
        EXPECT_TRUE(matrix_near(K.block<3, 3>(3 * a, 3 * b), wanted, 10 * kSumRounding))
            << a << " " << b;
      }
  }
}

// The 21 places of a symmetric tangent of 6 rows, row by row.
TEST(ElementSums, NumbersTheUpperTriangleRowByRow) {
  int next = 0;
  for (int p = 0; p < 6; ++p)
    for (int q = p; q < 6; ++q) EXPECT_EQ(tangent_entry(p, q), next++);
  EXPECT_EQ(next, 21);
  EXPECT_EQ(padded_points(8), 8);
  EXPECT_EQ(padded_points(27), 28);
}

}  // namespace
}  // namespace thenar
