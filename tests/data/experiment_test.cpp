// Tests for data/io/experiment.cpp.

#include "data/io/experiment.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

const std::string kGoodExperiment = R"(name = "E1"
species = "human"
source = "Synek2019"
digit = "middle"
[protocol]
hold = "rigid"
gravity_m_s2 = 10
pulley_efficiency = 0.8
[force]
segment = "DP3"
components = ["-proximal", "palmar", "radial"]
[noise]
relative = 0.3
floor_N = 0.4
[[posture]]
name = "Hook"
angles_deg = {PIP3 = 90}
[trials]
rows = [
  {posture = "Hook", load_g = {FDS = 500}, force_N = [1, 0, 0], moment_Nmm = [1, 2, 3]},
  {posture = "Hook", tension_N = {FDP = 7}, force_N = [0, 2, 0], sd_N = [0.1, 0.2, 0.3]},
]
)";

std::string broken(const std::string& from, const std::string& to) {
  std::string text = kGoodExperiment;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// What the reader says of kGoodExperiment with `from` replaced by `to`.
std::string experiment_refusal(const std::string& from, const std::string& to) {
  try {
    (void)parse_experiment(broken(from, to), "e.toml");
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

class ExperimentFile : public testing::Test {
 protected:
  const Experiment experiment_ = parse_experiment(kGoodExperiment, "e.toml");
};

TEST_F(ExperimentFile, HeaderIsRead) {
  EXPECT_EQ(experiment_.name, "E1");
  EXPECT_EQ(experiment_.specimen, "E1") << "one experiment a specimen unless stated";
  EXPECT_EQ(experiment_.source, "Synek2019");
  EXPECT_EQ(experiment_.hold, TipConstraint::kRigid);
}

// 0.5 kg x 10 m/s^2 x 0.8
TEST_F(ExperimentFile, LoadBecomesTension) {
  EXPECT_DOUBLE_EQ(experiment_.trials[0].tension.at("FDS"), 4);
  EXPECT_DOUBLE_EQ(experiment_.trials[1].tension.at("FDP"), 7) << "stated tension stays";
}

TEST_F(ExperimentFile, ComponentsAreSignedDigitDirections) {
  Eigen::Matrix3i expected;
  expected << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  EXPECT_EQ(experiment_.axes_of_digit, expected);
}

TEST_F(ExperimentFile, MomentIsInNewtonMetres) {
  EXPECT_TRUE(matrix_near(*experiment_.trials[0].moment, Vector3d(1e-3, 2e-3, 3e-3), 1e-18));
  EXPECT_FALSE(experiment_.trials[1].moment);
}

TEST_F(ExperimentFile, AnglesAreInRadians) {
  EXPECT_NEAR(experiment_.postures[0].angles.at("PIP3"), 1.5707963267948966, 1e-15);
}

// hypot(0.4 N, 0.3 x 1 N) = 0.5 N
TEST_F(ExperimentFile, NoiseIsFloorAndFraction) {
  EXPECT_TRUE(
      matrix_near(force_sd(experiment_, experiment_.trials[0]), Vector3d::Constant(0.5), 1e-15));
  EXPECT_TRUE(
      matrix_near(force_sd(experiment_, experiment_.trials[1]), Vector3d(0.1, 0.2, 0.3), 0));
}

TEST(ExperimentErrors, MissingForceFrame) {
  EXPECT_EQ(
      experiment_refusal("[force]\nsegment = \"DP3\"\ncomponents = [\"-proximal\", \"palmar\", "
                         "\"radial\"]\n",
                         ""),
      "e.toml:1: the file needs [force]: the segment and the axes of the forces");
}

TEST(ExperimentErrors, UnknownComponent) {
  EXPECT_EQ(experiment_refusal("palmar", "upward"),
            "e.toml:11: wanted each of 'components' to be one of proximal, distal, dorsal, palmar, "
            "radial, ulnar or its negative, got 'upward'");
}

TEST(ExperimentErrors, ComponentsAlongOneDirection) {
  EXPECT_EQ(experiment_refusal("palmar", "distal"),
            "e.toml:11: wanted 'components' along three different directions");
}

const std::string kThree = R"(components = ["-proximal", "palmar", "radial"])";

TEST(ExperimentErrors, TwoComponentsAcrossThePlaneOfFlexion) {
  EXPECT_EQ(experiment_refusal(kThree, R"(components = ["proximal", "radial"])"),
            "e.toml:11: wanted 2 'components' in the plane of flexion: one proximal or distal, one "
            "dorsal or palmar");
}

TEST(ExperimentErrors, NotModelledInThePlane) {
  EXPECT_EQ(experiment_refusal(kThree, kThree + "\nnot_modelled = \"dorsal\""),
            "e.toml:12: wanted 'not_modelled' to be the component across the plane of flexion, "
            "radial or ulnar");
}

TEST(ExperimentErrors, NotModelledAndNotMeasured) {
  EXPECT_EQ(experiment_refusal(kThree,
                               "components = [\"proximal\", \"dorsal\"]\n"
                               "not_modelled = \"radial\""),
            "e.toml:12: 'not_modelled' names none of 'components'");
}

TEST(ExperimentErrors, ThreeForcesForTwoComponents) {
  EXPECT_EQ(experiment_refusal(kThree, "components = [\"proximal\", \"dorsal\"]").substr(0, 10),
            "e.toml:20:");
}

// The second of three is not fitted: of the others the order stays, and nothing is known of it.
TEST(ExperimentFileComponents, LeaveOutWhatIsNotModelled) {
  const Experiment experiment = parse_experiment(
      broken(kThree,
             "components = [\"palmar\", \"ulnar\", \"proximal\"]\nnot_modelled = \"radial\""),
      "e.toml");
  EXPECT_EQ(experiment.components, 2);
  EXPECT_EQ(experiment.axes_of_digit.row(0), Eigen::RowVector3i(0, -1, 0));
  EXPECT_EQ(experiment.axes_of_digit.row(1), Eigen::RowVector3i(1, 0, 0));
  EXPECT_EQ(experiment.trials[0].force, Vector3d(1, 0, 0));
  const Vector3d sd = force_sd(experiment, experiment.trials[1]);
  EXPECT_EQ(sd, Vector3d(0.1, 0.3, kInfinity));
}

TEST(ExperimentErrors, UndefinedPosture) {
  EXPECT_EQ(experiment_refusal("{posture = \"Hook\"", "{posture = \"Hock\""),
            "e.toml:20: posture 'Hock' is not defined, did you mean 'Hook'?");
}

TEST(ExperimentErrors, TendonThatPushes) {
  EXPECT_EQ(experiment_refusal("FDS = 500", "FDS = -500"),
            "e.toml:20: tendon 'FDS' cannot push, got -0.5 kg");
}

TEST(ExperimentErrors, NotANumber) {
  EXPECT_EQ(experiment_refusal("[1, 0, 0]", "[1, nan, 0]"),
            "e.toml:20: wanted 'force_N' as a finite number, got nan");
}

TEST(ExperimentErrors, WrongUnit) {
  EXPECT_EQ(experiment_refusal("force_N = [1", "force_mm = [1"),
            "e.toml:20: wanted a force (force_N), got 'force_mm'");
  EXPECT_EQ(experiment_refusal("angles_deg", "angles_mm"),
            "e.toml:17: wanted an angle (angles_deg, angles_rad), got 'angles_mm'");
}

TEST(ExperimentErrors, UnknownKey) {
  EXPECT_EQ(experiment_refusal("moment_Nmm", "momant_Nmm"),
            "e.toml:20: unknown key 'momant_Nmm', did you mean 'moment_Nmm'?");
}

TEST(ExperimentErrors, NoLoad) {
  EXPECT_EQ(experiment_refusal("load_g = {FDS = 500}, ", ""),
            "e.toml:20: a trial needs 'load_g' or 'tension_N'");
}

TEST(ExperimentErrors, NoTrials) {
  const std::size_t rows = kGoodExperiment.find("rows = [");
  EXPECT_EQ(experiment_refusal(kGoodExperiment.substr(rows), "rows = []\n"),
            "e.toml:19: wanted at least one trial in 'rows', got none");
  EXPECT_EQ(experiment_refusal(kGoodExperiment.substr(rows), ""),
            "e.toml:18: wanted at least one trial in 'rows', got none");
}

TEST(ExperimentErrors, NoNoise) {
  EXPECT_EQ(experiment_refusal("[noise]\nrelative = 0.3\nfloor_N = 0.4\n", ""),
            "e.toml:17: a trial needs 'sd_N', or the file a [noise] table");
  EXPECT_EQ(experiment_refusal("floor_N = 0.4\n", ""),
            "e.toml:12: [noise] needs 'floor_N' > 0: a force of zero is not known exactly");
}

TEST(ExperimentErrors, PostureGivenTwice) {
  EXPECT_EQ(experiment_refusal("[trials]", "[[posture]]\nname = \"Hook\"\n[trials]"),
            "e.toml:19: posture 'Hook' is given twice");
}

TEST(ExperimentErrors, BadHold) {
  EXPECT_EQ(experiment_refusal("rigid", "loose"),
            "e.toml:6: wanted 'hold' to be one of pinned, rigid, got 'loose'");
}

TEST(ExperimentErrors, NoSource) {
  EXPECT_EQ(experiment_refusal("source = \"Synek2019\"\n", ""),
            "e.toml:1: the top level needs 'source' (a citation key)");
}

// -- Electromyography ------------------------------------------------------------------------

const std::string kActivation = R"([[activation]]
posture = "Hook"
activation = {FDS = 0.3, FDP = 0.2}
activation_sd = 0.1
force_N = [1, 2, 3]
[[activation]]
posture = "Hook"
activation = {FDS = 0.5, FDP = 0.4}
activation_sd = 0.1
activation_sd_of = {FDP = 0.05}
force_N = [3, 0, 4]
sd_N = [0.1, 0.2, 0.3]
[trials]
)";

TEST(ActivationRows, AreRead) {
  const Experiment experiment = parse_experiment(broken("[trials]\n", kActivation), "e.toml");
  ASSERT_EQ(experiment.activations.size(), 2U);
  const ActivationRow& first = experiment.activations[0];
  EXPECT_EQ(first.posture, "Hook");
  EXPECT_EQ(first.activation, (std::map<std::string, double>{{"FDS", 0.3}, {"FDP", 0.2}}));
  EXPECT_EQ(first.sd, (std::map<std::string, double>{{"FDS", 0.1}, {"FDP", 0.1}}));
  EXPECT_TRUE(matrix_near(first.force, Vector3d(1, 2, 3), 0));
  // hypot(0.4 N, 0.3 sqrt(14) N)
  EXPECT_TRUE(
      matrix_near(force_sd(experiment, first), Vector3d::Constant(1.1916375287812984), 1e-15));
  const ActivationRow& second = experiment.activations[1];
  EXPECT_EQ(second.sd, (std::map<std::string, double>{{"FDS", 0.1}, {"FDP", 0.05}}));
  EXPECT_TRUE(matrix_near(force_sd(experiment, second), Vector3d(0.1, 0.2, 0.3), 0));
  EXPECT_EQ(experiment.trials.size(), 2U);
}

TEST(ActivationRows, MayStandAlone) {
  std::string text = broken("[trials]\n", kActivation);
  text.erase(text.find("[trials]"));
  EXPECT_TRUE(parse_experiment(text, "e.toml").trials.empty());
}

/// What the reader says of kActivation with `from` replaced by `to`.
std::string activation_refusal(const std::string& from, const std::string& to) {
  std::string rows = kActivation;
  rows.replace(rows.find(from), from.size(), to);
  return experiment_refusal("[trials]\n", rows);
}

TEST(ActivationRows, SayWhatIsWrongWithThem) {
  EXPECT_EQ(activation_refusal("FDS = 0.3", "FDS = 1.3"),
            "e.toml:20: wanted 'activation.FDS' in 0..1, got 1.3");
  EXPECT_EQ(activation_refusal("activation = {FDS = 0.3, FDP = 0.2}\n", ""),
            "e.toml:18: wanted 'activation' of at least one muscle: {FPL = 0.3}");
  EXPECT_EQ(activation_refusal("\"Hook\"", "\"Hock\""),
            "e.toml:18: posture 'Hock' is not defined, did you mean 'Hook'?");
  EXPECT_EQ(activation_refusal("_of = {FDP", "_of = {EDC"),
            "e.toml:27: 'activation_sd_of' names muscle 'EDC', 'activation' does not");
  EXPECT_EQ(activation_refusal("activation_sd = 0.1\n", ""),
            "e.toml:18: [[activation]] needs a plain number (activation_sd)");
}

// What was measured on a specimen's outside.
TEST_F(ExperimentFile, ReadsLengthsOfTheSpecimen) {
  EXPECT_TRUE(experiment_.outside_length.empty());
  const Experiment sized = parse_experiment(
      broken("[protocol]", "[outside]\nlength_cm = {PP3 = 4.5, MP3 = 2.5}\n[protocol]"), "e.toml");
  ASSERT_EQ(sized.outside_length.size(), 2U);
  EXPECT_DOUBLE_EQ(sized.outside_length.at("PP3"), 0.045);
  EXPECT_DOUBLE_EQ(sized.outside_length.at("MP3"), 0.025);
}

TEST_F(ExperimentFile, RefusesOutsideWithoutLengths) {
  EXPECT_EQ(experiment_refusal("[protocol]", "[outside]\n[protocol]"),
            "e.toml:5: [outside] needs the 'length_mm' of at least one segment: {PP3 = 45.1}");
  EXPECT_NE(experiment_refusal("[protocol]", "[outside]\nlength_mm = {PP3 = 0}\n[protocol]"), "");
}

// A place in [force] is that of all rows but those that state their own.
TEST_F(ExperimentFile, ReadsWhereForcesWereMeasured) {
  const Experiment rows = parse_experiment(broken("{posture = \"Hook\", tension_N",
                                                  "{at = \"MC3\", tendons_leave = \"along_bone\", "
                                                  "posture = \"Hook\", tension_N"),
                                           "e.toml");
  EXPECT_FALSE(rows.trials[0].site);
  ASSERT_TRUE(rows.trials[1].site);
  EXPECT_EQ(rows.trials[1].site->axes, "MC3");
  EXPECT_EQ(rows.trials[1].site->leave, TendonExit::kAlongBone);
  const Experiment all = parse_experiment(
      broken("segment = \"DP3\"", "segment = \"DP3\"\nat = \"PP3\"\nat_mm = [1, 2, 3]"), "e.toml");
  for (const Trial& trial : all.trials) {
    ASSERT_TRUE(trial.site);
    EXPECT_EQ(trial.site->axes, "DP3");
    EXPECT_EQ(*trial.site->point, Vector3d(0.001, 0.002, 0.003));
  }
}

TEST_F(ExperimentFile, RefusesAPlaceWithoutSegment) {
  EXPECT_NE(experiment_refusal("load_g = {FDS", "at_fraction = 0.5, load_g = {FDS")
                .find("'at_fraction' needs 'at', a segment"),
            std::string::npos);
  EXPECT_NE(experiment_refusal("load_g = {FDS",
                               "at = \"PP3\", at_mm = [0, 0, 0], at_fraction = 0.5, load_g = {FDS")
                .find("got both"),
            std::string::npos);
}

}  // namespace
}  // namespace thenar
