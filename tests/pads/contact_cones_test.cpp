// Tests for pads/contact_cones.cpp: a linear body under exact cones, against dense algebra.

#include "pads/contact_cones.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "geometry/primitives.h"
#include "tests/matrix_near.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kDenseError = 1e-9;  // of forces by dense algebra [1]

/// A small block, its tangent at rest, and gaps below a slab.
struct BlockUnderSlab {
  TissueBlock block{
      graded_box(even_axis(-2e-3, 2e-3, 2), even_axis(-2e-3, 2e-3, 2), even_axis(-3e-3, 0, 2)),
      {neo_hookean(12e3, 0.4)}};
  TissueResponse tissue;
  MeanGaps gaps{block.surface};
  ContactCones cones{*block.body};
  Eigen::Index nodes = static_cast<Eigen::Index>(block.surface.nodes.size());

  /// @param depth  of the slab in the block at rest [m]
  explicit BlockUnderSlab(double depth) {
    const VectorXd rest = VectorXd::Zero(block.body->unknowns());
    block.body->evaluate(block.body->node_displacements(rest, {}), 0, {}, {},
                         ElementRequest::kStiffness, tissue);
    Pose<double> X;
    X.p[2] = 0.01 - depth;
    gaps.update(*build_box({0.1, 0.1, 0.02}), X, rest);
    EXPECT_TRUE(cones.factor(tissue.tangent, Matrix3Xd(3, 0)));
  }
  [[nodiscard]] MatrixXd tangent() const {
    const SymmetricPattern& pattern = block.body->pattern();
    MatrixXd out = MatrixXd::Zero(pattern.size, pattern.size);
    for (int column = 0; column < pattern.size; ++column)
      for (int k = pattern.starts[static_cast<std::size_t>(column)];
           k < pattern.starts[static_cast<std::size_t>(column) + 1]; ++k) {
        const int row = pattern.rows[static_cast<std::size_t>(k)];
        out(row, column) = out(column, row) = tissue.tangent[static_cast<std::size_t>(k)];
      }
    return out;
  }
  /// @param slip  of all nodes [m] (3)
  ContactCones::Equilibrium rest(double friction, const Vector3d& slip,
                                 const std::optional<ContactCones::Drive>& drive = {}) {
    const VectorXd normal = VectorXd::Zero(nodes), force = VectorXd::Zero(block.body->unknowns());
    const Matrix3Xd shear = Matrix3Xd::Zero(3, nodes), slips = slip.replicate(1, nodes);
    return cones.solve(block.surface, {force, gaps, slips, normal, shear, friction, drive});
  }
  /// Forces of the slab on free nodes: along its normal, -z, and friction.
  [[nodiscard]] VectorXd on_nodes(const ContactCones::Equilibrium& rest) const {
    VectorXd out = VectorXd::Zero(block.body->unknowns());
    for (Eigen::Index k = 0; k < nodes; ++k) {
      auto at = out.segment<3>(3 * block.surface.nodes[static_cast<std::size_t>(k)]);
      at = rest.friction_force.col(k);
      at[2] -= rest.normal_force[k];
    }
    return out;
  }
};

// Answers to unit forces are columns of the inverse of the tangent.
TEST(ContactCones, CondensedAnswersAreColumnsOfTheInverse) {
  const BlockUnderSlab sample(0);
  CondensedBody body(*sample.block.body);
  ASSERT_TRUE(body.factor(sample.tissue.tangent));
  const MatrixXd inverse = sample.tangent().inverse();
  const auto& nodes = sample.block.surface.nodes;
  body.condense(sample.block.surface, {4});
  body.condense(sample.block.surface, {0, 4, 7});  // what is known is not asked again
  for (const std::size_t asked : {0U, 4U, 7U})
    for (std::size_t k = 0; k < nodes.size(); ++k)
      EXPECT_TRUE(matrix_near(body.unit_response(static_cast<int>(asked))
                                  .middleRows<3>(static_cast<Eigen::Index>(3 * k)),
                              inverse.block<3, 3>(3 * nodes[k], 3 * nodes[asked]),
                              1e-10 * inverse.maxCoeff()));
}

// Without friction: A dx = forces, gaps close, and only what touches is pushed.
TEST(ContactCones, FrictionlessRestIsComplementary) {
  BlockUnderSlab sample(0.1e-3);
  const ContactCones::Equilibrium rest = sample.rest(0, Vector3d::Zero());
  ASSERT_EQ(rest.status, Status::kSolved);
  const VectorXd forces = sample.on_nodes(rest);
  EXPECT_LT((sample.tangent() * rest.dx - forces).norm(), kDenseError * forces.norm());
  EXPECT_EQ(rest.friction_force.norm(), 0);
  double total = 0;
  for (Eigen::Index k = 0; k < sample.nodes; ++k) {
    const auto place = static_cast<std::size_t>(k);
    const double gap = sample.gaps.gap(place) - rest.dx[3 * sample.block.surface.nodes[place] + 2];
    EXPECT_GE(rest.normal_force[k], 0);
    EXPECT_GE(gap, -1e-10);
    EXPECT_LT(rest.normal_force[k] * gap, 1e-13);
    total += rest.normal_force[k];
  }
  EXPECT_GT(total, 0);
}

// After a long slip every node that bears slides: friction is mu times its push, against the slip.
TEST(ContactCones, LongSlipsSlideAgainstTheirWay) {
  const double mu = 0.3;
  BlockUnderSlab sample(0.1e-3);
  const ContactCones::Equilibrium rest = sample.rest(mu, Vector3d(0.05, 0, 0));
  ASSERT_EQ(rest.status, Status::kSolved);
  const VectorXd forces = sample.on_nodes(rest);
  EXPECT_LT((sample.tangent() * rest.dx - forces).norm(), kDenseError * forces.norm());
  for (Eigen::Index k = 0; k < sample.nodes; ++k) {
    EXPECT_NEAR(rest.friction_force.col(k).norm(), mu * rest.normal_force[k],
                1e-9 * rest.normal_force.maxCoeff());
    // Motions are below 1 mm, so that slips go along x within a fiftieth.
    if (rest.normal_force[k] > 0) {
      EXPECT_LT(rest.friction_force(0, k), -0.99 * mu * rest.normal_force[k]);
    }
  }
}

// With much friction no node slips: dx undoes the slip of each that bears.
TEST(ContactCones, StickUndoesSmallSlips) {
  BlockUnderSlab sample(0.2e-3);
  const Vector3d slip(1e-6, -2e-6, 0);
  const ContactCones::Equilibrium rest = sample.rest(50, slip);
  ASSERT_EQ(rest.status, Status::kSolved);
  for (Eigen::Index k = 0; k < sample.nodes; ++k) {
    if (rest.normal_force[k] <= 0) continue;
    const int node = sample.block.surface.nodes[static_cast<std::size_t>(k)];
    EXPECT_LT((rest.dx.segment<2>(3 * node) + slip.head<2>()).norm(), 1e-11) << k;
  }
}

// A force that drives the slab is what nodes bear and its own spring holds.
TEST(ContactCones, DriveIsBorneByNodesAndItsSpring) {
  BlockUnderSlab sample(0);
  const double force = 0.05, spring = 3;
  const ContactCones::Equilibrium rest =
      sample.rest(0.3, Vector3d::Zero(), ContactCones::Drive{-Vector3d::UnitZ(), force, spring, 1});
  ASSERT_EQ(rest.status, Status::kSolved);
  EXPECT_GT(rest.object_motion, 0);
  EXPECT_NEAR(rest.normal_force.sum() + spring * rest.object_motion, force, 1e-9 * force);
}

TEST(ContactCones, DriveStopsAtItsLongestMotion) {
  BlockUnderSlab sample(0);
  const ContactCones::Equilibrium rest =
      sample.rest(0, Vector3d::Zero(), ContactCones::Drive{-Vector3d::UnitZ(), 10, 3, 1e-5});
  ASSERT_EQ(rest.status, Status::kSolved);
  EXPECT_EQ(rest.object_motion, 1e-5);
  EXPECT_LT(rest.normal_force.sum(), 10);
}

// Forces that turn with an object that nothing resists: the slope of the force is that of a turned
// vector, of the moment that of r x f with r at rest.
TEST(ContactCones, SlopeOfForcesThatOnlyTurn) {
  const Matrix3Xd places = (Matrix3Xd(3, 2) << 1, 0.2, -0.5, 2, 0.3, 1).finished(),
                  forces = (Matrix3Xd(3, 2) << 0.1, 4, -2, 1, 3, -0.5).finished();
  const Eigen::Matrix<double, 6, 6> slope =
      object_stiffness(places, forces, [](const Matrix3Xd& rigid, const Matrix3Xd& turned) {
        return MotionResponse{turned, Matrix3Xd::Zero(3, rigid.cols())};
      });
  Eigen::Matrix<double, 6, 6> wanted = Eigen::Matrix<double, 6, 6>::Zero();
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < 2; ++k) {
      const Vector3d turned = Vector3d::Unit(axis).cross(Vector3d(forces.col(k)));
      wanted.block<3, 1>(0, axis) += Vector3d(places.col(k)).cross(turned);
      wanted.block<3, 1>(3, axis) += turned;
    }
  EXPECT_TRUE(matrix_near(slope, wanted, 1e-14));
}

}  // namespace
}  // namespace thenar
