// The middle fingers of [Synek2019]: forces of one tendon at a time in four postures, of two human
// specimens. Errors are relative: RMS |predicted - measured| / RMS |measured| over 24 vectors.

#include <array>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "studies/questions/fit_study.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using sample::experiment;
using sample::finger_inputs;

/// A subject as its file says, nothing fitted: no friction, moments only in the flexion plane.
ForceError error_without_fit(const SourceText& subject, const std::string& specimen) {
  return predict_as_published(subject, experiment(specimen)).error;
}

ForceError error_without_fit(const std::string& subject, const std::string& specimen) {
  return error_without_fit(sample::source("subjects/" + subject), specimen);
}

constexpr double kTwoDigits = 0.005;  // a number published as 0.32 lies in 0.315 .. 0.325

// -- The published model ----------------------------------------------------------------------

TEST(PublishedMiddleFinger, CalibratedModelErrsAsPublishedOnH01) {
  const ForceError error = error_without_fit("synek2019_middle", "H01");
  EXPECT_NEAR(error.relative, 0.32, kTwoDigits);
  EXPECT_NEAR(error.relative_flexion, 0.29, kTwoDigits);
}

TEST(PublishedMiddleFinger, CalibratedModelErrsAsPublishedOnH02) {
  const ForceError error = error_without_fit("synek2019_middle", "H02");
  EXPECT_NEAR(error.relative, 0.49, kTwoDigits);
  EXPECT_NEAR(error.relative_flexion, 0.30, kTwoDigits);
}

TEST(PublishedMiddleFinger, NormativeModelErrsAsPublished) {
  EXPECT_NEAR(error_without_fit("an_chao_middle", "H01").relative, 0.56, kTwoDigits);
  EXPECT_NEAR(error_without_fit("an_chao_middle", "H02").relative, 0.60, kTwoDigits);
}

// With the sign slip of the source left in, the ulnar interosseous extends the knuckle.
TEST(PublishedMiddleFinger, SignSlipOfTheSourceExplainsTheOtherNumber) {
  SourceText subject = sample::source("subjects/an_chao_middle");
  const std::string mended = "[0.4, -0.264, -0.358]";
  const std::size_t at = subject.text.find(mended);
  ASSERT_NE(at, std::string::npos);
  subject.text.replace(at, mended.size(), "[0.4, 0.264, -0.358]");
  EXPECT_NEAR(error_without_fit(subject, "H02").relative, 0.66, kTwoDigits);
}

// What a model has to beat at least: no mechanics at all.
TEST(PublishedMiddleFinger, MeanOfOtherPosturesErrsAsComputedApart) {
  EXPECT_NEAR(mean_of_other_postures(experiment("H01")).error.relative, 0.36, kTwoDigits);
  EXPECT_NEAR(mean_of_other_postures(experiment("H02")).error.relative, 0.505, 0.0005);
}

// FDS in the hook, derived in the plane with nothing of the library: joint torques by levers of
// straight runs, then three equations  z . (r_j x F) + M = tau_j  for Fx, Fy and the moment, and
// one for the radial force about the abduction axis, which turns with the knuckle (here by zero).
TEST(PublishedMiddleFinger, OneTrialFollowsFromPlaneStatics) {
  constexpr double kUnit = 23.63e-3;
  constexpr double kTension = 0.950 * 9.81 * 0.835;  // [N]
  const double pip_angle = 65 * kDegree, dip_angle = pip_angle + 50 * kDegree;
  const auto along = [](double angle, double x, double y) {
    return Vector3d(x * std::cos(angle) - y * std::sin(angle),
                    x * std::sin(angle) + y * std::cos(angle), 0);
  };
  // Joint centres and tip, the knuckle at the origin, the finger pointing to -x.
  const Vector3d mcp = Vector3d::Zero(), pip(-(0.37 + 1.62) * kUnit, 0, 0);
  const Vector3d dip = pip + along(pip_angle, -1.22 * kUnit, 0);
  const Vector3d tip = dip + along(dip_angle, -(0.17 * kUnit + 15e-3), 0);

  // Points of FDS, distal then proximal of each joint, out of the supplement.
  const Vector3d mcp_a = kUnit * Vector3d(-0.324383 - 0.37, -0.293777, 0.039);
  const Vector3d mcp_b = kUnit * Vector3d(0.487138, -0.561029, 0.019);
  Vector3d pip_a = pip + kUnit * along(pip_angle, -0.263961 - 0.22, -0.162744);
  Vector3d pip_b = pip + kUnit * Vector3d(0.331558, -0.132840, 0);
  pip_a.z() = 0.001 * kUnit;
  pip_b.z() = -0.016 * kUnit;
  const Vector3d mcp_torque = kTension * (mcp_a - mcp).cross((mcp_b - mcp_a).normalized());
  const Vector3d pip_torque = kTension * (pip_a - pip).cross((pip_b - pip_a).normalized());

  Matrix3d A;
  const std::array centres{mcp, pip, dip};
  for (int j = 0; j < 3; ++j) {
    const Vector3d r = tip - centres[j];
    A.row(j) << -r.y(), r.x(), 1;
  }
  const Vector3d load = A.inverse() * Vector3d(mcp_torque.z(), pip_torque.z(), 0);
  const double radial = mcp_torque.y() / Vector3d::UnitY().dot(tip.cross(Vector3d::UnitZ()));
  const Vector3d in_digit = along(-dip_angle, load.x(), load.y());

  const sample::FitSetup setup = sample::middle_finger("");
  const ExperimentPlan plan =
      plan_experiment(setup.digit, setup.parameters, setup.experiments.front());
  const Eigen::Matrix3Xd forces =
      force_values(setup.digit, setup.parameters, plan, Eigen::VectorXd::Zero(0));
  const Eigen::Index hook = 18;  // FDS in the last posture
  EXPECT_TRUE(matrix_near(forces.col(hook), Vector3d(in_digit.x(), in_digit.y(), radial), 1e-5));
}

// -- Our fits ---------------------------------------------------------------------------------

struct Bar {
  const char* specimen;
  double in_sample, left_out;  // relative errors that a fit must beat [1]
};

void PrintTo(const Bar& bar, std::ostream* out) { *out << bar.specimen; }

class FingerFit : public testing::TestWithParam<Bar> {};

TEST_P(FingerFit, FitsAndPredictsBetterThanEveryPublishedModel) {
  const Bar bar = GetParam();
  const Fit fit = run_fit(finger_inputs("an_chao_middle", {bar.specimen}));
  EXPECT_EQ(fit.solution.status, Status::kSolved) << fit.solution.message;
  const double in_sample = predict_fitted(fit.problem, fit.solution.z, 0).error.relative;
  EXPECT_LT(in_sample, bar.in_sample);

  const CrossValidation left_out = cross_validate(fit.problem, LeaveOut::kPosture);
  EXPECT_EQ(left_out.not_converged, 0);
  EXPECT_EQ(left_out.folds.size(), 4U);
  EXPECT_EQ(left_out.experiments[0].trials.size(), 24U);
  EXPECT_LT(left_out.experiments[0].error.relative, bar.left_out);
  RecordProperty("in_sample", fmt::format("{:.3f}", in_sample));
  RecordProperty("left_out", fmt::format("{:.3f}", left_out.experiments[0].error.relative));
}

// Left out, the published calibrated model (which saw both specimens) errs 0.32 and 0.49.
INSTANTIATE_TEST_SUITE_P(Human, FingerFit,
                         testing::Values(Bar{"H01", 0.20, 0.32}, Bar{"H02", 0.30, 0.45}),
                         [](const auto& test) { return std::string(test.param.specimen); });

TEST(FingerPopulation, OneFitServesBothSpecimens) {
  const Fit fit = run_fit(finger_inputs("synek2019_middle", {"H01", "H02"}));
  EXPECT_EQ(fit.solution.status, Status::kSolved) << fit.solution.message;
  EXPECT_LT(predict_fitted(fit.problem, fit.solution.z, 0).error.relative, 0.20);
  EXPECT_LT(predict_fitted(fit.problem, fit.solution.z, 1).error.relative, 0.30);
}

// What one finger teaches of people at large must help to predict the next one.
TEST(FingerPopulation, UnseenSpecimenIsPredictedBetterThanByTheNormativeFinger) {
  const FitProblem problem = build_problem(finger_inputs("an_chao_middle", {"H01", "H02"}));
  const CrossValidation left_out = cross_validate(problem, LeaveOut::kSpecimen);
  EXPECT_EQ(left_out.not_converged, 0);
  for (std::size_t e = 0; e < 2; ++e) {
    const double error = left_out.experiments[e].error.relative;
    RecordProperty(problem.specimens()[e], fmt::format("{:.3f}", error));
    EXPECT_LT(error, error_without_fit("an_chao_middle", problem.specimens()[e]).relative);
  }
}

}  // namespace
}  // namespace thenar
