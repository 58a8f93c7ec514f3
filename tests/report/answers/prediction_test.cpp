// Tests for report/answers/prediction.cpp.

#include "report/answers/prediction.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// One trial: 3 N proximal measured, 3 N proximal and 4 N dorsal predicted.
PredictResult one_trial() {
  PredictedExperiment one;
  one.experiment.name = one.prediction.experiment = "E1";
  one.experiment.specimen = "S1";
  one.experiment.force_segment = "DP3";
  one.prediction.trials = {{"Hook", "FDP", {3, 0, 0}, {3, 4, 0}, {1, 2, 3}}};
  one.prediction.error = force_error(one.prediction.trials);
  PredictResult result;
  result.experiments = {one};
  return result;
}

// An error of 4 N on a force of 3 N, at an angle of atan(4/3) = 53.13 degrees.
TEST(PredictionAnswer, HasErrorsOfATriangle) {
  const OrderedJson json = json_of(one_trial());
  EXPECT_DOUBLE_EQ(json["rms_error_N"], 4);
  EXPECT_DOUBLE_EQ(json["relative_error"], 4.0 / 3);
  EXPECT_NEAR(json["direction_error_deg"], 53.13010235, 1e-8);
  EXPECT_EQ(json["vectors"][0]["predicted_N"], OrderedJson({3.0, 4.0, 0.0}));
  const Table table = table_of(one_trial());
  EXPECT_EQ(csv(table),
            "experiment,specimen,posture,loads,components,measured_1_N,measured_2_N,measured_3_N,"
            "predicted_1_N,predicted_2_N,predicted_3_N,sd_1_N,sd_2_N,sd_3_N,error_N,"
            "direction_error_deg\n"
            "E1,S1,Hook,FDP,proximal dorsal radial,3.000000,0.000000,0.000000,3.000000,4.000000,"
            "0.000000,1.000000,2.000000,3.000000,4.000000,53.130\n");
}

TEST(PredictionAnswer, NamesComponentsByTheWordsOfTheExperiment) {
  Experiment experiment;
  experiment.axes_of_digit << 0, 1, 0, 0, 0, -1, 1, 0, 0;
  EXPECT_EQ(component_names(experiment), "dorsal ulnar proximal");
}

TEST(PredictionAnswer, IsRefusedWhereItsFitHasNotConverged) {
  PredictResult result = one_trial();
  EXPECT_EQ(refusal_of(result), "");
  result.request.fit = "f.h5";
  result.outcome.status = Status::kStalled;
  EXPECT_EQ(refusal_of(result), "the fit in 'f.h5' has NOT converged; do not use these forces");
}

TEST(PredictionAnswer, IsAListOfSeveralExperiments) {
  PredictResult two = one_trial();
  two.experiments.push_back(two.experiments[0]);
  EXPECT_EQ(json_of(two).size(), 2U);
  EXPECT_TRUE(json_of(two).is_array());
}

}  // namespace
}  // namespace thenar
