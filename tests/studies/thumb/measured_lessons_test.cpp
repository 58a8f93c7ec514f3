// Tests for studies/thumb/measured_lessons.cpp.

#include "studies/thumb/measured_lessons.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "base/numbers.h"
#include "base/units.h"
#include "data/io/toml_node.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/studies/thumb/study_inputs.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct PublishedData {
  Experiment force;
  PinchLosses losses;
};

PublishedData published_data() {
  const MeasuredThumbInputs inputs = measured_thumb_inputs(kData);
  return {parse_experiment(inputs.force.text, inputs.force.path),
          parse_pinch_losses(inputs.losses.text, inputs.losses.path)};
}

// A sixth of 10 N at 46 deg from proximal towards palmar [Towles2004].
TEST(MeasuredLessons, ForceOfFplIsThePublishedOne) {
  const Experiment force = published_data().force;
  ASSERT_EQ(force.trials.size(), 1u);
  const Vector3d f = force.trials.front().force;
  EXPECT_NEAR(f.norm(), 10.0 / 6, 0.01);
  EXPECT_NEAR(std::atan2(f.y(), f.x()) / kDegree, 46, 0.1);
  EXPECT_EQ(f.z(), 0);
  EXPECT_EQ(force.trials.front().tension.at("FPL"), 10);
}

// Axes and arms of data/subjects/arms_five_axis_thumb.toml, written down by hand. The hinges turn
// one after the other, each about where those before it have taken its axis; J = axis x (tip -
// point), and the pinned force is (J J')^-1 J R' t, the least-squares solution of J' f = R' t. A
// numpy program gives proximal 0.17, palmar 2.27 and radial -0.09 N.
TEST(MeasuredLessons, ForceOfTheShippedThumbIsThatOfItsJacobianByHand) {
  const Vector3d axis[] = {{0.04239899, 0.66528585, -0.74538383},
                           {0.49555701, 0.73173602, 0.46795901},
                           {0.084295, 0.203488, -0.975442},
                           {0.78958745, 0.59610819, 0.14562514},
                           {0.050102, 0.479623, -0.876043}};
  const Vector3d point_mm[] = {{0, 0, 0},
                               {7.2, -5.4, -2.5},
                               {23.7, -34.6, -15.2},
                               {23.04, -33.43, -14.69},
                               {37.7, -60.5, -25.3}};
  const double angle_deg[] = {0, -10, 20, 0, 30};
  const Eigen::Matrix<double, 5, 1> tau =
      1e-3 * 10 * (Eigen::Matrix<double, 5, 1>() << 15.6, 0, 10.9, -0.1, 6.3).finished();

  // From base to tip: x -> R x + p, and each hinge as it lies by then [mm].
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero(), lies[5], points[5];
  for (int j = 0; j < 5; ++j) {
    lies[j] = R * axis[j].normalized();
    points[j] = R * point_mm[j] + p;
    const Matrix3d turn = Eigen::AngleAxisd(angle_deg[j] * kDegree, lies[j]).toRotationMatrix();
    p = points[j] + turn * (p - points[j]);
    R = turn * R;
  }
  const Vector3d tip = R * Vector3d(48.84, -81.34, -34.1) + p;
  Eigen::Matrix<double, 3, 5> J;
  for (int j = 0; j < 5; ++j) J.col(j) = 1e-3 * lies[j].cross(tip - points[j]);
  const Vector3d f = (J * J.transpose()).inverse() * (J * tau);

  // Along the distal phalanx.
  const Vector3d proximal = Vector3d(-0.441784, 0.82646, 0.348985).normalized();
  Vector3d dorsal(0.893497, 0.370407, 0.253894);
  dorsal = (dorsal - proximal * proximal.dot(dorsal)).normalized();
  const Vector3d along = R.transpose() * f;
  const Vector3d by_hand(proximal.dot(along), -dorsal.dot(along),
                         proximal.cross(dorsal).dot(along));

  const PublishedData of = published_data();
  const TendonDigit thumb = sample::thumb_of(sample::study_inputs().truth);
  const MeasuredPredictions predicted = predict_measured(thumb, {thumb.model}, of.force, of.losses);
  EXPECT_TRUE(matrix_near(predicted.force, by_hand, 1e-9));
  EXPECT_TRUE(matrix_near(by_hand, Vector3d(0.17, 2.27, -0.09), 0.006));
}

// One draw a sd off in each component of the force, one as measured; losses one sd off, as
// measured, and of a thumb that cannot press.
TEST(MeasuredLessons, LikelihoodIsThatOfGaussians) {
  const PublishedData of = published_data();
  const auto blocks = static_cast<Eigen::Index>(of.losses.blocks.size());
  MeasuredPredictions predicted;
  predicted.force = of.force.trials.front().force.replicate(1, 3);
  predicted.force.col(0).array() += 0.5;  // the stated sd
  predicted.clamped = predicted.force.rowwise().reverse();
  predicted.loss.resize(blocks, 3);
  for (Eigen::Index b = 0; b < blocks; ++b) {
    const NerveBlock& block = of.losses.blocks[static_cast<std::size_t>(b)];
    predicted.loss.row(b) << block.loss + block.sd, block.loss, kNaN;
  }
  const auto asked = [&](const AddedData& added) -> Eigen::VectorXd {
    return log_likelihood(predicted, of.force, of.losses, added);
  };
  EXPECT_TRUE(matrix_near(asked({"", true, false}), Vector3d(-1.5, 0, 0), 1e-12));
  EXPECT_TRUE(matrix_near(asked({"", true, false, 0.5}), Vector3d(-6, 0, 0), 1e-12));
  EXPECT_TRUE(matrix_near(asked({"", true, false, 1, true}), Vector3d(0, 0, -1.5), 1e-12));
  const Eigen::VectorXd losses = asked({"", false, true});
  EXPECT_NEAR(losses[0], -static_cast<double>(blocks) / 2, 1e-12);
  EXPECT_NEAR(losses[1], 0, 1e-12);
  EXPECT_EQ(losses[2], -kInfinity);
}

// Where no draw can press, or one alone fits, the result says so.
TEST(MeasuredLessons, WeightsThatTellNothingAreTold) {
  const Eigen::MatrixXd tilts = Eigen::RowVectorXd::LinSpaced(40, -1, 1);
  const AddedData added{"both", true, true};
  EXPECT_EQ(update_tilts(added, tilts, Eigen::VectorXd::Constant(40, -kInfinity), 0).message,
            "none of 40 draws can have weight");
  Eigen::VectorXd one = Eigen::VectorXd::Constant(40, -kInfinity);
  one[7] = 0;
  EXPECT_EQ(update_tilts(added, tilts, one, 4).message, "one draw takes all the weight");
  EXPECT_EQ(update_tilts(added, tilts, Eigen::VectorXd::Zero(40), 0).message, "");
}

/// Chains of the prior and FPL's force alone, its noise as stated.
const PosteriorRun& chains_of_fpl() {
  static const PosteriorRun run = [] {
    const ThumbStudyInputs inputs = sample::study_inputs();
    PosteriorSettings settings;
    settings.posterior = posterior_options(inputs.skewed);
    settings.posterior.learn_noise = false;
    settings.run.draws = settings.run.sampler.warm_up = 1000;
    settings.mode_starts = 4;
    return sample_posterior({inputs.start, inputs.skewed, {measured_thumb_inputs(kData).force}, {}},
                            settings);
  }();
  return run;
}

const MeasuredLessons& lessons_beside_chains() {
  static const MeasuredLessons made = [] {
    MeasuredLessonsSettings settings;
    settings.prior_draws = 3000;
    settings.posterior_draws = 500;
    return reweight_by_measurements(measured_thumb_inputs(kData), chains_of_fpl(),
                                    sample::true_thumb(sample::study_inputs()), settings);
  }();
  return made;
}

// Draws of the prior weighed by FPL's force have the spread of chains of the same posterior, of
// which every eighth draw is looked at: of 500 draws an sd is known to 1 / sqrt(1000).
TEST(MeasuredLessons, WeightsAgreeWithChains) {
  const MeasuredLessons& lessons = lessons_beside_chains();
  ASSERT_TRUE(lessons.complete);
  const DataUpdate& force = lessons.reweighted.front().updates.front();
  ASSERT_TRUE(force.added.force && !force.added.losses);
  EXPECT_TRUE(force.weights.reliable());
  const Eigen::MatrixXd& before = lessons.reweighted.front().tilts;
  const Eigen::MatrixXd& after = lessons.reweighted.back().tilts;
  ASSERT_EQ(before.rows(), 10);
  for (Eigen::Index i = 0; i < before.rows(); ++i) {
    const auto sd = [&](const Eigen::MatrixXd& x) {
      return std::sqrt((x.row(i).array() - x.row(i).mean()).square().mean());
    };
    const double chains = sd(after) / sd(before);
    const double error = std::hypot(force.tilts.sd_ratio_error[i], chains / std::sqrt(2.0 * 500));
    EXPECT_NEAR(force.tilts.sd_ratio[i], chains, 4 * error) << lessons.reweighted.front().names[i];
  }
}

// What has been learnt once is not learnt again.
TEST(MeasuredLessons, PosteriorIsMovedLessByWhatItKnows) {
  const MeasuredLessons& lessons = lessons_beside_chains();
  const DataUpdate &fresh = lessons.reweighted.front().updates.front(),
                   &again = lessons.reweighted.back().updates.front();
  EXPECT_GT(again.tilts.sd_ratio.minCoeff(), fresh.tilts.sd_ratio.minCoeff());
  EXPECT_GT(again.weights.effective_size / 500, fresh.weights.effective_size / 3000);
}

}  // namespace
}  // namespace thenar
