// Tests for fits of fingers whose axes are all parallel, to forces in the plane in which they flex.

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/prediction.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using sample::FitSetup;
using sample::planar_finger;
using sample::planar_trials;

const std::string kTwo = "components = ['proximal', 'dorsal']";

/// A point of a link after the joints before it turned, by hand: link 0 stands still.
/// @param p  where the finger is straight [m]
Vector2d turned(const Vector3d& q, int link, Vector2d p) {
  const double joints[] = {0.090, 0.045, 0.020};
  for (int j = link - 1; j >= 0; --j) {
    const Vector2d joint(joints[j], 0);
    p = joint + Eigen::Rotation2Dd(q[j]) * (p - joint);
  }
  return p;
}

/// Points of a tendon: the link and the place, straight [m].
struct HandPoint {
  int link;
  double x, y;
};

double length_of(const std::vector<HandPoint>& path, const Vector3d& q) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += (turned(q, path[i].link, {path[i].x, path[i].y}) -
               turned(q, path[i - 1].link, {path[i - 1].x, path[i - 1].y}))
                  .norm();
  return length;
}

/// Force in the plane that balances the tendons, (proximal, dorsal) of the last link, in least
/// squares over the three joints: arms and Jacobian by differences of the drawing above.
Vector2d force_by_hand(const Vector3d& q, double fdp, double fds) {
  const std::vector<HandPoint> deep{{3, 0.014, -0.004}, {2, 0.028, -0.005}, {2, 0.040, -0.006},
                                    {1, 0.054, -0.007}, {1, 0.080, -0.009}, {0, 0.098, -0.010}};
  const std::vector<HandPoint> superficial{
      {2, 0.038, -0.006}, {1, 0.055, -0.008}, {1, 0.080, -0.010}, {0, 0.098, -0.012}};
  constexpr double kStep = 1e-6;
  Vector3d torque;
  Eigen::Matrix<double, 2, 3> J;
  for (int j = 0; j < 3; ++j) {
    const Vector3d more = q + kStep * Vector3d::Unit(j), less = q - kStep * Vector3d::Unit(j);
    torque[j] = -(fdp * (length_of(deep, more) - length_of(deep, less)) +
                  fds * (length_of(superficial, more) - length_of(superficial, less))) /
                (2 * kStep);
    J.col(j) = (turned(more, 3, {0, -0.004}) - turned(less, 3, {0, -0.004})) / (2 * kStep);
  }
  const Vector2d world = (J * J.transpose()).inverse() * J * torque;
  return Eigen::Rotation2Dd(-q.sum()) * world;
}

const Vector3d kBent = Vector3d(30, 45, 20) * kDegree;
const Vector3d kHook = Vector3d(10, 70, 40) * kDegree;

std::string numbers(const Vector2d& f) { return fmt::format("[{:.15g}, {:.15g}]", f.x(), f.y()); }

/// The finger, measured where it presses as drawn by hand.
FitSetup measured_by_hand() {
  return planar_finger(planar_trials(kTwo, numbers(force_by_hand(kBent, 10, 0)),
                                     numbers(force_by_hand(kHook, 3, 8))));
}

// Differences of steps of 1e-6 err by 1e-10 of a length in a step.
TEST(PlanarFinger, PressesAsDrawnByHand) {
  const FitProblem problem = measured_by_hand().problem();
  const Prediction prediction = predict_fitted(problem, VectorXd::Zero(problem.size()), 0);
  for (const PredictedTrial& trial : prediction.trials) {
    EXPECT_EQ(trial.components, 2);
    EXPECT_TRUE(matrix_near(trial.predicted.head<2>(), trial.measured.head<2>(), 1e-7));
    EXPECT_GT(trial.measured.norm(), 0.1);
  }
}

// A hand calculation of one posture by its own signs: pulling a flexor presses to the palm.
TEST(PlanarFinger, PressesPalmarWhereItsFlexorPulls) {
  EXPECT_LT(force_by_hand(kBent, 10, 0).y(), 0);
}

TEST(PlanarFinger, TakesTwoComponentsOrThreeOfWhichOneIsNotModelled) {
  const FitProblem two = planar_finger().problem();
  const FitProblem three =
      planar_finger(
          planar_trials("components = ['proximal', 'dorsal', 'radial']\nnot_modelled = 'radial'",
                        "[-0.6, -1.2, 0.4]", "[-0.9, -1, -3]"))
          .problem();
  std::mt19937 rng(1);
  const VectorXd z = sample::normal(two.size(), rng);
  EXPECT_EQ(fit_residuals(two, z, WithJacobian::kNo).r,
            fit_residuals(three, z, WithJacobian::kNo).r);
  EXPECT_EQ(measured_numbers(three), 4);
}

TEST(PlanarFinger, OrderAndSignOfComponentsChangeNoResidual) {
  const FitProblem plain = planar_finger().problem();
  const FitProblem turned_round = planar_finger(planar_trials("components = ['palmar', 'proximal']",
                                                              "[1.2, -0.6]", "[1, -0.9]"))
                                      .problem();
  const VectorXd z = VectorXd::Zero(plain.size());
  EXPECT_NEAR(fit_residuals(plain, z, WithJacobian::kNo).r.squaredNorm(),
              fit_residuals(turned_round, z, WithJacobian::kNo).r.squaredNorm(), 1e-9);
}

TEST(PlanarFinger, JacobianIsThatOfDifferences) {
  const FitProblem problem = planar_finger().problem();
  std::mt19937 rng(2);
  const VectorXd z = 0.5 * sample::normal(problem.size(), rng);
  const Eigen::MatrixXd J = fit_residuals(problem, z, WithJacobian::kYes).J;
  constexpr double kStep = 1e-6;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const VectorXd step = kStep * VectorXd::Unit(z.size(), i);
    const VectorXd slope = (fit_residuals(problem, z + step, WithJacobian::kNo).r -
                            fit_residuals(problem, z - step, WithJacobian::kNo).r) /
                           (2 * kStep);
    EXPECT_TRUE(matrix_near(J.col(i), slope, 1e-7 * J.cwiseAbs().maxCoeff()));
  }
}

// Forces made by a finger whose paths are moved by `truth` are reached by a fit, whose cost is no
// more than that of the truth: its prior alone.
TEST(PlanarFinger, FitReachesForcesThatItCanMake) {
  const FitProblem start = planar_finger().problem();
  std::mt19937 rng(3);
  const VectorXd truth = sample::normal(start.size(), rng);
  const Prediction made = predict_fitted(start, truth, 0);
  const FitProblem problem =
      planar_finger(planar_trials(kTwo, numbers(made.trials[0].predicted.head<2>()),
                                  numbers(made.trials[1].predicted.head<2>())))
          .problem();
  const Solution fitted = solve(least_squares(problem), VectorXd::Zero(problem.size()));
  EXPECT_EQ(fitted.status, Status::kSolved);
  EXPECT_LE(fitted.cost, 0.5 * truth.squaredNorm() * (1 + 1e-9));
  for (const PredictedTrial& trial : predict_fitted(problem, fitted.z, 0).trials)
    EXPECT_LT((trial.predicted - trial.measured).head<2>().norm(), 0.05);  // its noise
}

TEST(PlanarFinger, SaysWhatToDoWithAForceAcrossItsPlane) {
  try {
    (void)planar_finger(planar_trials("components = ['proximal', 'dorsal', 'radial']",
                                      "[-1, -1, 0]", "[-1, -1, 0]"))
        .problem();
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("not_modelled = \"radial\""), std::string::npos)
        << e.what();
  }
}

// Two forces balance two torques; the third joint's is left over, as force_by_hand() has it. A
// clamp takes a moment, too.
TEST(PlanarFinger, WarnsOfTorqueThatAPinnedTipCannotBalance) {
  FitSetup setup = planar_finger();
  const std::vector<std::string> warnings = setup.problem().warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(
      warnings[0].find("experiment 'planar_forces': a pinned tip of a finger with 3 joints in "
                       "one plane leaves torque that nothing balances"),
      0U)
      << warnings[0];
  setup.experiments.front().hold = TipConstraint::kRigid;
  EXPECT_TRUE(setup.problem().warnings().empty());
}

}  // namespace
}  // namespace thenar
