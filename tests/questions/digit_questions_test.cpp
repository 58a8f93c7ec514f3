// Tests for questions/digit_questions.cpp: what tendons of a finger obey, as answers have it.

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/units.h"
#include "questions/question.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

OrderedJson respond_to(const std::string& question, const Json& request) {
  return question_named(question).ask(request, THENAR_DATA_DIR, {}).json(UnitSystem::kSi);
}

std::vector<double> tip_force(const std::map<std::string, double>& tension) {
  return respond_to("tip_force", {{"subject", "synek2019_middle"},
                                  {"posture_deg", {{"MCP3_FE", 40}, {"PIP3", 55}}},
                                  {"tension_N", tension}})["force_N"];
}

// Without a net tendons are linear: forces of muscles add up, and grow with them.
TEST(DigitQuestions, TipForcesOfTendonsAddUp) {
  const std::vector<double> flexor = tip_force({{"FDP", 10}}), other = tip_force({{"RI", 4}}),
                            both = tip_force({{"FDP", 30}, {"RI", 4}});
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(both[i], 3 * flexor[i] + other[i], 1e-10 * std::abs(both[0]));
}

// Arms are the slopes of lengths, r = -dL/dq, in every joint and of every tendon.
TEST(DigitQuestions, ArmsAreSlopesOfLengths) {
  const std::map<std::string, double> posture{{"MCP3_FE", 0.4}, {"MCP3_AA", 0.05}, {"PIP3", 0.6}};
  const auto arms_at = [](const std::map<std::string, double>& q) {
    return respond_to("moment_arms", {{"subject", "synek2019_middle"}, {"posture_rad", q}});
  };
  const OrderedJson here = arms_at(posture);
  const double step = 1e-5;
  for (const auto& [joint, angle] : posture) {
    std::map<std::string, double> less = posture, more = posture;
    less[joint] = angle - step;
    more[joint] = angle + step;
    const OrderedJson before = arms_at(less), after = arms_at(more);
    for (const auto& [tendon, arms] : here["arms_m"].items()) {
      const double slope = (after["length_change_m"][tendon].get<double>() -
                            before["length_change_m"][tendon].get<double>()) /
                           (2 * step);
      EXPECT_NEAR(arms[joint].get<double>(), -slope, 1e-9) << tendon << " over " << joint;
    }
  }
}

// The segments of a finger turn in one plane: its tip by the sum of all flexions.
TEST(DigitQuestions, FlexionsOfAPoseAddUp) {
  const auto proximal = [](const Json& posture) {
    const OrderedJson tip =
        respond_to("pose", {{"model", "synek2019_middle"}, {"posture_deg", posture}})["tips"][0];
    return tip["proximal"].get<std::vector<double>>();
  };
  const std::vector<double> straight = proximal(Json::object()),
                            bent = proximal({{"MCP3_FE", 20}, {"PIP3", 30}, {"DIP3", 10}});
  double cosine = 0;
  for (std::size_t i = 0; i < 3; ++i) cosine += straight[i] * bent[i];
  EXPECT_NEAR(cosine, std::cos(60 * kPi / 180), 1e-12);
}

TEST(DigitQuestions, SaysWhichJointOrMuscleThereIsNot) {
  const std::string joint = message_of([] {
    (void)respond_to("pose", {{"model", "synek2019_middle"}, {"posture_deg", {{"PIP4", 1}}}});
  });
  EXPECT_NE(joint.find("PIP4"), std::string::npos) << joint;
  EXPECT_NE(joint.find("PIP3"), std::string::npos) << joint;
  const std::string muscle = message_of([] { (void)tip_force({{"FDPP", 1}}); });
  EXPECT_NE(muscle.find("'FDPP'"), std::string::npos) << muscle;
  EXPECT_EQ(message_of([] {
              (void)respond_to("tip_force", {{"subject", "synek2019_middle"}});
            }),
            "'tension_N' is missing: Tensions of muscles; others are slack.");
}

}  // namespace
}  // namespace thenar
