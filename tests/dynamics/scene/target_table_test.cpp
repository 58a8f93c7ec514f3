// Tests for dynamics/scene/target_table.cpp: drives that follow a table.

#include "dynamics/scene/target_table.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/scene/measure_run.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

SceneDriveSpec wrist() {
  SceneDriveSpec drive;
  drive.name = "wrist";
  drive.turns = true;
  return drive;
}

TargetTable table_of(const std::string& text) { return parse_target_table(text, "t.csv", wrist()); }
std::string table_complaint(const std::string& text) {
  return message_of<DataError>([&] { (void)table_of(text); });
}

/// Target at an instant by the drive that acts then; there must be one.
double target_at(const std::vector<SceneDrive>& drives, double t) {
  double target = std::nan("");
  int acting = 0;
  for (const SceneDrive& drive : drives)
    if (drive.when.holds(t)) {
      target = drive.target + drive.speed * (t - drive.when.from);
      ++acting;
    }
  EXPECT_EQ(acting, 1) << t;
  return target;
}

TEST(TargetTable, ReadsItsColumnInItsUnit) {
  const TargetTable table = table_of("# way\ntime_s,other_mm,wrist_deg\n0.5,1,0\n1,2,90\n");
  EXPECT_EQ(table.time, Eigen::Vector2d(0.5, 1));
  EXPECT_DOUBLE_EQ(table.target[1], 90 * kDegree);
  EXPECT_EQ(table_of("time_s,wrist_rad\n0,2\n").target[0], 2);
}

TEST(TargetTable, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(table_complaint("time_s,wrist_mm\n0,1\n"),
            "t.csv:1: wanted a column wrist_deg or wrist_rad, got wrist_mm");
  EXPECT_EQ(table_complaint("time_s,wrist_deg,wrist_rad\n0,1,1\n"),
            "t.csv:1: target 'wrist' stands in two units");
  EXPECT_THAT(table_complaint("# way\n\ntime_s,wrist_mm\n0,1\n"), StartsWith("t.csv:3: wanted"));
  EXPECT_EQ(table_complaint("time_s,wrist_deg\n0,1\n1e-310,2\n"),
            "t.csv:3: wanted rows of one time, or 1e-09 s apart, got 1e-310 s");
  EXPECT_EQ(table_complaint("wrist_deg\n0\n"), "t.csv:1: wanted a header 'time_s,TARGET,...'");
  EXPECT_EQ(table_complaint("time_s,wrist_deg\n0,x\n"), "t.csv:2: wanted a number, got 'x'");
  EXPECT_THAT(table_complaint("time_s,wrist_deg\n0,1\n0,1e30\n"),
              StartsWith("t.csv:3: wanted at most"));
}

TEST(TargetTable, DrivesFollowItOneAfterTheOther) {
  SceneDrive drive;
  drive.when = {0.25, 5};
  TargetTable table{Eigen::Vector4d(0.5, 1, 1, 2), Eigen::Vector4d(1, 3, 0, -2)};
  const std::vector<SceneDrive> drives = follow_table(drive, table);
  for (const auto& [t, target] : {std::pair{0.25, 1.0},
                                  {0.4, 1.0},
                                  {0.75, 2.0},
                                  {1.0, 0.0},
                                  {1.5, -1.0},
                                  {2.0, -2.0},
                                  {4.9, -2.0}})
    EXPECT_NEAR(target_at(drives, t), target, 1e-15);
  // Its span cuts pieces.
  drive.when = {0.75, 0.9};
  EXPECT_EQ(follow_table(drive, table).size(), 1u);
  EXPECT_NEAR(target_at(follow_table(drive, table), 0.8), 2.2, 1e-15);
}

using TargetFile = TemporaryFolder;

const std::string kCartTop = R"(name = "x"
source = "Mine"
gravity_m_s2 = [0, 0, 0]
[sources]
Mine = "Own"
[[body]]
name = "cart"
mass_g = 1000
[body.joint]
kind = "slide"
axis = [1, 0, 0]
)";
const std::string kPulled = R"([[body.shape]]
kind = "sphere"
size_mm = [10]
[[drive]]
name = "pull"
coordinate = "cart"
stiffness_N_per_m = 100
target_file = "way.csv"
)";

// A cart of 1 kg on a spring of 100 N/m whose end runs away at 1 m/s is v t - v sin(w t) / w away,
// w = 10/s; where the end stops, it swings on about it.
TEST_F(TargetFile, PullsACartAsTheSpringSays) {
  std::ofstream(folder_ / "way.csv") << "time_s,pull_mm\n0,0\n0.3,300\n";
  const std::string path = (folder_ / "s.toml").string();
  std::ofstream(path) << kCartTop + kPulled + "[stepping]\nduration_s = 0.7\n";
  const SceneSpec spec = read_scene(path);
  EXPECT_EQ(spec.files.size(), 2u);  // the table is a source
  const BuiltScene built = build_scene(spec, {});
  const SceneRun run = simulate_scene(built.scene, built.options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const double w = 10, t = 0.3, rest = 0.4;
  const double x = t - std::sin(w * t) / w, v = 1 - std::cos(w * t);
  const double end = 0.3 + (x - 0.3) * std::cos(w * rest) + v / w * std::sin(w * rest);
  EXPECT_NEAR(run.samples.back().q[0], end, 1e-8);
}

// All that a cart without friction has at the end is work of its drive, however the rows of the
// table lie between the samples.
TEST_F(TargetFile, GivesAllTheEnergyThatTheCartHas) {
  std::ofstream way(folder_ / "way.csv");
  way << "time_s,pull_mm\n";
  for (int k = 0; k <= 200; ++k) way << 0.003 * k << ',' << k + 3 * (k % 2) << '\n';
  way.close();
  const std::string path = (folder_ / "s.toml").string();
  std::ofstream(path) << kCartTop + kPulled + "[stepping]\nduration_s = 0.5\n";
  const BuiltScene built = build_scene(read_scene(path), {});
  const SceneRun run = simulate_scene(built.scene, built.options);
  const double v = run.samples.back().v[0];
  EXPECT_GT(v, 0.1);
  EXPECT_NEAR(measure_run(built.scene, run).work, 0.5 * v * v, 1e-4 * 0.5 * v * v);
}

TEST_F(TargetFile, TakesNoOtherTarget) {
  std::ofstream(folder_ / "way.csv") << "time_s,pull_mm\n0,0\n";
  const auto told = [&](const std::string& text) {
    return message_of<DataError>([&] {
      (void)parse_scene(text + "[stepping]\nduration_s = 1\n", (folder_ / "s.toml").string());
    });
  };
  EXPECT_THAT(told(kCartTop + kPulled + "target_mm = 1\n"), HasSubstr("says all of the target"));
  std::string loose = kPulled;
  loose.replace(loose.find("stiffness_N_per_m"), 23, "effort_N = 1           ");
  EXPECT_THAT(told(kCartTop + loose), HasSubstr("a 'target_file' needs a 'stiffness'"));
  std::string other = kPulled;
  other.replace(other.find("way.csv"), 7, "no.csv");
  EXPECT_THAT(told(kCartTop + other), HasSubstr("no.csv"));
}

}  // namespace
}  // namespace thenar
