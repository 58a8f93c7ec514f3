// Tests for tendons/wrapping/arm_derivatives.cpp.

#include "tendons/wrapping/arm_slopes.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tendons/wrapping/fitted_path.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"
#include "tests/tendons/wrapping/wrap_samples.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const VectorXd kBent = Vector3d(0.5, 0.7, 0.4);

std::vector<ArmDerivatives> slopes_at(const Tree<double>& tree, const PathSet& set,
                                      const VectorXd& q) {
  PathSolver solver(set);
  const TreeState<double> state = pose_tree(tree, q);
  return arm_derivatives(tree, state, set, solver.solve(state), static_cast<int>(q.size()));
}

/// Arms of all paths, and which surfaces each touches.
struct ArmsAt {
  MatrixXd R;
  std::vector<std::vector<int>> touched;
};
ArmsAt arms_at(const Tree<double>& tree, PathSolver& solver, const VectorXd& q) {
  const TreeState<double> state = pose_tree(tree, q);
  const auto& shapes = solver.solve(state);
  ArmsAt at{MatrixXd(shapes.size(), q.size()), {}};
  path_arms(tree, state, solver.set(), shapes, at.R);
  for (const PathShape& shape : shapes) {
    at.touched.emplace_back();
    for (const PathArc& arc : shape.arcs) at.touched.back().push_back(arc.surface);
    at.touched.back().push_back(shape.ride_span);
  }
  return at;
}

/// Slopes of the arms by central differences of fourth order; a path whose surfaces change within
/// the steps has none.
std::vector<ArmDerivatives> measured(const Tree<double>& tree, const PathSet& set,
                                     const VectorXd& q) {
  constexpr double h = 1e-3;  // [rad]
  PathSolver solver(set);
  const ArmsAt here = arms_at(tree, solver, q);
  std::vector<ArmDerivatives> slopes(set.paths.size(), {true, MatrixXd::Zero(q.size(), q.size())});
  for (Eigen::Index l = 0; l < q.size(); ++l)
    for (const auto& [step, weight] :
         {std::pair{h, 8.0}, {-h, -8.0}, {2 * h, -1.0}, {-2 * h, 1.0}}) {
      const ArmsAt there = arms_at(tree, solver, q + step * VectorXd::Unit(q.size(), l));
      for (std::size_t k = 0; k < slopes.size(); ++k) {
        slopes[k].exist = slopes[k].exist && there.touched[k] == here.touched[k];
        slopes[k].dR.col(l) +=
            weight / (12 * h) * there.R.row(static_cast<Eigen::Index>(k)).transpose();
      }
    }
  return slopes;
}

class ArmSlopesOver : public testing::TestWithParam<SurfaceShape> {};

TEST_P(ArmSlopesOver, AreTheSlopesOfTheArms) {
  const PathSet set = sample::extensor(GetParam());
  const ArmDerivatives slopes = slopes_at(sample::finger(), set, kBent)[0];
  ASSERT_TRUE(slopes.exist);
  // Arms good to 1e-13 m/rad over 1e-3 rad.
  EXPECT_TRUE(matrix_near(slopes.dR, measured(sample::finger(), set, kBent)[0].dR, 1e-9));
  EXPECT_GT(slopes.dR.cwiseAbs().maxCoeff(), 1e-4);
}

// A second derivative does not care for the order.
TEST_P(ArmSlopesOver, AreSymmetric) {
  const MatrixXd dR = slopes_at(sample::finger(), sample::extensor(GetParam()), kBent)[0].dR;
  EXPECT_TRUE(matrix_near(dR, MatrixXd(dR.transpose()), 1e-12));
}

INSTANTIATE_TEST_SUITE_P(EveryShape, ArmSlopesOver,
                         testing::Values(SurfaceShape::kCylinder, SurfaceShape::kSphere,
                                         SurfaceShape::kEllipsoid, SurfaceShape::kCapsule,
                                         SurfaceShape::kTorus),
                         [](const auto& test) { return "Shape" + std::to_string(test.index); });

// One hinge and a cylinder of radius r about its axis: the arm is r whatever the posture. Off the
// cylinder, two points at distances a and b from the axis: L^2 = a^2 + b^2 - 2 a b cos(angle).
TEST(ArmDerivatives, AreThoseOfATriangleAndOfAPulley) {
  const Tree<double> tree{{-1, 0, 1, 0, Vector3d::UnitZ(), {0, 0, 0}}};
  const double a = 0.03, b = 0.02, r = 0.008;
  PathSet set = sample::string_over({{"pulley", -1, SurfaceShape::kCylinder, {r, 1, 0}, {}}},
                                    {0, a, 0}, {0, b, 0}, {-1, 0, 0});
  set.paths[0].points[0].link = 0;             // turns over to -x
  const double wrapped = 2.5, straight = 0.6;  // angles between the points [rad]
  const ArmDerivatives over = slopes_at(tree, set, VectorXd::Constant(1, wrapped))[0];
  ASSERT_TRUE(over.exist);
  EXPECT_NEAR(over.dR(0, 0), 0, 1e-14);
  const double L = std::sqrt(a * a + b * b - 2 * a * b * std::cos(straight));
  const double slope = a * b * std::sin(straight) / L;
  const double curve = a * b * std::cos(straight) / L - slope * slope / L;
  EXPECT_NEAR(slopes_at(tree, set, VectorXd::Constant(1, straight))[0].dR(0, 0), -curve, 1e-15);
}

TEST(ArmDerivatives, DoNotExistWhereAPathIsNotTaut) {
  PathSet set = sample::extensor(SurfaceShape::kCylinder);
  set.paths[0].points[1].p = {-0.079, 0.001, 0};  // inside the bone
  EXPECT_FALSE(slopes_at(sample::finger(), set, kBent)[0].exist);
}

// The polynomials' second derivatives are exact, and near those of the wrapped path.
TEST(ArmDerivatives, OfFittedPathsAreThoseOfTheirPolynomials) {
  const Tree<double> tree = sample::finger();
  const PathSet set = sample::extensor(SurfaceShape::kCylinder);
  const FitBox box{Vector3d(0.3, 0.5, 0.2), Vector3d(0.7, 0.9, 0.6)};
  const FittedPath path = fit_path(tree, set, 0, box, 12);
  const MatrixXd dR = arm_derivatives(path, kBent);
  constexpr double h = 1e-4;  // [rad]
  for (Eigen::Index l = 0; l < 3; ++l) {
    const VectorXd step = h * VectorXd::Unit(3, l);
    const VectorXd slope =
        (fitted_length(path, kBent + step).arms - fitted_length(path, kBent - step).arms) / (2 * h);
    EXPECT_TRUE(matrix_near(VectorXd(dR.col(l)), slope, 1e-8));
  }
  EXPECT_TRUE(matrix_near(dR, slopes_at(tree, set, kBent)[0].dR, 1e-7));
}

// Every tendon of every subject, wrapped and through via points, whole hands with their wrists.
TEST(ArmDerivatives, OfAllSubjectsAreTheSlopesOfTheArms) {
  int compared = 0, curved = 0;
  sample::Draw draw(3);
  for (const auto& file : std::filesystem::directory_iterator(THENAR_DATA_DIR "/subjects")) {
    if (file.path().extension() != ".toml") continue;
    const Subject subject = read_subject(file.path().string());
    const Skeleton skeleton = build_skeleton(subject);
    const PathSet set = build_paths(subject, skeleton);
    for (int posture = 0; posture < 3; ++posture) {
      const VectorXd q = draw.posture(skeleton);
      const auto exact = slopes_at(skeleton.tree, set, q);
      const auto differences = measured(skeleton.tree, set, q);
      for (std::size_t k = 0; k < exact.size(); ++k) {
        if (!exact[k].exist || !differences[k].exist) continue;
        EXPECT_TRUE(matrix_near(exact[k].dR, differences[k].dR, 2e-8))
            << subject.name << " " << set.paths[k].name;
        EXPECT_TRUE(matrix_near(exact[k].dR, MatrixXd(exact[k].dR.transpose()), 1e-11))
            << subject.name << " " << set.paths[k].name;
        ++compared;
        curved += exact[k].dR.cwiseAbs().maxCoeff() > 1e-4 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 150);
  EXPECT_GT(curved, 100);
}

}  // namespace
}  // namespace thenar
