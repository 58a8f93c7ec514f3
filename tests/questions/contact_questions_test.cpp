// Tests for questions/contact_questions.cpp: two fingers on a ball, whose qualities are known.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "questions/question.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kBoundsGap = 2e-3;  // of epsilon, which is bounded from both sides

/// Opposite fingers on a ball of 60 mm. @param torsion  per normal force [m]
std::string two_fingers(double friction, double torsion) {
  Json contacts = Json::array();
  for (const double side : {-1.0, 1.0})
    contacts.push_back({{"position", {0.03 * side, 0, 0}},
                        {"normal", {-side, 0, 0}},
                        {"friction", friction},
                        {"torsion", torsion}});
  return Json{{"name", "two fingers"},
              {"centre_of_mass", {0, 0, 0}},
              {"torque_scale", 0.05},
              {"contacts", contacts}}
      .dump();
}

/// The answer without the volume, which takes longest.
OrderedJson measured(Json request) {
  request["volume"] = false;
  return question_named("contacts").ask(request, THENAR_DATA_DIR, {}).json(UnitSystem::kSi);
}

void expect_epsilon(const OrderedJson& answer, double wanted) {
  const double lower = answer["epsilon"]["lower"], upper = answer["epsilon"]["upper"];
  EXPECT_LE(lower, wanted * (1 + 1e-9));
  EXPECT_GE(upper, wanted * (1 - 1e-9));
  EXPECT_LT(upper - lower, kBoundsGap);
}

// Least of all is what the fingers bear about their common normal: with normal forces that sum up
// to 1, torsion / torque scale; with each up to 1, twice that.
TEST(ContactQuestions, EpsilonOfSoftFingersIsTheirTorsion) {
  const std::string text = two_fingers(0.5, 0.004);
  expect_epsilon(measured({{"text", text}, {"norm", "l1"}}), 0.004 / 0.05);
  expect_epsilon(measured({{"text", text}, {"norm", "linf"}}), 2 * 0.004 / 0.05);
}

// Points cannot turn the ball about the line between them.
TEST(ContactQuestions, PointsMissOneDirection) {
  const OrderedJson answer = measured({{"text", two_fingers(0.5, 0)}});
  EXPECT_FALSE(answer["force_closure"].get<bool>());
  EXPECT_EQ(answer["rank"].get<int>(), 5);
  EXPECT_EQ(answer["epsilon"]["upper"].get<double>(), 0);
  const std::vector<double> missing = answer["missing_direction"];
  EXPECT_NEAR(std::abs(missing[3]), 1, 1e-9);  // torque about x, after the force
}

// The name of a set is its file: the same answer as its text.
TEST(ContactQuestions, ReadsSetsByName) {
  const OrderedJson named = measured({{"contacts", "two_soft_fingers"}});
  const OrderedJson typed = measured({{"text", two_fingers(0.5, 0.004)}});
  EXPECT_EQ(named["epsilon"], typed["epsilon"]);
  EXPECT_EQ(named["grasp_matrix"], typed["grasp_matrix"]);
}

// Pyramids stand inside of the cones: what they bear is no more than what cones do.
TEST(ContactQuestions, PyramidsBearNoMoreThanCones) {
  const std::string text = two_fingers(0.2, 0.05);  // friction is what limits it
  const OrderedJson cones = measured({{"text", text}}),
                    pyramids = measured({{"text", text}, {"edges", 4}});
  EXPECT_LE(pyramids["epsilon"]["lower"].get<double>(), cones["epsilon"]["upper"].get<double>());
  EXPECT_LT(pyramids["epsilon"]["upper"].get<double>(), cones["epsilon"]["lower"].get<double>());
}

TEST(ContactQuestions, RefusesPyramidsOfTwoEdges) {
  EXPECT_EQ(message_of([] {
              (void)measured({{"contacts", "two_soft_fingers"}, {"edges", 2}});
            }),
            "wanted pyramids of 3 to 1000 edges, got 2");
  const std::string norm = message_of([] {
    (void)measured({{"contacts", "two_soft_fingers"}, {"norm", "l2"}});
  });
  EXPECT_EQ(norm, "norm: wanted one of l1, linf, got \"l2\"");
}

}  // namespace
}  // namespace thenar
