// Tests for dynamics/scene/target_table.cpp: drives that follow a table.

#include "dynamics/scene/target_table.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/scene/measure_run.h"
#include "dynamics/stepping/simulate_scene.h"
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

/// A drive that follows a table.
SceneDrive following(const TargetTable& table) {
  SceneDrive drive;
  drive.table = std::make_shared<TargetTable>(table);
  return drive;
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
            "t.csv:1: target 'wrist' is given in two units");
  EXPECT_THAT(table_complaint("# way\n\ntime_s,wrist_mm\n0,1\n"), StartsWith("t.csv:3: wanted"));
  EXPECT_EQ(table_complaint("time_s,wrist_deg\n0,1\n1e-310,2\n"),
            "t.csv:3: wanted rows of one time, or 1e-09 s apart, got 1e-310 s");
  EXPECT_EQ(table_complaint("wrist_deg\n0\n"), "t.csv:1: wanted a header 'time_s,TARGET,...'");
  EXPECT_EQ(table_complaint("time_s,wrist_deg\n0,x\n"), "t.csv:2: wanted a number, got 'x'");
  EXPECT_THAT(table_complaint("time_s,wrist_deg\n0,1\n0,1e30\n"),
              StartsWith("t.csv:3: wanted at most"));
}

TEST(TargetTable, ADriveFollowsIt) {
  const SceneDrive drive = following({Eigen::Vector4d(0.5, 1, 1, 2), Eigen::Vector4d(1, 3, 0, -2)});
  for (const auto& [t, target, speed] : {std::tuple{0.25, 1.0, 0.0},
                                         {0.75, 2.0, 4.0},
                                         {1.0, 0.0, -2.0},
                                         {1.5, -1.0, -2.0},
                                         {2.0, -2.0, 0.0},
                                         {4.9, -2.0, 0.0}}) {
    EXPECT_NEAR(drive_target(drive, t, t).value, target, 1e-15);
    EXPECT_EQ(drive_target(drive, t, t).speed, speed);
  }
  // A step that ends at the jump keeps to the line of its beginning.
  EXPECT_EQ(drive_target(drive, 1, 0.9).value, 3);
}

// Steps end where the target jumps or its slope changes while the drive acts.
TEST(TargetTable, StepsEndAtItsCornersAlone) {
  MovingScene scene;
  Eigen::VectorXd time(6), target(6);
  time << 0, 0.5, 1, 1, 2, 3;
  target << 0, 0.5, 1, 5, 5, 6;
  scene.drives.push_back(following({time, target}));
  scene.drives[0].when = {0.25, 5};
  EXPECT_THAT(switching_times(scene), testing::ElementsAre(0.25, 1, 2, 3, 5));
}

// Rows of a straight line leave its ends, also where decimals are rounded; a corner stays.
TEST(TargetTable, RowsOfAStraightLineAreOne) {
  std::string text = "time_s,wrist_deg\n";
  for (int k = 0; k <= 1000; ++k)
    text += fmt::format("{:.3f},{:.4f}\n", 0.001 * k, k <= 700 ? 0.1234 * k : 86.38);
  const TargetTable table = table_of(text), straight = without_straight_knots(table);
  ASSERT_EQ(table.time.size(), 1001);
  EXPECT_EQ(straight.time, Eigen::Vector3d(0, 0.7, 1));
  EXPECT_EQ(straight.target[2], table.target[1000]);
  for (int k = 0; k < 1000; ++k) {
    const double t = table.time[k];
    EXPECT_NEAR(drive_target(following(straight), t, t).value, table.target[k], 1e-14) << k;
  }
  // A row that is off by a millionth of a degree is a corner, with both beside it.
  TargetTable bent = table;
  bent.target[300] += 1e-6 * kDegree;
  EXPECT_EQ(without_straight_knots(bent).time.size(), 6);
}

TEST(TargetTable, KeepsJumps) {
  Eigen::VectorXd time(5), target(5);
  time << 0, 1, 1, 1, 2;
  target << 0, 1, 1, 2, 3;
  const TargetTable table = without_straight_knots({time, target});
  EXPECT_EQ(table.time, Eigen::Vector4d(0, 1, 1, 2));
  EXPECT_EQ(table.target, Eigen::Vector4d(0, 1, 2, 3));
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

// A straight way is one drive and costs the steps of two rows, however many it is written in.
TEST_F(TargetFile, RowsOfAStraightLineCostNoSteps) {
  const std::string path = (folder_ / "s.toml").string();
  std::ofstream(path) << kCartTop + kPulled +
                             "[stepping]\nmethod = \"time-stepping\"\nduration_s = 1\n";
  std::vector<double> ends;
  for (const int rows : {2, 3334}) {
    std::ofstream way(folder_ / "way.csv");
    way << "time_s,pull_mm\n";
    for (int k = 0; k < rows; ++k) {
      const double t = std::round(1e6 * k / (rows - 1)) / 1e6;
      way << fmt::format("{:.6f},{:.6f}\n", t, 300 * t);
    }
    way.close();
    const BuiltScene built = build_scene(read_scene(path), {});
    EXPECT_EQ(built.scene.drives.size(), 1u);
    const SceneRun run = simulate_scene(built.scene, built.options);
    EXPECT_EQ(run.cost.steps, 1000);
    ends.push_back(run.samples.back().q[0]);
  }
  EXPECT_NEAR(ends[0], ends[1], 1e-14);
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
  SceneRun run = simulate_scene(built.scene, built.options);
  const double v = run.samples.back().v[0], energy = 0.5 * v * v;
  EXPECT_GT(v, 0.1);
  EXPECT_NEAR(measure_run(built.scene, run).work, energy, 1e-8 * energy);
  // Without the flows of steps, by sums over the samples.
  for (SceneSample& sample : run.samples) sample.w.resize(0);
  EXPECT_NEAR(measure_run(built.scene, run).work, energy, 1e-4 * energy);
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
