// Tests for studies/thumb/thumb_experiment.cpp: simulated pulls, their noise and their file.

#include "studies/thumb/thumb_experiment.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/studies/thumb/study_inputs.h"

namespace thenar {
namespace {

TendonDigit experiment_thumb() {
  static const TendonDigit thumb = sample::true_thumb(sample::study_inputs());
  return thumb;
}

SimulatedPullOptions without_noise() {
  SimulatedPullOptions options;
  options.add_noise = false;
  return options;
}

// One trial for each muscle in each posture, and sds from the true forces.
TEST(ThumbExperiment, PullsEveryMuscleInEveryPosture) {
  const TendonDigit thumb = experiment_thumb();
  const Experiment pulls = simulate_pulls(thumb, without_noise());
  ASSERT_EQ(pulls.trials.size(), 2 * thumb.names.muscles.size());
  const Eigen::Matrix3Xd force = true_forces(thumb, pulls);
  for (std::size_t i = 0; i < pulls.trials.size(); ++i) {
    const Trial& trial = pulls.trials[i];
    const Eigen::Vector3d f = force.col(static_cast<Eigen::Index>(i));
    EXPECT_EQ(trial.force, f);
    EXPECT_NEAR((*trial.sd)[0], std::sqrt(0.01 * 0.01 + 0.01 * f.squaredNorm()), 1e-14);
  }
}

// Tendons are linear: twice the tension is twice the force.
TEST(ThumbExperiment, ForcesGrowWithTension) {
  SimulatedPullOptions options = without_noise();
  const Experiment once = simulate_pulls(experiment_thumb(), options);
  options.tension *= 2;
  const Experiment twice = simulate_pulls(experiment_thumb(), options);
  for (std::size_t i = 0; i < once.trials.size(); ++i)
    EXPECT_TRUE(matrix_near(twice.trials[i].force, 2 * once.trials[i].force, 1e-12));
}

// Noise is normal with the sd that is stated: of 3 n numbers the mean square is 1 within five of
// its own sds, sqrt(2 / 3 n). The seed decides.
TEST(ThumbExperiment, NoiseHasTheStatedSize) {
  SimulatedPullOptions options;
  options.postures = 4;
  const Eigen::Matrix3Xd truth =
      true_forces(experiment_thumb(), simulate_pulls(experiment_thumb(), options));
  double sum = 0;
  int count = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    options.seed = seed;
    const Experiment noisy = simulate_pulls(experiment_thumb(), options);
    for (std::size_t i = 0; i < noisy.trials.size(); ++i) {
      const Trial& trial = noisy.trials[i];
      const Eigen::Vector3d off = trial.force - truth.col(static_cast<Eigen::Index>(i));
      sum += off.cwiseQuotient(*trial.sd).squaredNorm();
      count += 3;
    }
  }
  EXPECT_NEAR(sum / count, 1, 5 * std::sqrt(2.0 / count));
  const Experiment again = simulate_pulls(experiment_thumb(), options);
  options.seed = 1;
  const Experiment other = simulate_pulls(experiment_thumb(), options);
  options.seed = 20;
  EXPECT_EQ(simulate_pulls(experiment_thumb(), options).trials[0].force, again.trials[0].force);
  EXPECT_NE(other.trials[0].force, again.trials[0].force);
}

// The file holds every number to its last bit.
TEST(ThumbExperiment, IsReadAsItWasWritten) {
  const Experiment pulls = simulate_pulls(experiment_thumb(), {});
  const Experiment read = parse_experiment(experiment_text(pulls), "pulls.toml");
  ASSERT_EQ(read.trials.size(), pulls.trials.size());
  for (std::size_t i = 0; i < pulls.trials.size(); ++i) {
    EXPECT_EQ(read.trials[i].force, pulls.trials[i].force);
    EXPECT_EQ(read.trials[i].sd, pulls.trials[i].sd);
    EXPECT_EQ(read.trials[i].tension, pulls.trials[i].tension);
    EXPECT_EQ(read.trials[i].posture, pulls.trials[i].posture);
  }
  ASSERT_EQ(read.postures.size(), pulls.postures.size());
  EXPECT_EQ(read.postures[1].angles, pulls.postures[1].angles);
  EXPECT_EQ(read.hold, pulls.hold);
}

TEST(ThumbExperiment, RefusesPosturesAndRowsThatAreNotThere) {
  SimulatedPullOptions options;
  options.postures = 5;
  EXPECT_EQ(message_of([&] { (void)simulate_pulls(experiment_thumb(), options); }),
            "there are 1 to 4 postures, asked for 5");
  Experiment pulls = simulate_pulls(experiment_thumb(), {});
  pulls.trials[0].sd.reset();
  EXPECT_EQ(message_of([&] { (void)experiment_text(pulls); }),
            "a trial of 'pulls' in posture '" + pulls.trials[0].posture + "' has no sd");
}

}  // namespace
}  // namespace thenar
