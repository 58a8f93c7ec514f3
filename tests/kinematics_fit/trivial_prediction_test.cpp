// Tests for kinematics_fit/trivial_prediction.cpp: means by hand, and the published rows against
// each other.

#include "kinematics_fit/trivial_prediction.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "kinematics_fit/cross_validation.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

Trial row(const char* posture, std::map<std::string, double> tension, Eigen::Vector3d force) {
  return {posture, std::move(tension), force, {}, {}};
}

/// Two postures, 20 degrees of PIP flexion apart.
Experiment of_specimen(const std::string& name, std::vector<Trial> trials) {
  Experiment experiment;
  experiment.name = experiment.specimen = name;
  experiment.digit = "middle";
  experiment.postures = {{"straight", {{"PIP3", 0}}}, {"bent", {{"PIP3", radians(20)}}}};
  experiment.trials = std::move(trials);
  return experiment;
}

/// What the two others say of FDS at 10 N in the straight posture.
Eigen::Vector3d straight_fds(const std::vector<Experiment>& seen) {
  const Experiment asked = of_specimen("C", {row("straight", {{"FDS", 10}}, {9, 9, 9})});
  return trivial_force(asked, asked.trials[0], seen).value();
}

TEST(TrivialForce, IsTheMeanOfOthersPerTension) {
  const Experiment a = of_specimen(
      "A", {row("straight", {{"FDS", 10}}, {1, 2, 0}), row("bent", {{"FDS", 10}}, {7, 7, 7}),
            row("straight", {{"FDP", 10}}, {5, 5, 5})});
  const Experiment b = of_specimen("B", {row("straight", {{"FDS", 5}}, {2, 1, -1})});
  EXPECT_TRUE(straight_fds({a, b}).isApprox(Eigen::Vector3d(2.5, 2, -1), 1e-14));
}

TEST(TrivialForce, KnowsPosturesByTheirAngles) {
  Experiment a = of_specimen(
      "A", {row("bent", {{"FDS", 10}}, {7, 7, 7}), row("extended", {{"FDS", 10}}, {1, 2, 0})});
  a.postures.push_back({"extended", {{"MCP3_FE", radians(-1.5)}}});  // PIP3 is at 0
  EXPECT_EQ(straight_fds({a}), Eigen::Vector3d(1, 2, 0));
}

TEST(TrivialForce, FallsBackOnOtherPosturesOfTheSpecimenAndThenOfAll) {
  const Experiment a = of_specimen("A", {row("bent", {{"FDS", 10}}, {2, 0, 0})});
  const Experiment c = of_specimen("C", {row("bent", {{"FDS", 10}}, {4, 0, 0})});
  EXPECT_EQ(straight_fds({a, c}), Eigen::Vector3d(4, 0, 0));
  EXPECT_EQ(straight_fds({a}), Eigen::Vector3d(2, 0, 0));
}

TEST(TrivialForce, ComparesLoadsInProportion) {
  const Experiment a = of_specimen("A", {row("straight", {{"FDS", 4}, {"FDP", 2}}, {6, 0, 0})});
  const auto of = [&](std::map<std::string, double> tension) {
    const Experiment asked = of_specimen("C", {row("straight", std::move(tension), {9, 9, 9})});
    return trivial_force(asked, asked.trials[0], {a});
  };
  EXPECT_TRUE(of({{"FDS", 8}, {"FDP", 4}, {"EDC", 0}}).value().isApprox(Eigen::Vector3d(12, 0, 0)));
  EXPECT_FALSE(of({{"FDS", 4}, {"FDP", 3}}).has_value());
  EXPECT_FALSE(of({{"FDS", 4}}).has_value());
  EXPECT_FALSE(of({}).has_value());
}

// Nobody has pulled both at once: the sum of what each does alone, half and twice as hard.
TEST(TrivialForce, AddsUpLoadsThatNobodyHungTogether) {
  const Experiment a = of_specimen(
      "A", {row("straight", {{"FDS", 10}}, {1, 2, 0}), row("straight", {{"FDP", 10}}, {0, 4, 1})});
  const Experiment asked =
      of_specimen("C", {row("straight", {{"FDS", 5}, {"FDP", 20}}, {9, 9, 9})});
  EXPECT_TRUE(trivial_force(asked, asked.trials[0], {a})
                  .value()
                  .isApprox(Eigen::Vector3d(0.5, 9, 2), 1e-14));
}

TEST(SuperposedForce, IsTheSumOfTheSpecimensOwnSingleLoads) {
  const Experiment own = of_specimen(
      "A", {row("straight", {{"FDS", 10}}, {1, 2, 0}), row("straight", {{"FDP", 10}}, {0, 4, 1}),
            row("bent", {{"FDS", 10}}, {7, 7, 7})});
  const Experiment other = of_specimen("B", {row("straight", {{"FDS", 10}}, {5, 5, 5})});
  Experiment asked = of_specimen("A", {row("straight", {{"FDS", 5}, {"FDP", 20}}, {9, 9, 9}),
                                       row("bent", {{"FDS", 5}, {"FDP", 20}}, {9, 9, 9}),
                                       row("straight", {{"FDS", 5}}, {9, 9, 9})});
  EXPECT_TRUE(superposed_force(asked, asked.trials[0], {own, other})
                  .value()
                  .isApprox(Eigen::Vector3d(0.5, 9, 2), 1e-14));
  EXPECT_FALSE(superposed_force(asked, asked.trials[1], {own, other}).has_value());  // no FDP
  EXPECT_FALSE(superposed_force(asked, asked.trials[2], {own, other}).has_value());  // alone
  asked.specimen = "C";
  EXPECT_FALSE(superposed_force(asked, asked.trials[0], {own, other}).has_value());
}

TEST(TrivialForce, TurnsIntoTheAxesOfTheExperiment) {
  Experiment a = of_specimen("A", {row("straight", {{"FDS", 10}}, {1, 2, 3})});
  a.axes_of_digit << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // palmar, proximal, radial
  EXPECT_EQ(straight_fds({a}), Eigen::Vector3d(2, -1, 3));
  a.components = 2;
  const Experiment asked = of_specimen("C", {row("straight", {{"FDS", 10}}, {9, 9, 9})});
  EXPECT_FALSE(trivial_force(asked, asked.trials[0], {a}).has_value());
}

TEST(BesideTrivial, ComparesOverTheSameTrials) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  Prediction prediction;
  prediction.trials = {{"a", "x", {3, 0, 4}, {3, 0, 1}, none, 3, Eigen::Vector3d(3, 0, 0)},
                       {"b", "x", {0, 0, 5}, {0, 4, 5}, none}};
  const BesideTrivial beside = beside_trivial(prediction).value();
  EXPECT_DOUBLE_EQ(beside.model.relative, 3.0 / 5);
  EXPECT_DOUBLE_EQ(beside.trivial.relative, 4.0 / 5);
  EXPECT_EQ(beside.trivial.trials, 1);
  EXPECT_FALSE(beside.trivial.covered.has_value());
  prediction.trials.erase(prediction.trials.begin());
  EXPECT_FALSE(beside_trivial(prediction).has_value());
}

TEST(ErrorsByLoad, AreRootMeanSquaresByHand) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  Prediction prediction;
  prediction.trials = {
      {"a", "FDS", {3, 0, 4}, {3, 0, 1}, none, 3, Eigen::Vector3d(3, 0, 0)},
      {"a", "FDP", {1, 1, 1}, {1, 1, 1}, none, 3, Eigen::Vector3d(1, 1, 2)},
      {"b", "FDS", {4, 1, 0}, {4, 0, 0}, none, 3, Eigen::Vector3d(3, 0, 0)},
      {"b", "FDP", {9, 9, 9}, {0, 0, 0}, none},  // nobody else measured it
  };
  const std::vector<ErrorsOfLoad> errors = errors_by_load(prediction);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].loads, "FDS");
  EXPECT_EQ(errors[0].trials, 2);
  EXPECT_TRUE(errors[0].measured.isApprox(
      Eigen::Vector3d(std::sqrt(12.5), std::sqrt(0.5), std::sqrt(8.0))));
  EXPECT_TRUE(errors[0].model.isApprox(Eigen::Vector3d(0, std::sqrt(0.5), std::sqrt(4.5))));
  EXPECT_TRUE(
      errors[0].trivial.isApprox(Eigen::Vector3d(std::sqrt(0.5), std::sqrt(0.5), std::sqrt(8.0))));
  EXPECT_EQ(errors[1].trials, 1);
  EXPECT_EQ(errors[1].trivial, Eigen::Vector3d(0, 0, 1));
}

// |F_H02 - F_H01| over |F_H01| and over |F_H02| of the 24 rows of [Synek2019], by numpy.
TEST(TrivialForce, OfMeasuredFingersIsWhatTheirRowsSay) {
  sample::FitSetup setup = sample::middle_finger(R"(
[[parameter]]
match = "axis/*/direction/*"
state = "free"
)");
  setup.experiments.push_back(sample::experiment("H02"));
  const CrossValidation out = cross_validate(setup.problem(), LeaveOut::kSpecimen);
  EXPECT_NEAR(beside_trivial(out.experiments[0]).value().trivial.relative, 0.62886766, 1e-8);
  EXPECT_NEAR(beside_trivial(out.experiments[1]).value().trivial.relative, 0.59797979, 1e-8);
}

}  // namespace
}  // namespace thenar
