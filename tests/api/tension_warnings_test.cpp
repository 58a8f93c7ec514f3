// Tests for api/named/digits.cpp: warnings of tensions and of arms of the wrong sign.

#include <gtest/gtest.h>

#include "api/named/digits.h"
#include "api/tendon_solve.h"
#include "api/tip_force.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

bool tells(const std::vector<std::string>& warnings, const std::string& part) {
  for (const std::string& warning : warnings)
    if (warning.find(part) != std::string::npos) return true;
  return false;
}

DigitRequest middle_finger(double mcp) {
  DigitRequest request;
  request.subject = kData + "/subjects/mirakhorlo2016.toml";
  request.digit = "middle";
  request.path = Path::kViaPoint;
  request.posture = {{{"MCP3_FE", mcp}}, {}, PostureUnit::kTyped};
  return request;
}

TEST(Overload, IsToldByEveryQuestionThatTakesTensions) {
  const std::map<std::string, double> pull{{"FDP3", 1000}};
  EXPECT_TRUE(tells(compute_tip_force({middle_finger(20), pull}).outcome.warnings,
                    "FDP3 is pulled with 1000 N, but can make"));
  EXPECT_TRUE(tells(solve_tendons({middle_finger(20), pull}).outcome.warnings,
                    "FDP3 is pulled with 1000 N, but can make"));
  EXPECT_FALSE(
      tells(compute_tip_force({middle_finger(20), {{"FDP3", 10}}}).outcome.warnings, "can make"));
}

// Straight runs of EDC3 pass the knuckle on its palmar side where it is bent far.
TEST(ReversalWarnings, NameExtensorsThatFlex) {
  const DigitCase bent = build_digit(middle_finger(80), Hood::kFractions);
  const DigitCase straight = build_digit(middle_finger(0), Hood::kFractions);
  EXPECT_TRUE(tells(bent.warnings, "unexpected sign here: EDC3 at MCP3_FE"));
  EXPECT_FALSE(tells(straight.warnings, "unexpected sign"));
}

TEST(ReversalWarnings, CountThePosturesOfAGrid) {
  DigitRequest request = middle_finger(0);
  request.vary = {{"MCP3_FE", 0, 80, 40}};
  EXPECT_TRUE(
      tells(build_digit(request, Hood::kFractions).warnings,
            "unexpected sign at 1 of 3 postures, first at MCP3_FE=80 deg: EDC3 at MCP3_FE"));
}

}  // namespace
}  // namespace thenar
