// Tests for report/answers/motion_account.cpp, and that answers of scenes have it.

#include "report/answers/motion_account.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "report/answers/simulate_scene.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

SceneResult run_of(const std::string& scene, SteppingMethod method) {
  SceneRequest request;
  request.scene = kData + "/scenes/" + scene + ".toml";
  request.seconds = 0.2;
  request.method = method;
  return simulate_scene(request);
}

TEST(MotionAccount, SaysWhetherEnergyWasMadeOrLost) {
  FlowBalance balance;
  balance.error = -1e-3;
  balance.turned_over = 1e-2 - 1e-4;
  balance.t = 0.25;
  EXPECT_EQ(energy_error_words(balance),
            "1 mJ created by 0.25 s, 10 % of 9.9 mJ total energy exchanged");
  balance.error = 1e-3;
  EXPECT_THAT(energy_error_words(balance), HasSubstr("unaccounted for"));
}

TEST(MotionAccount, NamesJointsBeyondTheirLimits) {
  const std::vector<PassedLimit> limits{{"door", false, 10 * kDegree}, {"drawer", true, 0.04}};
  EXPECT_EQ(beyond_words(limits[0]), "10 deg");
  EXPECT_EQ(beyond_words(limits[1]), "40 mm");
  const OrderedJson json = json_of(limit_fields(limits), UnitSystem::kPrinted);
  EXPECT_EQ(json[0], OrderedJson({{"joint", "door"}, {"beyond_rad", 10 * kDegree}}));
  EXPECT_EQ(json[1], OrderedJson({{"joint", "drawer"}, {"beyond_m", 0.04}}));
}

// A ball of 100 g falls by 100 mm and would bounce with 0.8 of its speed: by fixed steps it lies.
TEST(MotionAccount, OfFixedStepsIsInTextAndJson) {
  const SceneResult scene = run_of("falling_ball", SteppingMethod::kTimeStepping);
  const std::string text = text_of(scene);
  for (const char* words :
       {"energy error: ", "total energy exchanged", "impacts 98.1 mJ",
        "deepest overlap: ", "joint limits passed: none", "restitution ignored: up to 0.8"})
    EXPECT_THAT(text, HasSubstr(words));
  const OrderedJson json = json_of(scene);
  EXPECT_EQ(json["status"], "done");
  EXPECT_EQ(json["restitution_ignored"], 0.8);
  EXPECT_NEAR(json["dissipated_by_J"]["impacts"].get<double>(), 0.1 * 9.81 * 0.1, 1e-9);
  EXPECT_TRUE(json["limits_passed"].empty());
  EXPECT_THAT(scene_warnings(scene), testing::Contains(HasSubstr("restitution of up to 0.8")));
  // Between events it bounces.
  const SceneResult events = run_of("falling_ball", SteppingMethod::kEvents);
  EXPECT_THAT(text_of(events), AllOf(HasSubstr("energy error: "), Not(HasSubstr("restitution"))));
  EXPECT_EQ(json_of(events)["restitution_ignored"], 0.0);
}

TEST(MotionAccount, SaysThatSpringsForContactsTellNoError) {
  const SceneResult scene = run_of("pinch", SteppingMethod::kCompliantSundials);
  EXPECT_THAT(text_of(scene), HasSubstr("energy error: not known"));
  EXPECT_TRUE(json_of(scene)["energy_error_J"].is_null());
  EXPECT_TRUE(json_of(scene)["dissipated_by_J"].is_null());
  EXPECT_EQ(refusal_of(scene), "");
}

TEST(MotionAccount, RefusesARunWhoseEnergyDoesNotBalance) {
  SceneResult scene = run_of("pinch", SteppingMethod::kTimeStepping);
  EXPECT_EQ(refusal_of(scene), "");
  scene.measures.worst->error = -0.02;
  scene.measures.worst->turned_over = 1;
  EXPECT_THAT(refusal_of(scene), AllOf(HasSubstr("energy does not balance, 20 mJ created"),
                                       HasSubstr("do not use this motion")));
  scene.run.cost.unsolved = 2;
  EXPECT_THAT(refusal_of(scene), AllOf(HasSubstr("energy does not balance"), HasSubstr("2 of ")));
}

TEST(MotionAccount, WarnsOfJointsBeyondTheirLimits) {
  SceneResult scene = run_of("pinch", SteppingMethod::kTimeStepping);
  EXPECT_THAT(scene_warnings(scene), testing::IsEmpty());
  scene.run.cost.limit_excess[0] = 0.25;
  EXPECT_THAT(scene_warnings(scene), testing::ElementsAre(HasSubstr("beyond its limit")));
  EXPECT_THAT(text_of(scene), HasSubstr("joint limits passed: "));
  EXPECT_EQ(json_of(scene)["limits_passed"].size(), 1U);
}

}  // namespace
}  // namespace thenar
