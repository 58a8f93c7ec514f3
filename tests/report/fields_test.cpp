#include "report/fields.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace thenar {
namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();

Fields sample() {
  return {
      {"hold", "pinned"},
      {"angle", units::kDegree, kPi / 6},
      {"force", units::kNewton, Eigen::Vector3d(1, -2, 0.5)},
      {"arm", units::kMillimetre, std::vector<std::string>{"PIP3", "DIP3"},
       Eigen::Vector2d(0.0071, -0.002)},
      {"check", Fields{{"gap", units::kNewton, 1e-9}, {"solved", true}}},
      {"muscles", std::vector<Fields>{{{"name", "FDP"}, {"length", units::kMillimetre, 0.25}}}}};
}

TEST(Fields, BearSiUnitsInSi) {
  EXPECT_EQ(json_text(json_of(sample(), UnitSystem::kSi), -1),
            R"({"hold":"pinned","angle_rad":0.5235987755982988,"force_N":[1.0,-2.0,0.5],)"
            R"("arm_m":{"PIP3":0.0071,"DIP3":-0.002},"check":{"gap_N":1e-09,"solved":true},)"
            R"("muscles":[{"name":"FDP","length_m":0.25}]})");
}

TEST(Fields, BearPrintedUnitsForPeople) {
  const OrderedJson json = json_of(sample(), UnitSystem::kPrinted);
  EXPECT_NEAR(json["angle_deg"].get<double>(), 30, 1e-13);
  EXPECT_EQ(json["arm_mm"]["PIP3"].get<double>(), 0.0071 / 1e-3);
  EXPECT_EQ(json["muscles"][0]["length_mm"].get<double>(), 250);
  EXPECT_EQ(json["check"]["gap_N"].get<double>(), 1e-9);
}

TEST(Fields, AreNullWhereThereIsNoNumber) {
  const Fields fields{{"a", units::kNewton, kNaN},
                      {"b", units::kMillimetre, std::optional<double>()},
                      {"c", units::kMillimetre, Eigen::Vector2d(INFINITY, 1)}};
  EXPECT_EQ(json_text(json_of(fields, UnitSystem::kPrinted), -1),
            R"({"a_N":null,"b_mm":null,"c_mm":[null,1000.0]})");
}

TEST(Fields, LeaveOutInSiWhatTheClockMeasured) {
  const Fields fields{{"cpu", units::kCpuSecond, 0.25}, {"time", units::kSecond, 2.0}};
  EXPECT_EQ(json_text(json_of(fields, UnitSystem::kSi), -1), R"({"time_s":2.0})");
  EXPECT_EQ(json_text(json_of(fields, UnitSystem::kPrinted), -1), R"({"cpu_s":0.25,"time_s":2.0})");
}

}  // namespace
}  // namespace thenar
