// Tests for report/answers/fit.cpp.

#include "report/answers/fit.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "data/io/toml_node.h"
#include "tests/api/small_fit.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using FitAnswer = sample::SmallFit;

TEST_F(FitAnswer, SaysTheSameInWordsAndNumbers) {
  FitRequest request;
  request.sources = sources();
  const FitResult result = fit_digit(request);
  const OrderedJson json = json_of(result);
  EXPECT_EQ(json["status"], "converged");
  EXPECT_EQ(json["free_coordinates"], result.fit.problem.size());
  EXPECT_EQ(json["learnt"].size(), static_cast<std::size_t>(result.fit.problem.size()));
  EXPECT_EQ(json["learnt"][0]["meaning"].get<std::string>().empty(), false);
  EXPECT_DOUBLE_EQ(json["in_sample"][0]["rms_error_N"], result.in_sample[0].error.rms);
  EXPECT_DOUBLE_EQ(json["in_sample"][0]["times_noise"], result.misfits[0].times_noise);
  EXPECT_EQ(json["in_sample"][0]["beyond_chance"], false);
  const std::string text = text_of(result);
  EXPECT_NE(text.find(fmt::format("in sample: RMS error {:.3f} N", result.in_sample[0].error.rms)),
            std::string::npos);

  // The best known first: sds rise from row to row.
  const Table table = table_of(result);
  ASSERT_EQ(table.rows.size(), json["learnt"].size());
  for (std::size_t i = 1; i < table.rows.size(); ++i)
    EXPECT_LE(std::stod(table.rows[i - 1][3]), std::stod(table.rows[i][3]));
}

// The value told is the fitted parameter of that name; its distance from the prior mean is the
// estimate times the prior's sd.
TEST_F(FitAnswer, TellsCoordinatesInTheirUnits) {
  FitRequest request;
  request.sources = sources();
  const FitResult result = fit_digit(request);
  const FittedValues values = fitted_values(result.fit, 0);
  const std::vector<Parameter>& all = result.fit.problem.parameters().all;
  int compared = 0;
  const OrderedJson json = json_of(result);
  for (const auto& row : json["learnt"]) {
    const auto named = std::find_if(all.begin(), all.end(), [&](const Parameter& parameter) {
      return parameter.name == without_specimen(row["name"].get<std::string>());
    });
    if (named == all.end() || !row.contains("value")) continue;
    const double scale = display_scale(*named);
    EXPECT_NEAR(row["value"], values.value[named - all.begin()], 1e-9) << named->name;
    EXPECT_NEAR(row["sd"], values.sd[named - all.begin()], 1e-9) << named->name;
    EXPECT_NEAR(row["value"].get<double>() - named->mean * scale,
                row["prior_sd"].get<double>() * row["estimate_prior_sds"].get<double>(), 1e-9)
        << named->name;
    ++compared;
  }
  EXPECT_GT(compared, 4);
}

// No error of forces is told where there are none but those of activation rows.
TEST_F(FitAnswer, TellsNoErrorOfRowsOfActivations) {
  FitRequest request;
  request.sources = sources();
  request.sources.subject = THENAR_DATA_DIR "/subjects/an_chao_middle.toml";
  std::string text = read_text_file(request.sources.experiments.front());
  text = text.substr(0, text.find("[trials]")) +
         "[[activation]]\nposture = 'MinorFlex'\nactivation = {FDS = 0.2}\n"
         "activation_sd = 0.1\nforce_N = [-1, -1, 0]\n";
  std::ofstream(path("rows.toml")) << text;
  request.sources.experiments = {path("rows.toml")};
  const FitResult result = fit_digit(request);
  EXPECT_NE(text_of(result).find("in sample: 1 row of activations"), std::string::npos);
  EXPECT_TRUE(OrderedJson::parse(json_of(result).dump())["in_sample"][0]["rms_error_N"].is_null());
}

TEST_F(FitAnswer, ComplainsOfAFitThatHasNotConverged) {
  FitRequest request;
  request.sources = sources();
  FitResult result = fit_digit(request);
  EXPECT_EQ(refusal_of(result), "");
  result.fit.solution.status = Status::kStalled;
  result.fit.solution.newton_step = 0.54;
  const std::string complaint = refusal_of(result);
  EXPECT_EQ(complaint.rfind("the fit has NOT converged: not stationary", 0), 0U) << complaint;
  EXPECT_NE(complaint.find("a step of 0.54 posterior sds is left"), std::string::npos) << complaint;
  // The point of a fit that was stopped is what was asked for.
  result.outcome.status = Status::kStopped;
  EXPECT_EQ(refusal_of(result), "");
}

// A clamped planar tip: one muscle alone, then both, so that forces know two differences of the
// three arms of each; the same shift of all three makes a moment alone. Tilts of axes out of the
// plane change no force in it.
TEST_F(FitAnswer, PutsArmsThatNobodyCanKnowBeforeTilts) {
  std::ofstream(path("planar.toml")) << sample::planar_finger_of_arms();
  std::string trials =
      sample::planar_trials("components = ['proximal', 'dorsal']", "[-0.6, -1.2]", "[-0.9, -1]");
  const std::string pinned = "hold = \"pinned\"";
  trials.replace(trials.find(pinned), pinned.size(), "hold = \"rigid\"");
  std::ofstream(path("trials.toml")) << trials;
  std::ofstream(path("arms.toml")) << "source = 'Synek2019'\n"
                                      "[[parameter]]\nmatch = 'axis/*/direction/*'\n"
                                      "state = 'free'\n"
                                      "[[parameter]]\nmatch = 'arm/*'\nstate = 'free'\n";
  FitRequest request;
  request.sources.subject = path("planar.toml");
  request.sources.experiments = {path("trials.toml")};
  request.sources.settings = path("arms.toml");
  const std::string text = text_of(fit_digit(request));
  const std::size_t deep = text.find("; all arms of FDP shift alike"),
                    superficial = text.find("; all arms of FDS shift alike"),
                    tilts = text.find("only tilt or shift joint axes");
  EXPECT_NE(deep, std::string::npos) << text;
  EXPECT_NE(superficial, std::string::npos) << text;
  ASSERT_NE(tilts, std::string::npos) << text;
  EXPECT_LT(std::max(deep, superficial), tilts);
}

// One of the two trials is under both muscles: where settings widen its noise, "times the stated
// noise" is of the widened one, and says so.
TEST_F(FitAnswer, SaysThatSettingsWidenTheNoise) {
  std::ofstream(path("planar.toml")) << sample::planar_finger_of_arms();
  std::ofstream(path("trials.toml"))
      << sample::planar_trials("components = ['proximal', 'dorsal']", "[-0.6, -1.2]", "[-0.9, -1]");
  for (const bool widened : {false, true}) {
    std::ofstream(path("arms.toml")) << (widened ? "superposition = 0.05\n" : "")
                                     << "source = 'Synek2019'\n[[parameter]]\nmatch = 'gain/*'\n"
                                        "state = 'free'\nsd = 0.1\n";
    FitRequest request;
    request.sources.subject = path("planar.toml");
    request.sources.experiments = {path("trials.toml")};
    request.sources.settings = path("arms.toml");
    const std::string text = text_of(fit_digit(request));
    EXPECT_NE(text.find("times the stated noise"), std::string::npos) << text;
    EXPECT_EQ(text.find("and what the model is said to miss") != std::string::npos, widened)
        << text;
  }
}

TEST(SeenWords, MarkWhatIsNotOfAStranger) {
  Prediction prediction;
  EXPECT_EQ(seen_words(prediction), "");
  prediction.calibrated_on_specimen = true;
  EXPECT_EQ(seen_words(prediction), " (the subject has seen this specimen)");
}

}  // namespace
}  // namespace thenar
