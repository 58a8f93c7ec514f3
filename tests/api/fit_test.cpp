// Tests for api/fit.cpp.

#include "api/fit.h"

#include <algorithm>

#include "api/named/files.h"
#include "api/predict.h"
#include "base/error.h"
#include "data/io/toml_node.h"
#include "tests/api/small_fit.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using FitQuestion = sample::SmallFit;

TEST_F(FitQuestion, TakesSubjectsAndExperimentsByName) {
  const FitInputs inputs = read_fit_inputs(sources());
  EXPECT_EQ(inputs.subject.path, THENAR_DATA_DIR "/subjects/synek2019_middle.toml");
  EXPECT_EQ(inputs.experiments[0].path, THENAR_DATA_DIR "/experiments/synek2019_H01.toml");
  FitSources other = sources();
  other.settings.clear();
  EXPECT_EQ(read_fit_inputs(other).settings.path, "built-in finger.toml");
  other.experiments = {"synek2019_H1"};
  EXPECT_THROW((void)read_fit_inputs(other), InputError);
}

// Their force kernel does not wrap.
TEST_F(FitQuestion, RefusesPathsThatAFitCannotHave) {
  FitSources wrapped = sources();
  wrapped.path = Path::kWrapped;
  EXPECT_EQ(message_of([&] { (void)read_fit_inputs(wrapped); }),
            "the force model of a fit runs tendons straight between via points, as its kernel does "
            "not wrap: wanted paths 'via', got 'wrapped'");
  EXPECT_NO_THROW(require_fit_path(Path::kViaPoint));
  EXPECT_NO_THROW(require_fit_path({}));
  EXPECT_THROW(require_fit_path(Path::kFitted), InputError);
}

// A fit of a subject with surfaces stays on straight paths, and says so.
TEST_F(FitQuestion, TellsWhereOtherQuestionsWrap) {
  FitInputs inputs;
  inputs.subject = read_source(THENAR_DATA_DIR "/subjects/synek2019_middle.toml");
  EXPECT_TRUE(path_cautions(inputs).empty());
  inputs.subject = read_source(THENAR_DATA_DIR "/subjects/mirakhorlo2016.toml");
  ASSERT_EQ(path_cautions(inputs).size(), 1U);
  EXPECT_NE(path_cautions(inputs).front().find("straight between via points"), std::string::npos);
}

// A fit cannot be worse on what it has seen than where it started, priors included.
TEST_F(FitQuestion, WritesItsFileWithTheRunAndPredictsWhatItHasSeen) {
  FitRequest request;
  request.sources = sources();
  request.output = path("fit.h5");
  request.leave_out = {LeaveOut::kTendon};
  request.run = {{"fit", "synek2019_H01"}, "/work", "", "2001-09-09T01:46:40Z"};
  const FitResult result = fit_digit(request);
  ASSERT_EQ(result.in_sample.size(), 1U);
  ASSERT_EQ(result.left_out.size(), 1U);
  EXPECT_FALSE(result.outcome.stopped());
  EXPECT_LT(result.in_sample[0].error.rms, result.left_out[0].experiments[0].error.rms);
  EXPECT_GT(result.in_sample[0].trials[0].sd.minCoeff(), 0);
  const Fit back = read_fit(request.output);
  EXPECT_EQ(command_line(back.run), "thenar fit synek2019_H01");
  EXPECT_EQ(back.solution.z, result.fit.solution.z);
}

// Beside what was left out stands every subject that has the digit, its muscles and joints.
TEST_F(FitQuestion, ComparesWithPublishedSubjects) {
  FitRequest request;
  request.sources = sources();
  EXPECT_TRUE(fit_digit(request).published.empty());
  request.leave_out = {LeaveOut::kPosture};
  const FitResult result = fit_digit(request);
  ASSERT_EQ(result.published.size(), 2U);  // of all subjects in data/, two have a middle finger
  EXPECT_EQ(result.published[0].name, "synek2019_middle");
  EXPECT_TRUE(result.published[0].prediction.calibrated_on_specimen);
  EXPECT_EQ(result.published[1].name, "an_chao_middle");
  EXPECT_FALSE(result.published[1].prediction.calibrated_on_specimen);
  const Prediction alone =
      predict_as_published(read_source(THENAR_DATA_DIR "/subjects/an_chao_middle.toml"),
                           result.fit.problem.experiments()[0]);
  EXPECT_EQ(result.published[1].prediction.error.rms, alone.error.rms);
}

// Two shares and the tilt of the cell cannot turn forces round: reversed ones are missed by far.
TEST_F(FitQuestion, WarnsOfForcesThatItMisses) {
  FitRequest request;
  request.sources = sources();
  const auto misses = [&] {
    const FitResult result = fit_digit(request);
    const auto told = [&](const std::string& words) {
      return std::any_of(
          result.outcome.warnings.begin(), result.outcome.warnings.end(),
          [&](const auto& warning) { return warning.find(words) != std::string::npos; });
    };
    EXPECT_EQ(told("times the stated noise"), result.misfits.at(0).beyond_chance);
    EXPECT_EQ(told("moved by more than 3 prior sds"),
              result.fit.solution.z.cwiseAbs().maxCoeff() > 3);
    return result.misfits.at(0).beyond_chance;
  };
  EXPECT_FALSE(misses());
  std::string text = read_text_file(request.sources.experiments.front());
  const std::string wanted = "components = [";
  const std::size_t at = text.find(wanted);
  ASSERT_NE(at, std::string::npos);
  const std::size_t end = text.find(']', at);
  std::string turned = text.substr(at, end - at);
  for (const auto& [word, other] : {std::pair("proximal", "distal"), std::pair("dorsal", "palmar")})
    if (const std::size_t found = turned.find(word); found != std::string::npos)
      turned.replace(found, std::string(word).size(), other);
  text.replace(at, end - at, turned);
  std::ofstream(path("turned.toml")) << text;
  request.sources.experiments = {path("turned.toml")};
  EXPECT_TRUE(misses());
}

// Electromyography alone: it is fitted, has no force to be left out or predicted, and says so.
TEST_F(FitQuestion, FitsRowsOfActivationsAlone) {
  FitRequest request;
  request.sources = sources();
  request.sources.subject = THENAR_DATA_DIR "/subjects/an_chao_middle.toml";
  std::string text = read_text_file(request.sources.experiments.front());
  text = text.substr(0, text.find("[trials]")) +
         "[[activation]]\nposture = 'MinorFlex'\nactivation = {FDS = 0.2}\n"
         "activation_sd = 0.1\nforce_N = [-1, -1, 0]\n";
  std::ofstream(path("rows.toml")) << text;
  request.sources.experiments = {path("rows.toml")};
  request.output = path("fit.h5");
  const FitResult result = fit_digit(request);
  EXPECT_EQ(result.fit.solution.status, Status::kSolved);
  EXPECT_EQ(result.in_sample.at(0).error.trials, 0);
  EXPECT_EQ(result.misfits.at(0).numbers, 3);
  PredictRequest predict;
  predict.fit = request.output;
  predict.experiments = request.sources.experiments;
  EXPECT_EQ(message_of([&] { (void)predict_forces(predict); }),
            path("rows.toml") +
                ": wanted trials, whose forces could be predicted, got rows of activations alone");
  request.leave_out = {LeaveOut::kPosture};
  EXPECT_EQ(message_of([&] { (void)fit_digit(request); }),
            "to leave one posture out, wanted trials, got rows of activations alone");
}

// Of a force turned round the fit says which it is.
TEST_F(FitQuestion, NamesATrialThatDoesNotGoWithTheOthers) {
  FitRequest request;
  request.sources = sources();
  const auto odd = [&] {
    std::string told;
    for (const std::string& warning : fit_digit(request).outcome.warnings)
      if (warning.find("what all other trials tell of them") != std::string::npos) told += warning;
    return told;
  };
  const std::string named = "them: FDS in posture 'MinorFlex' (";
  EXPECT_EQ(odd().find(named), std::string::npos) << odd();
  std::string text = read_text_file(request.sources.experiments.front());
  const std::size_t row = text.find("{posture = \"MinorFlex\", load_g = {FDS = 950}");
  ASSERT_NE(row, std::string::npos);
  text.erase(text.find("[-", row) + 1, 1);
  std::ofstream(path("odd.toml")) << text;
  request.sources.experiments = {path("odd.toml")};
  EXPECT_NE(odd().find(named), std::string::npos) << odd();
}

TEST_F(FitQuestion, StopsWithTheBestPointSoFar) {
  FitRequest request;
  request.sources = sources();
  request.leave_out = {LeaveOut::kPosture};
  Progress progress;
  progress.stop_requested = [] { return true; };
  const FitResult result = fit_digit(request, progress);
  EXPECT_TRUE(result.outcome.stopped());
  EXPECT_TRUE(result.left_out.empty());
}

// At z = 0 all shifts are zero: the digit is that of the subject.
TEST_F(FitQuestion, FittedDigitIsTheSubjectsWhereNothingMoved) {
  FitRequest request;
  request.sources = sources();
  FitResult result = fit_digit(request);
  result.fit.solution.z.setZero();
  const TendonDigit digit = fitted_digit(result.fit, 0);
  const TendonDigit& before = result.fit.problem.digit();
  for (std::size_t i = 0; i < before.model.tree.size(); ++i)
    EXPECT_EQ(digit.model.tree[i].point, before.model.tree[i].point);
  EXPECT_EQ(digit.model.tip, before.model.tip);
}

TEST(LeaveOutNamed, KnowsThreeNames) {
  EXPECT_EQ(leave_out_named("tendon"), LeaveOut::kTendon);
  EXPECT_EQ(message_of([] { (void)leave_out_named("hand"); }),
            "no part to leave out 'hand'; there are posture, tendon, specimen");
}

}  // namespace
}  // namespace thenar
