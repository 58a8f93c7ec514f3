// Tests for live/live_fit.cpp: the forces of the fit's own answers, drawn where they act.

#include "live/live_fit.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/posterior.h"
#include "base/error.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/posterior_file.h"
#include "tests/api/small_fit.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::HasSubstr;

/// A fit in which axes move, and draws from its posterior.
class LiveFitFile : public sample::SmallFit {
 protected:
  [[nodiscard]] FitSources moving_axes() const {
    FitSources sources = SmallFit::sources();
    std::ofstream(path("axes.toml"))
        << "source = 'Synek2019'\n"
           "[[parameter]]\nmatch = 'axis/PIP3/direction/*'\nstate = 'free'\nsd_deg = 3\n"
           "between_sd_deg = 3\n"
           "[[parameter]]\nmatch = 'axis/DIP3/point/*'\nstate = 'free'\nsd_mm = 1\n"
           "between_sd_mm = 1\n";
    sources.settings = path("axes.toml");
    return sources;
  }
  [[nodiscard]] FitResult fitted(const std::vector<std::string>& experiments) const {
    FitRequest request;
    request.sources = moving_axes();
    request.sources.experiments.clear();
    for (const std::string& name : experiments)
      request.sources.experiments.push_back(kData + "/experiments/" + name + ".toml");
    request.output = path("fit.h5");
    return fit_digit(request);
  }
  [[nodiscard]] PosteriorResult drawn() const {
    SampleRequest request;
    request.sources = moving_axes();
    request.warm_up = 60;
    request.draws = 100;
    request.mode_starts = 2;
    request.chains = 3;
    request.threads = 1;
    request.output = path("P.nc");
    return *sample_fit(request);
  }
};

TEST_F(LiveFitFile, ListsTheForcesThatTheFitTells) {
  const FitResult fit = fitted({"synek2019_H01", "synek2019_H02"});
  const LiveFit live(path("fit.h5"));
  ASSERT_EQ(live.trials().size(), fit.in_sample[0].trials.size() + fit.in_sample[1].trials.size());
  for (int i = 0; i < static_cast<int>(live.trials().size()); ++i) {
    const LiveTrial& at = live.trials()[static_cast<std::size_t>(i)];
    const PredictedTrial& told = fit.in_sample[static_cast<std::size_t>(at.experiment)]
                                     .trials[static_cast<std::size_t>(at.trial)];
    EXPECT_EQ(live.predicted(i).measured, told.measured);
    EXPECT_TRUE(matrix_near(live.predicted(i).predicted, told.predicted, 1e-12));
    EXPECT_TRUE(matrix_near(live.predicted(i).sd, told.sd, 1e-9));
  }
}

// A rotation keeps lengths; the tip's own axes give back the components of the experiment.
TEST_F(LiveFitFile, DrawsForcesAtTheTipAlongItsAxes) {
  (void)fitted({"synek2019_H01"});
  LiveFit live(path("fit.h5"));
  for (int i = 0; i < static_cast<int>(live.trials().size()); i += 7) {
    live.show_trial(i);
    const LiveInstant instant = live.instant();
    check_instant(live.shape(), instant);
    const LiveVector measured = instant.arrows[instant.arrows.size() - 2];
    EXPECT_NEAR(measured.vector.norm(), live.predicted(i).measured.norm(), 1e-12);
    EXPECT_NEAR(instant.arrows.back().vector.norm(), live.predicted(i).predicted.norm(), 1e-12);
    // By hand, of a cell that is not tilted and forces in the tip's axes.
    const TendonModel<double>& model = live.digit().model;
    const TreeState<double> state = pose_tree(model.tree, live.posture());
    const Experiment& experiment = live.source().problem.experiments().front();
    const Eigen::Matrix3d axes =
        state[static_cast<std::size_t>(model.tip_link)].X.R * model.tip_axes;
    const Eigen::Vector3d by_hand =
        axes * experiment.axes_of_digit.cast<double>().transpose() * live.predicted(i).measured;
    EXPECT_TRUE(matrix_near(live.subject_pose().R.transpose() * measured.vector, by_hand, 1e-12));
    EXPECT_TRUE(matrix_near(live.subject_pose().inverse() * measured.from,
                            moved(state, model.tip_link, model.tip), 1e-12));
  }
}

TEST_F(LiveFitFile, MovesToThePostureOfTheTrial) {
  (void)fitted({"synek2019_H01"});
  LiveFit live(path("fit.h5"));
  const Experiment& experiment = live.source().problem.experiments().front();
  const auto& joints = live.digit().names.coordinates;
  for (int i = 0; i < static_cast<int>(live.trials().size()); ++i) {
    live.show_trial(i);
    for (const PostureRecord& posture : experiment.postures) {
      if (posture.name != live.predicted(i).posture) continue;
      for (std::size_t j = 0; j < joints.size(); ++j) {
        const auto angle = posture.angles.find(joints[j]);
        EXPECT_NEAR(live.posture()[static_cast<Eigen::Index>(j)],
                    angle == posture.angles.end() ? 0 : angle->second, 1e-12);
      }
    }
  }
  EXPECT_EQ(live.changes(), live.trials().size());
}

// Another specimen has other axes, so that its picture is another one.
TEST_F(LiveFitFile, ShowsTheAxesOfTheSpecimenOfTheTrial) {
  const FitResult fit = fitted({"synek2019_H01", "synek2019_H02"});
  LiveFit live(path("fit.h5"));
  for (const int specimen : {0, 1, 0}) {
    const unsigned long before = live.shape_changes();
    const bool other =
        live.trials()[static_cast<std::size_t>(live.shown_trial())].specimen != specimen;
    const auto first = std::find_if(live.trials().begin(), live.trials().end(),
                                    [&](const LiveTrial& t) { return t.specimen == specimen; });
    live.show_trial(static_cast<int>(first - live.trials().begin()));
    EXPECT_EQ(live.shape_changes(), before + (other ? 1 : 0));
    const TendonDigit expected = fitted_digit(fit.fit, specimen);
    for (std::size_t i = 0; i < expected.model.tree.size(); ++i)
      EXPECT_TRUE(matrix_near(live.shape().joints[i].axis, expected.model.tree[i].direction, 1e-9));
  }
}

TEST_F(LiveFitFile, RefusesWhatIsNotThere) {
  (void)fitted({"synek2019_H01"});
  LiveFit live(path("fit.h5"));
  EXPECT_THAT(message_of([&] { live.show_trial(-1); }), HasSubstr("counted from 0"));
  EXPECT_THROW(live.show_trial(static_cast<int>(live.trials().size())), InputError);
  EXPECT_EQ(live.shown_trial(), 0);
  EXPECT_THROW(LiveFit(path("none.h5")), InputError);
  EXPECT_THROW(LiveFit(kData + "/subjects/human_hand.toml"), InputError);
}

TEST_F(LiveFitFile, RefusesDamagedFiles) {
  (void)fitted({"synek2019_H01"});
  std::ifstream in(path("fit.h5"), std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  for (const double part : {0.0, 0.1, 0.5, 0.9, 0.999}) {
    std::ofstream(path("half.h5"), std::ios::binary)
        << whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size())));
    EXPECT_THROW(LiveFit(path("half.h5")), Error) << part;
  }
}

// Draws.

TEST_F(LiveFitFile, DrawsTheAxesOfAPosteriorAsClouds) {
  const PosteriorResult posterior = drawn();
  const LiveFit live(path("P.nc"));
  check_instant(live.shape(), live.instant());
  EXPECT_EQ(live.source().kind, "posterior");
  // PIP3 is tilted and DIP3 shifted; no other axis moves.
  ASSERT_EQ(live.shape().clouds.size(), 2U);
  EXPECT_EQ(live.shape().clouds[0].name, "PIP3");
  EXPECT_EQ(live.shape().clouds[1].name, "DIP3");
  for (const LiveCloud& cloud : live.shape().clouds) {
    EXPECT_EQ(cloud.segments.size(), 2U * kMaxShownDraws);
    for (std::size_t k = 0; k < cloud.segments.size(); k += 2)
      EXPECT_NEAR((cloud.segments[k + 1] - cloud.segments[k]).norm(), 0.03, 1e-12);
  }
  // The mean of the directions of the cloud is about that of the axis; it lies on the bone before.
  const LiveCloud& tilted = live.shape().clouds[0];
  Eigen::Vector3d mean(0, 0, 0);
  for (std::size_t k = 0; k < tilted.segments.size(); k += 2)
    mean += (tilted.segments[k + 1] - tilted.segments[k]) / 0.03 / kMaxShownDraws;
  const auto& names = live.digit().names.hinges;
  const auto pip = std::find(names.begin(), names.end(), "PIP3") - names.begin();
  const Hinge<double>& hinge = live.digit().model.tree[static_cast<std::size_t>(pip)];
  EXPECT_GT(mean.normalized().dot(hinge.direction), std::cos(0.02));
  EXPECT_THAT(live.shape().bodies[static_cast<std::size_t>(tilted.body)].name, HasSubstr("PP3"));
}

TEST_F(LiveFitFile, PredictsByDrawsAsTheCommandDoes) {
  (void)drawn();
  const LiveFit live(path("P.nc"));
  PosteriorPredictRequest request;
  request.posterior = path("P.nc");
  request.experiments = {"synek2019_H01"};
  request.data = kData;
  const PosteriorPrediction told = predict_by_draws(request);
  const std::vector<PredictedTrial>& trials = told.predicted.experiments[0].prediction.trials;
  ASSERT_EQ(live.trials().size(), trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    EXPECT_EQ(live.predicted(static_cast<int>(i)).predicted, trials[i].predicted);
    EXPECT_EQ(live.predicted(static_cast<int>(i)).sd, trials[i].sd);
  }
}

TEST_F(LiveFitFile, IntervalsOfAxesHoldTheirDraws) {
  (void)drawn();
  const LiveFit live(path("P.nc"));
  const LiveFit* shown = &live;
  for (const LiveAxisPair& pair : shown->axis_pairs()) {
    EXPECT_LE(pair.lower.angle, pair.upper.angle) << pair.axes.name;
    EXPECT_LE(pair.lower.distance, pair.upper.distance) << pair.axes.name;
    const bool moves = pair.axes.name.find("PIP3") != std::string::npos;
    EXPECT_EQ(pair.lower.angle < pair.upper.angle, moves) << pair.axes.name;
    EXPECT_LE(pair.lower.angle, pair.estimate.angle) << pair.axes.name;
    EXPECT_LE(pair.estimate.angle, pair.upper.angle) << pair.axes.name;
  }
}

// The angle at the mean of the parameters is another one than the mean of the angles.
TEST_F(LiveFitFile, AxesOfAPosteriorAreMeansOverAllItsDraws) {
  (void)drawn();
  const LiveFit live(path("P.nc"));
  const PosteriorRun run = read_posterior(path("P.nc"));
  const HandPosterior& posterior = *run.posterior;
  const FitParameters& parameters = posterior.problem().parameters();
  const Eigen::MatrixXd values = posterior.values(pooled(run.draws)).specimens.front();
  const std::vector<int> moving = posterior.moving_parameters();
  for (const LiveAxisPair& pair : live.axis_pairs()) {
    double angles = 0, distances = 0;
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
      std::vector<double> all;
      for (const Parameter& parameter : parameters.all) all.push_back(parameter.mean);
      for (std::size_t i = 0; i < moving.size(); ++i) all[moving[i]] = values(i, k);
      const AxisOffset offset = axis_offset(
          specimen_model(posterior.problem().digit(), parameters, all).digit, pair.axes);
      angles += offset.angle / static_cast<double>(values.cols());
      distances += offset.distance / static_cast<double>(values.cols());
    }
    EXPECT_NEAR(pair.estimate.angle, angles, 1e-12) << pair.axes.name;
    EXPECT_NEAR(pair.estimate.distance, distances, 1e-14) << pair.axes.name;
  }
}

}  // namespace
}  // namespace thenar
