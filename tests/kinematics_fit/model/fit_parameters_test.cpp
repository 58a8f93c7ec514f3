// Tests for kinematics_fit/model/parameter.cpp and fit_parameters.cpp.

#include "kinematics_fit/model/fit_parameters.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using sample::middle_finger;

const TendonDigit& finger() {
  static const TendonDigit digit = middle_finger("").digit;
  return digit;
}

FitParameters choose(const std::string& settings, const std::vector<std::string>& also_free = {}) {
  return choose_parameters(finger(), {"Hook"}, sample::settings(settings), also_free);
}

std::string refusal(const std::string& settings, const std::vector<std::string>& also_free = {}) {
  try {
    (void)choose(settings, also_free);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

const Parameter& named(const FitParameters& parameters, const std::string& name) {
  for (const Parameter& parameter : parameters.all)
    if (parameter.name == name) return parameter;
  throw InputError("no parameter " + name);
}

std::vector<std::string> free_names(const FitParameters& parameters) {
  std::vector<std::string> names;
  for (const int p : parameters.leader) names.push_back(parameters.all[p].name);
  return names;
}

TEST(FitParameters, ParametersThatDoNotMoveKeepTheirMean) {
  const FitParameters chosen = choose("");
  const std::vector<double> all = values_with(chosen, {2, 0}, Eigen::Vector2d(7, 8));
  ASSERT_EQ(all.size(), chosen.all.size());
  EXPECT_EQ(all[0], 8);
  EXPECT_EQ(all[2], 7);
  EXPECT_EQ(all[1], chosen.all[1].mean);
  EXPECT_THROW((void)values_with(chosen, {0}, Eigen::Vector2d(7, 8)), InputError);
}

TEST(ChooseParameters, LaterRulesWin) {
  const FitParameters chosen = choose(R"(
[[parameter]]
match = "gain/*"
state = "free"
sd = 0.2
[[parameter]]
match = "gain/LU"
state = "fixed"
[[parameter]]
match = "gain/UI"
sd = 0.3
)");
  EXPECT_EQ(free_names(chosen),
            (std::vector<std::string>{"gain/EDC", "gain/FDP", "gain/FDS", "gain/RI", "gain/UI"}));
  EXPECT_DOUBLE_EQ(named(chosen, "gain/UI").sd, 0.3);
  EXPECT_DOUBLE_EQ(named(chosen, "gain/RI").sd, 0.2);
}

TEST(ChooseParameters, AlsoFreeAddsToTheFile) {
  EXPECT_EQ(free_names(choose("", {"gain/LU", "tip/d*"})),
            (std::vector<std::string>{"tip/dorsal", "gain/LU"}));
}

TEST(ChooseParameters, BoundsMoveWithTheMeanUnlessStated) {
  const FitParameters chosen = choose(R"(
[[parameter]]
match = "tip/dorsal"
mean_mm = 2
[[parameter]]
match = "tip/radial"
mean_mm = 2
range_mm = 1
[[parameter]]
match = "tip/proximal"
lower_mm = -3
)");
  EXPECT_NEAR(named(chosen, "tip/dorsal").lower, -8e-3, 1e-15);
  EXPECT_NEAR(named(chosen, "tip/dorsal").upper, 12e-3, 1e-15);
  EXPECT_NEAR(named(chosen, "tip/radial").lower, 1e-3, 1e-15);
  EXPECT_NEAR(named(chosen, "tip/proximal").lower, -3e-3, 1e-15);
}

TEST(ChooseParameters, TiedOnesMoveByTheirRatio) {
  const FitParameters chosen = choose(R"(
[[parameter]]
match = "tip/dorsal"
state = "free"
[[parameter]]
match = "tip/radial"
state = "tied"
tie_to = "tip/dorsal"
tie_ratio = -2
)");
  ASSERT_EQ(chosen.coordinates(), 1);
  const std::vector<double> values =
      parameter_values<double>(chosen, Eigen::VectorXd::Constant(1, 3e-3));
  for (std::size_t p = 0; p < values.size(); ++p) {
    const std::string& name = chosen.all[p].name;
    if (!matches_glob("tip/*", name)) continue;
    EXPECT_DOUBLE_EQ(values[p], name == "tip/dorsal"   ? 3e-3
                                : name == "tip/radial" ? -6e-3
                                                       : 0)
        << name;
  }
}

// u = (value - mean) / ratio: -3 u >= -2 mm holds for u <= 2/3 mm.
TEST(ChooseParameters, TiedOnesKeepTheirLeaderWithinTheirBounds) {
  const FitParameters chosen = choose(R"(
[[parameter]]
match = "tip/dorsal"
state = "free"
[[parameter]]
match = "tip/radial"
state = "tied"
tie_to = "tip/dorsal"
tie_ratio = -3
lower_mm = -2
)");
  EXPECT_NEAR(named(chosen, "tip/dorsal").upper, 2e-3 / 3, 1e-15);
  EXPECT_NEAR(named(chosen, "tip/dorsal").lower, -10e-3 / 3, 1e-15);
}

TEST(ChooseParameters, OptionalTiesToWhatIsNotThereAreFree) {
  // A subject with FDS alone has no friction of FDP to share: its own is not a fixed belief.
  const FitParameters chosen = choose(R"(
[[parameter]]
match = "friction/FDS"
optional = "yes"
state = "tied"
tie_to = "friction/FPL"
mean = 0.1
sd = 0.05
between_sd = 0
)");
  EXPECT_EQ(free_names(chosen), std::vector<std::string>{"friction/FDS"});
}

TEST(ChooseParameters, RefusesAnOutOfPlaneHoldThatCannotMove) {
  EXPECT_EQ(refusal("", {"hold/out_of_plane"}),
            "'hold/out_of_plane' is free with mean 0, from where no fit can move it: give it a "
            "mean");
  EXPECT_EQ(refusal("[[parameter]]\nmatch='hold/*'\nmean_mm=39\n", {"hold/*"}), "");
}

// A mean that the settings state must be the value that the model has.
TEST(ChooseParameters, StatedMeansReachTheModel) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(0);
  const FitParameters chosen = choose(R"(
[[parameter]]
match = "tip/dorsal"
mean_mm = 2
[[parameter]]
match = "path/FDS/1/proximal"
mean_mm = 1
[[parameter]]
match = "gain/LU"
mean = 1.5
)");
  const TendonModel<double>& from = finger().model;
  const SpecimenModel<double> model =
      specimen_model(finger(), chosen, parameter_values<double>(chosen, none));
  EXPECT_NEAR((model.digit.tip - from.tip).y(), 2e-3, 1e-15);
  const auto& strands = finger().names.strands;
  const auto fds = std::find(strands.begin(), strands.end(), "FDS") - strands.begin();
  EXPECT_NEAR((model.digit.paths[fds][0].p - from.paths[fds][0].p).x(), 1e-3, 1e-15);
  EXPECT_NEAR(model.gain.maxCoeff(), 1.5, 1e-15);
}

TEST(ChooseParameters, StatedMeanOfAnArmReachesTheModel) {
  const SourceText text = sample::source("subjects/arms_thumb");
  const TendonDigit thumb = build_tendon_digit(parse_subject(text.text, text.path), "thumb");
  const FitParameters chosen = choose_parameters(
      thumb, {}, sample::settings("[[parameter]]\nmatch = 'arm/FPL/IP1'\nmean_mm = 7\n"));
  const SpecimenModel<double> model =
      specimen_model(thumb, chosen, parameter_values<double>(chosen, Eigen::VectorXd::Zero(0)));
  EXPECT_NEAR((model.digit.constant_arms - thumb.model.constant_arms).sum(), 0.7e-3, 1e-15);
}

// -- Refusals ---------------------------------------------------------------------------------

TEST(ChooseParameters, NamesTheRowThatMatchesNothing) {
  EXPECT_EQ(refusal("\n[[parameter]]\nmatch = 'gane/*'\nstate = 'free'\n"),
            "fit.toml:3: no parameter matches 'gane/*'; list them with `thenar explain`");
  EXPECT_EQ(refusal("[[parameter]]\nmatch = 'gane/*'\noptional = 'yes'\n"), "");
  EXPECT_EQ(refusal("", {"gane/*"}),
            "to be free: no parameter matches 'gane/*'; list them with `thenar explain`");
}

TEST(ChooseParameters, NamesTheWrongUnit) {
  EXPECT_EQ(refusal("[[parameter]]\nmatch = 'gain/LU'\nsd_mm = 1\n"),
            "fit.toml:2: 'gain/LU' is a plain number, the row states a length");
  EXPECT_EQ(refusal("[[parameter]]\nmatch = 'sensor/dorsal'\nmean = 1\n"),
            "fit.toml:2: 'sensor/dorsal' is an angle, the row states a plain number");
}

TEST(ChooseParameters, NamesTheTieToWhatIsNotFree) {
  EXPECT_EQ(refusal("[[parameter]]\nmatch='gain/LU'\nstate='tied'\ntie_to='gain/UI'\n"),
            "'gain/LU' is tied to 'gain/UI', which is not a free parameter");
}

TEST(ChooseParameters, NamesTheMeanOutsideItsBounds) {
  EXPECT_EQ(refusal("[[parameter]]\nmatch='gain/LU'\nmean=1\nlower=2\nupper=3\n"),
            "prior mean 1 of 'gain/LU' is outside 2 .. 3 [SI]");
}

FitParameters of_planar_finger(const std::string& subject, const FitSettings& settings,
                               const std::vector<std::string>& also_free = {}) {
  return choose_parameters(build_tendon_digit(parse_subject(subject, "planar.toml"), "index"),
                           {"bent"}, settings, also_free);
}

FitSettings built_in_finger() {
  const SourceText finger = built_in_settings("index");
  return parse_fit_settings(finger.text, finger.path);
}

// FDS inserts on the middle phalanx, so five of its and FDP's six arms are no zeros and move.
TEST(ChooseParameters, FingersThatAreKnownByTheirArmsMoveThem) {
  const FitParameters chosen = of_planar_finger(sample::planar_finger_of_arms(), built_in_finger());
  std::vector<std::string> arms;
  for (const std::string& name : free_names(chosen))
    if (matches_glob("arm/*", name)) arms.push_back(name);
  EXPECT_EQ(arms, (std::vector<std::string>{"arm/FDP/MCP2_FE", "arm/FDP/PIP2", "arm/FDP/DIP2",
                                            "arm/FDS/MCP2_FE", "arm/FDS/PIP2"}));
  EXPECT_TRUE(fixed_geometry_warnings(chosen).empty());
}

TEST(ChooseParameters, RowsOfNonzeroParametersLeaveOutArmsAtJointsThatAreNotCrossed) {
  const auto free_under = [](const std::string& more) {
    return free_names(of_planar_finger(
        sample::planar_finger_of_arms(),
        sample::settings("[[parameter]]\nmatch = 'arm/*'\nstate = 'free'\n" + more)));
  };
  EXPECT_EQ(free_under("").size(), 6U);
  const std::vector<std::string> crossed = free_under("nonzero = 'yes'\n");
  EXPECT_EQ(crossed.size(), 5U);
  EXPECT_EQ(std::count(crossed.begin(), crossed.end(), "arm/FDS/DIP2"), 0);
}

// A finger of points has no arms to be known by: ten points, three coordinates each.
TEST(ChooseParameters, FingersOfPointsMoveTheirPoints) {
  const FitParameters chosen = of_planar_finger(sample::kPlanarFinger, built_in_finger());
  for (const std::string& name : free_names(chosen)) EXPECT_FALSE(matches_glob("arm/*", name));
  EXPECT_TRUE(fixed_geometry_warnings(chosen).empty());
}

TEST(FixedGeometryWarnings, CountWhatCannotMoveAndSayHowToFreeIt) {
  const FitSettings angles = sample::settings("[[parameter]]\nmatch = 'angle/*'\nstate = 'free'\n");
  EXPECT_EQ(
      fixed_geometry_warnings(of_planar_finger(sample::planar_finger_of_arms(), angles)),
      std::vector<std::string>{"none of the 5 moment arms of the subject may move under these "
                               "settings: freeing 'arm/*' lets them"});
  EXPECT_EQ(fixed_geometry_warnings(of_planar_finger(sample::kPlanarFinger, angles)),
            std::vector<std::string>{"none of the 10 tendon points of the subject may move under "
                                     "these settings: freeing 'path/*' lets them"});
  const std::string arms = sample::planar_finger_of_arms();
  EXPECT_TRUE(fixed_geometry_warnings(of_planar_finger(arms, angles, {"arm/FDP/PIP2"})).empty());
}

}  // namespace
}  // namespace thenar
