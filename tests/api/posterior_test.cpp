// Tests for api/posterior.cpp.

#include "api/posterior.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "tests/api/small_fit.h"

namespace thenar {
namespace {

class PosteriorQuestion : public sample::SmallFit {
 protected:
  [[nodiscard]] SampleRequest request(long draws) const {
    SampleRequest request;
    request.sources = sources();
    request.warm_up = 60;
    request.draws = draws;
    request.mode_starts = 2;
    request.threads = 1;
    request.output = path("P.nc");
    request.run = {{"fit", "H01"}, "/work", "", "2001-09-09T01:46:40Z"};
    return request;
  }
};

// Few draws do not converge: their state stays, and the same chains go on.
TEST_F(PosteriorQuestion, GoesOnWithTheSameDraws) {
  const std::optional<PosteriorResult> few = sample_fit(request(20));
  ASSERT_TRUE(few && few->summary);
  EXPECT_FALSE(few->run.convergence.warnings.empty());
  EXPECT_TRUE(std::filesystem::exists(path("P.nc.chains")));
  const std::optional<PosteriorResult> more = sample_fit(request(40));
  ASSERT_EQ(more->run.draws.draws(), 40);
  EXPECT_EQ(more->run.draws.x[1].leftCols(20), few->run.draws.x[1]);

  const PosteriorResult back = open_posterior(path("P.nc"));
  EXPECT_EQ(pooled(back.run.draws), pooled(more->run.draws));
  EXPECT_EQ(command_line(back.run.run), "thenar fit H01");
  EXPECT_EQ(back.summary->quantities.size(), more->summary->quantities.size());
}

TEST_F(PosteriorQuestion, ForgetsWhatNobodyWantsToGoOnWith) {
  SampleRequest asked = request(20);
  asked.keep_unconverged = false;
  (void)sample_fit(asked);
  EXPECT_FALSE(std::filesystem::exists(path("P.nc.chains")));
}

TEST_F(PosteriorQuestion, PredictsByTheMeansOfDraws) {
  (void)sample_fit(request(20));
  PosteriorPredictRequest asked;
  asked.posterior = path("P.nc");
  asked.experiments = {"synek2019_H01", "synek2019_H02"};
  asked.data = THENAR_DATA_DIR;
  const PosteriorPrediction answer = predict_by_draws(asked);
  EXPECT_EQ(answer.predicted.experiments[0].by, PredictedBy::kOwn);
  EXPECT_EQ(answer.predicted.experiments[1].by, PredictedBy::kStranger);
  // Beside a stranger's stand the forces that the fitted specimen showed; its own loads were
  // single.
  const PredictedTrial& stranger = answer.predicted.experiments[1].prediction.trials.front();
  ASSERT_TRUE(stranger.trivial);
  EXPECT_EQ(*stranger.trivial, answer.predicted.experiments[0].prediction.trials.front().measured);
  EXPECT_FALSE(answer.predicted.experiments[0].prediction.trials.front().trivial);
  EXPECT_EQ(answer.posterior.run.draws.draws(), 20);
  EXPECT_GT(answer.predicted.experiments[0].prediction.trials[0].sd.minCoeff(), 0);
  // Fewer draws than are asked for are told.
  const auto told = [](const PosteriorPrediction& of) {
    return std::any_of(of.predicted.outcome.warnings.begin(), of.predicted.outcome.warnings.end(),
                       [](const std::string& warning) {
                         return warning.find("fewer than the 2000 that were asked for") !=
                                std::string::npos;
                       });
  };
  EXPECT_TRUE(told(answer));
  asked.draws = 10;
  EXPECT_FALSE(told(predict_by_draws(asked)));
}

TEST_F(PosteriorQuestion, StoppedInItsSearchItHasNothing) {
  Progress progress;
  progress.stop_requested = [] { return true; };
  const std::optional<PosteriorResult> result = sample_fit(request(20), progress);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->run.draws.draws(), 0);
  EXPECT_FALSE(result->summary);
  EXPECT_FALSE(std::filesystem::exists(path("P.nc")));
}

}  // namespace
}  // namespace thenar
