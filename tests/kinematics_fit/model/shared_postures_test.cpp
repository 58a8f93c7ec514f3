// Tests for kinematics_fit/model/shared_postures.cpp: postures are one by their angles, not by
// name.

#include "kinematics_fit/model/shared_postures.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "base/units.h"
#include "kinematics_fit/prediction.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using sample::fit_precisely;
using sample::FitSetup;
using sample::kAxes;
using sample::middle_finger;

/// Forces in single postures, a part of which people have in common.
const std::string kShared = R"(
[[parameter]]
match = "force/*/*/*"
state = "free"
sd = 0.03
between_sd = 0.04
)";

FitSetup two_people() {
  FitSetup setup = middle_finger(kAxes + kShared);
  setup.experiments.push_back(sample::experiment("H02"));
  return setup;
}

const Parameter& parameter(const FitParameters& of, const std::string& name) {
  for (const Parameter& p : of.all)
    if (p.name == name) return p;
  throw std::runtime_error("no parameter " + name);
}

// 1.9 degrees are the same posture, 2.1 degrees another; a joint that is not named stands at 0.
TEST(SharedPostures, AreOneByTheirAngles) {
  const PostureRecord a{"A", {{"PIP3", radians(40)}, {"DIP3", radians(1.9)}}};
  EXPECT_TRUE(same_posture(&a, &a));
  const PostureRecord near{"B", {{"PIP3", radians(41.9)}}};
  EXPECT_TRUE(same_posture(&a, &near));
  EXPECT_TRUE(same_posture(&near, &a));
  const PostureRecord far{"A", {{"PIP3", radians(42.1)}}};
  EXPECT_FALSE(same_posture(&a, &far));
  EXPECT_FALSE(same_posture(&a, nullptr));
}

// What people share in a posture is kept to each of them where one name stands for two postures:
// the whole variance, .03^2 + .04^2 = .05^2, is then between them. Other postures keep theirs.
TEST(SharedPostures, OfOneNameAtOtherAnglesAreNotShared) {
  FitSetup setup = two_people();
  EXPECT_EQ(parameter(setup.problem().parameters(), "force/FDS/dorsal/Hook").sd, 0.03);
  for (PostureRecord& posture : setup.experiments[1].postures)
    if (posture.name == "Hook") posture.angles["PIP3"] += radians(3);
  const FitProblem problem = setup.problem();
  EXPECT_EQ(parameter(problem.parameters(), "force/FDS/dorsal/Hook").sd, 0);
  EXPECT_NEAR(parameter(problem.parameters(), "force/FDS/dorsal/Hook").between_sd, 0.05, 1e-15);
  EXPECT_EQ(parameter(problem.parameters(), "force/FDS/dorsal/MinorFlex").sd, 0.03);
}

/// An experiment of one posture at this angle.
Experiment held_at(const std::string& name, const std::string& specimen, double degrees) {
  Experiment e;
  e.name = name;
  e.specimen = specimen;
  e.postures = {{"Hook", {{"PIP3", radians(degrees)}}}};
  e.trials.resize(1);
  e.trials[0].posture = "Hook";
  return e;
}

// Of one's own experiments one that stands alike is enough, of others' all must; the order of files
// does not matter: 0 and 2, and 0 and -2 degrees are the same posture, 2 and -2 are not.
TEST(SharedPostures, AreKnownByOnesOwnOrByAllOthers) {
  const Experiment a = held_at("a", "H01", 0), b = held_at("b", "H01", 10),
                   c = held_at("c", "H02", 2);
  EXPECT_EQ(with_own_postures(held_at("x", "H01", 10), {a, b}).trials[0].posture, "Hook");
  EXPECT_EQ(with_own_postures(held_at("x", "H01", 5), {a, b}).trials[0].posture, "Hook (x)");
  EXPECT_EQ(with_own_postures(held_at("x", "H01", 5), {a, b}).postures[0].name, "Hook (x)");
  EXPECT_EQ(with_own_postures(held_at("x", "H03", 0), {a, c}).trials[0].posture, "Hook");
  EXPECT_EQ(with_own_postures(held_at("x", "H03", 0), {a, b, c}).trials[0].posture, "Hook (x)");
  EXPECT_EQ(with_own_postures(held_at("x", "H03", 0), {}).trials[0].posture, "Hook");
  // Both are told.
  EXPECT_EQ(
      posture_name_warnings({with_own_postures(held_at("x", "H01", 5), {a, b})}),
      std::vector<std::string>{"experiment 'x': posture 'Hook' is more than 2 degrees from that of "
                               "the same name in other experiments: it is treated as another one"});
  EXPECT_EQ(posture_name_warnings({a, b}).size(), 1U);
  EXPECT_TRUE(posture_name_warnings({a, held_at("x", "H03", 1)}).empty());

  FitParameters parameters;
  parameters.postures = {"Hook"};
  parameters.all = {{"force/FDS/dorsal/Hook", ParameterKind::kPostureForce}};
  parameters.all[0].sd = 0.03;
  std::vector<Experiment> three{a, c, held_at("d", "H03", -2)};
  std::sort(three.begin(), three.end(),
            [](const auto& x, const auto& y) { return x.name < y.name; });
  do {
    EXPECT_EQ(share_same_postures(parameters, three).all[0].sd, 0);
  } while (std::next_permutation(three.begin(), three.end(),
                                 [](const auto& x, const auto& y) { return x.name < y.name; }));
  EXPECT_EQ(share_same_postures(parameters, {a, c}).all[0].sd, 0.03);
}

// A stranger whose Hook stands elsewhere is predicted as if it had another name.
TEST(SharedPostures, OfAStrangerAtOtherAnglesIsUnknown) {
  const FitSetup setup = two_people();
  const FitProblem problem = setup.problem();
  const Solution found = fit_precisely(problem);
  const ArrowMatrix C = posterior_covariance(problem, found.z).C;
  Experiment unseen = sample::experiment("B01");
  const Prediction shared = predict_experiment(problem, found.z, C, unseen, -1);
  for (PostureRecord& posture : unseen.postures)
    if (posture.name == "Hook") posture.angles["PIP3"] += radians(3);
  const Prediction moved = predict_experiment(problem, found.z, C, unseen, -1);
  for (PostureRecord& posture : unseen.postures)
    if (posture.name == "Hook") posture.name = "Claw";
  for (Trial& trial : unseen.trials)
    if (trial.posture == "Hook") trial.posture = "Claw";
  const Prediction renamed = predict_experiment(problem, found.z, C, unseen, -1);
  double learnt = 0;  // [N]
  for (std::size_t i = 0; i < moved.trials.size(); ++i) {
    EXPECT_TRUE(matrix_near(moved.trials[i].predicted, renamed.trials[i].predicted, 1e-12));
    EXPECT_TRUE(matrix_near(moved.trials[i].sd, renamed.trials[i].sd, 1e-12));
    EXPECT_EQ(moved.trials[i].posture == "Hook", renamed.trials[i].posture == "Claw");
    // What two people showed in common narrows a known posture alone.
    if (shared.trials[i].posture == "Hook")
      learnt = std::max(learnt, (moved.trials[i].sd - shared.trials[i].sd).maxCoeff());
    else
      EXPECT_TRUE(matrix_near(moved.trials[i].sd, shared.trials[i].sd, 1e-12));
  }
  EXPECT_GT(learnt, 0.005);
}

}  // namespace
}  // namespace thenar
