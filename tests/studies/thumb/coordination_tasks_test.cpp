// Tests for studies/thumb/coordination_tasks.cpp.

#include "studies/thumb/coordination_tasks.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/studies/thumb/study_inputs.h"

namespace thenar {
namespace {

TaskOptions exact() {
  TaskOptions options;
  options.noise = options.activation_sd = 0;
  options.floor = 1e-9;
  return options;
}

// DrivenCoordinate by its own activations without errors, the true thumb makes the forces that were
// read.
TEST(CoordinationTasks, TrueThumbExplainsItsOwnTasks) {
  const TendonDigit truth = sample::true_thumb(sample::study_inputs());
  const Experiment tasks = simulate_tasks(truth, exact());
  ASSERT_EQ(tasks.activations.size(), 80U);
  for (const TaskMisfit& misfit : task_misfits(truth, tasks)) {
    EXPECT_LT(misfit.direction, 1e-8);
    EXPECT_LT(misfit.distance, 100);  // ten sds of 1e-9 N
  }
}

// Palmar pinch can be balanced by this thumb, so that people make what was asked for.
TEST(CoordinationTasks, PalmarForceIsAsWanted) {
  const TendonDigit truth = sample::true_thumb(sample::study_inputs());
  const Experiment tasks = simulate_tasks(truth, exact());
  const Eigen::Vector3d made = tasks.activations.front().force;  // key pinch, palmar, 20 N
  EXPECT_NEAR(made.norm(), 20, 2);
  EXPECT_GT(-made.y() / made.norm(), std::cos(radians(10)));
}

// People differ in how they share the load, not in what they are asked for.
TEST(CoordinationTasks, PeopleShareTheLoadDifferently) {
  const TendonDigit truth = sample::true_thumb(sample::study_inputs());
  const Experiment tasks = simulate_tasks(truth, exact());
  const auto& first = tasks.activations[0].activation;
  const auto& second = tasks.activations[10].activation;  // the next person's first task
  EXPECT_EQ(tasks.activations[10].posture, tasks.activations[0].posture);
  double apart = 0;
  for (const auto& [muscle, activation] : first)
    apart = std::max(apart, std::abs(activation - second.at(muscle)));
  EXPECT_GT(apart, 0.01);
}

// r' S^-1 r of the truth is chi squared with three degrees of freedom: 95 % of tasks are explained.
// Readings kept within 0 to 1 shorten errors of silent muscles, which can only help.
TEST(CoordinationTasks, NoiseAloneIsExplainedAtTheStatedRate) {
  const TendonDigit truth = sample::true_thumb(sample::study_inputs());
  TaskOptions options;
  options.people = 100;
  const double explained =
      task_scores(task_misfits(truth, simulate_tasks(truth, options))).explained;
  EXPECT_NEAR(explained, 0.95, 0.03);
}

TEST(CoordinationTasks, ScoresAreMeansAndSds) {
  const TaskScores scores = task_scores({{0.1, 1, 7}, {0.3, 3, 8}});
  EXPECT_DOUBLE_EQ(scores.direction, 0.2);
  EXPECT_NEAR(scores.direction_sd, std::sqrt(0.02), 1e-15);
  EXPECT_DOUBLE_EQ(scores.torque, 2);
  EXPECT_DOUBLE_EQ(scores.explained, 0.5);
}

}  // namespace
}  // namespace thenar
