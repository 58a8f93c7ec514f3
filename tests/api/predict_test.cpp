// Tests for api/predict.cpp.

#include "api/predict.h"

#include "api/fit.h"
#include "base/error.h"
#include "tests/api/small_fit.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using PredictQuestion = sample::SmallFit;

TEST(PredictedBy, IsTheSpecimensOwnUnlessThePopulationIsAskedFor) {
  EXPECT_EQ(predicted_by(kUnfittedSpecimen, false), PredictedBy::kStranger);
  EXPECT_EQ(predicted_by(kUnfittedSpecimen, true), PredictedBy::kStranger);
  EXPECT_EQ(predicted_by(0, false), PredictedBy::kOwn);
  EXPECT_EQ(predicted_by(0, true), PredictedBy::kOwnPopulation);
}

TEST_F(PredictQuestion, PredictsAsTheFitDoesAndAStrangerLessSurely) {
  FitRequest fit;
  fit.sources = sources();
  fit.output = path("fit.h5");
  const FitResult fitted = fit_digit(fit);
  PredictRequest request;
  request.fit = fit.output;
  request.data = THENAR_DATA_DIR;
  request.experiments = {"synek2019_H01", "synek2019_B01"};
  const PredictResult own = predict_forces(request);
  EXPECT_EQ(own.experiments[0].by, PredictedBy::kOwn);
  EXPECT_EQ(own.experiments[1].by, PredictedBy::kStranger);
  // The fit shows its most probable forces, a prediction their mean, which the curvature of forces
  // moves by a small part of what is uncertain.
  const std::vector<PredictedTrial>& predicted = own.experiments[0].prediction.trials;
  ASSERT_EQ(predicted.size(), fitted.in_sample[0].trials.size());
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    const Eigen::Vector3d moved = predicted[i].predicted - fitted.in_sample[0].trials[i].predicted;
    EXPECT_LT((moved.array() / predicted[i].sd.array()).abs().maxCoeff(), 0.1);
  }

  request.population = true;
  const PredictResult stranger = predict_forces(request);
  EXPECT_EQ(stranger.experiments[0].by, PredictedBy::kOwnPopulation);
  EXPECT_GT(stranger.experiments[0].prediction.trials[0].sd.norm(),
            own.experiments[0].prediction.trials[0].sd.norm());
}

TEST_F(PredictQuestion, RefusesWrappedPathsWithTheReason) {
  PredictRequest request;
  request.fit = "fit.h5";
  request.experiments = {"synek2019_H01"};
  request.path = Path::kWrapped;
  EXPECT_NE(message_of([&] { (void)predict_forces(request); }).find("kernel does not wrap"),
            std::string::npos);
}

TEST_F(PredictQuestion, RefusesAnythingButAFit) {
  PredictRequest request;
  request.fit = THENAR_DATA_DIR "/subjects/synek2019_middle.toml";
  request.experiments = {"synek2019_H01"};
  EXPECT_NE(message_of([&] { (void)predict_forces(request); }).find("is a subject, wanted a fit"),
            std::string::npos);
}

}  // namespace
}  // namespace thenar
