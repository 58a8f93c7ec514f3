// Tests for data/io/fit_settings.cpp.

#include "data/io/fit_settings.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

const std::string kGoodSettings = R"(name = "example"
source = "Synek2019"
robust_scale = 2
[[parameter]]
match = "path/*"
state = "free"
sd_mm = 0.5
between_sd_mm = 1
range_mm = 4
[[parameter]]
match = "axis/*/direction/*"
optional = "yes"
state = "free"
sd_deg = 90
[[parameter]]
match = "friction/FDS"
state = "tied"
tie_to = "friction/FDP"
tie_ratio = 0.5
[[parameter]]
match = "gain/*"
state = "fixed"
mean = 1.1
lower = 0
upper = 2
[[axis_distance]]
joints = ["CMC1_FE", "CMC1_AA"]
range_mm = [5, 12]
)";

std::string settings_refusal(const std::string& from, const std::string& to) {
  std::string text = kGoodSettings;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  try {
    (void)parse_fit_settings(text.replace(at, from.size(), to), "fit.toml");
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

TEST(FitSettingsFile, ReadsEverythingInSi) {
  const FitSettings settings = parse_fit_settings(kGoodSettings, "fit.toml");
  EXPECT_EQ(settings.path, "fit.toml");
  EXPECT_EQ(settings.robust_scale, 2);
  ASSERT_EQ(settings.rules.size(), 4U);
  const ParameterRule& path = settings.rules[0];
  EXPECT_EQ(path.match, "path/*");
  EXPECT_EQ(path.line, 4);
  EXPECT_EQ(path.state, ParameterState::kFree);
  EXPECT_EQ(path.dimension, Dimension::kLength);
  EXPECT_DOUBLE_EQ(*path.sd, 0.5e-3);
  EXPECT_DOUBLE_EQ(*path.between_sd, 1e-3);
  EXPECT_DOUBLE_EQ(*path.range, 4e-3);
  EXPECT_FALSE(path.mean || path.lower || path.upper || path.optional);
  const ParameterRule& axis = settings.rules[1];
  EXPECT_TRUE(axis.optional);
  EXPECT_DOUBLE_EQ(*axis.sd, kPi / 2);
  const ParameterRule& tied = settings.rules[2];
  EXPECT_EQ(tied.state, ParameterState::kTied);
  EXPECT_EQ(tied.tie_to, "friction/FDP");
  EXPECT_EQ(tied.tie_ratio, 0.5);
  const ParameterRule& gain = settings.rules[3];
  EXPECT_EQ(gain.state, ParameterState::kFixed);
  EXPECT_EQ(*gain.mean, 1.1);
  EXPECT_EQ(*gain.lower, 0);
  EXPECT_EQ(*gain.upper, 2);
  ASSERT_EQ(settings.axis_distances.size(), 1U);
  EXPECT_EQ(settings.axis_distances[0].joint_b, "CMC1_AA");
  EXPECT_DOUBLE_EQ(settings.axis_distances[0].lower, 5e-3);
  EXPECT_DOUBLE_EQ(settings.axis_distances[0].upper, 12e-3);
}

TEST(FitSettingsFile, NamesMixedUnits) {
  EXPECT_EQ(settings_refusal("range_mm = 4", "range_deg = 4"),
            "fit.toml:4: 'range' is an angle, but an earlier key of the row is a length");
}

TEST(FitSettingsFile, NamesTheUnknownState) {
  const std::string message = settings_refusal("state = \"free\"", "state = \"loose\"");
  EXPECT_NE(message.find("fit.toml:6: "), std::string::npos) << message;
  EXPECT_NE(message.find("loose"), std::string::npos) << message;
}

TEST(FitSettingsFile, NamesWrongAxisDistances) {
  EXPECT_EQ(settings_refusal("[\"CMC1_FE\", \"CMC1_AA\"]", "[\"CMC1_FE\"]"),
            "fit.toml:26: wanted 2 'joints', got 1");
  EXPECT_EQ(settings_refusal("[5, 12]", "[12, 5]"),
            "fit.toml:26: 'range' must go from the lower bound to the upper");
}

TEST(FitSettingsFile, RefusesNegativeAndInfiniteSds) {
  EXPECT_NE(settings_refusal("sd_mm = 0.5", "sd_mm = -0.5").find("fit.toml:7: "),
            std::string::npos);
  EXPECT_NE(settings_refusal("sd_mm = 0.5", "sd_mm = inf").find("fit.toml:7: "), std::string::npos);
}

TEST(FitSettingsFile, RefusesWhatItDoesNotKnow) {
  EXPECT_NE(settings_refusal("robust_scale = 2", "robust = 2"), "");
  EXPECT_NE(settings_refusal("tie_ratio = 0.5", "tie_factor = 0.5"), "");
}

TEST(FitSettingsFile, ReadsBeliefsOfAPosterior) {
  const PosteriorPriors usual = parse_fit_settings(kGoodSettings, "fit.toml").posterior;
  EXPECT_TRUE(usual.sphere_priors);
  EXPECT_GT(usual.noise_sd, 0);
  const std::string own = "[posterior]\nnoise_sd = 0\nspread_sd = 0.3\ndirections = 'normal'\n";
  const PosteriorPriors beliefs = parse_fit_settings(kGoodSettings + own, "fit.toml").posterior;
  EXPECT_EQ(beliefs.noise_sd, 0);
  EXPECT_EQ(beliefs.specimen_scale_sd, 0.3);
  EXPECT_FALSE(beliefs.sphere_priors);
}

TEST(FitSettingsErrors, OfThePosteriorHavePathAndLine) {
  const auto with = [](const std::string& row) {
    return settings_refusal("[[axis_distance]]", "[posterior]\n" + row + "\n[[axis_distance]]");
  };
  EXPECT_EQ(with("noise_sd = -1"), "fit.toml:27: wanted 'noise_sd' >= 0, got -1");
  EXPECT_EQ(with("directions = 'flat'"),
            "fit.toml:27: wanted 'directions' to be one of sphere, normal, got 'flat'");
  EXPECT_EQ(with("noise = 1"), "fit.toml:27: unknown key 'noise', did you mean 'noise_sd'?");
}

const std::string kChoices = R"(
[[choose]]
name = "tilts"
match = ["axis/*", "sensor/*"]
sd_deg = [4, 0, 8]
chosen = 3  # of an earlier day
[[choose]]
name = "what the model misses"
misfit = [0.01, 0.03]
)";

TEST(FitSettingsFile, ReadsChoices) {
  const FitSettings settings = parse_fit_settings(kGoodSettings + kChoices, "fit.toml");
  ASSERT_EQ(settings.choices.size(), 2U);
  const SettingChoice& tilts = settings.choices[0];
  EXPECT_EQ(tilts.match, (std::vector<std::string>{"axis/*", "sensor/*"}));
  EXPECT_EQ(tilts.key, ChoiceKey::kSd);
  EXPECT_DOUBLE_EQ(tilts.value(), 8 * kDegree);
  EXPECT_EQ(settings.misfit, 0.01);  // the first is in force
}

TEST(FitSettingsFile, KeepsWhatWasChosenAndNothingElse) {
  const std::string text = kGoodSettings + kChoices;
  FitSettings settings = parse_fit_settings(text, "fit.toml");
  set_choice(settings, 0, 1);
  set_choice(settings, 1, 1);
  EXPECT_EQ(settings.misfit, 0.03);
  const std::string kept = with_choices(text, settings);
  EXPECT_EQ(kept, kGoodSettings + R"(
[[choose]]
chosen = 2
name = "tilts"
match = ["axis/*", "sensor/*"]
sd_deg = [4, 0, 8]
[[choose]]
chosen = 2
name = "what the model misses"
misfit = [0.01, 0.03]
)");
  EXPECT_EQ(with_choices(kept, parse_fit_settings(kept, "fit.toml")), kept);
  EXPECT_EQ(parse_fit_settings(kept, "fit.toml").misfit, 0.03);
}

TEST(FitSettingsErrors, OfChoicesSayWhatWasWanted) {
  const auto with = [](const std::string& rows) {
    return settings_refusal("[[axis_distance]]",
                            "[[choose]]\nname = \"x\"\n" + rows + "\n[[axis_distance]]");
  };
  EXPECT_EQ(with("misfit = [1, 2]\nchosen = 3"),
            "fit.toml:29: wanted a place in the list, 1 to 2, got 3");
  EXPECT_EQ(with("misfit = [1, 2]\nchosen = 1.5"),
            "fit.toml:29: wanted a place in the list, 1 to 2, got 1.5");
  EXPECT_EQ(with("misfit = [1]\nrobust_scale = [1]"),
            "fit.toml:26: wanted one list of values, got a second one");
  EXPECT_NE(with("match = [\"axis/*\"]").find("fit.toml:26: wanted a list of values"),
            std::string::npos);
  EXPECT_NE(with("misfit = [-1]").find("fit.toml:28: "), std::string::npos);
}

TEST(FitSettingsFile, KeepsFactorsOfPriorScalesAndNothingElse) {
  const std::string text = kGoodSettings + R"(
[[prior_scale]]
name = "load cell"
match = ["sensor/*"]
[[prior_scale]]
name = "axes"
match = ["axis/*"]
likeliest = 2.5
spread = 0.5
largest = 5
factor = 0.4
)";
  const FitSettings settings = parse_fit_settings(text, "fit.toml");
  ASSERT_EQ(settings.scales.size(), 2U);
  EXPECT_EQ(settings.scales[0].name, "load cell");
  EXPECT_EQ(settings.scales[0].likeliest, 1);
  EXPECT_TRUE(std::isinf(settings.scales[0].spread));
  EXPECT_EQ(settings.scales[0].largest, 1);
  EXPECT_EQ(settings.scales[0].factor, 1);
  EXPECT_EQ(settings.scales[1].match, std::vector<std::string>{"axis/*"});
  EXPECT_EQ(settings.scales[1].likeliest, 2.5);
  EXPECT_EQ(settings.scales[1].spread, 0.5);
  EXPECT_EQ(settings.scales[1].largest, 5);
  EXPECT_EQ(settings.scales[1].factor, 0.4);

  const std::string kept = with_scale_factors(text, settings, {0.0125, 2});
  EXPECT_EQ(kept, kGoodSettings + R"(
[[prior_scale]]
factor = 0.0125
name = "load cell"
match = ["sensor/*"]
[[prior_scale]]
factor = 2
name = "axes"
match = ["axis/*"]
likeliest = 2.5
spread = 0.5
largest = 5
)");
  EXPECT_EQ(with_scale_factors(kept, parse_fit_settings(kept, "fit.toml"), {0.0125, 2}), kept);
}

}  // namespace
}  // namespace thenar
