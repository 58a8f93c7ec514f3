// Tests for tendons/forces/tip_map.cpp.

#include "tendons/forces/tip_map.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

/// Two muscles; rows of the map out of order, with a moment among the forces.
Subject sample() {
  Subject subject;
  subject.name = "sample";
  subject.muscles.resize(2);
  subject.muscles[0].name = "A";
  subject.muscles[0].max_force = 5;
  subject.muscles[1].name = "B";
  TipMap map{"m", "index", {"ty", "Fz", "Fx", "Fy"}, {"A", "B"}, Eigen::MatrixXd(4, 2)};
  map.A << 0.1, 0.2, 3, 30, 1, 10, 2, 20;
  subject.tip_maps.push_back(map);
  return subject;
}

TEST(PublishedMap, SortsRowsIntoForcesThenMoments) {
  const Subject subject = sample();
  const TipStatics statics = statics_from_tip_map(subject, find_tip_map(subject, "index"));
  EXPECT_EQ(statics.R.row(0), Eigen::RowVector4d(1, 2, 3, 0.1));
  EXPECT_EQ(statics.W.col(3), Eigen::Vector3d::UnitY());
  EXPECT_EQ(moment_rows(subject.tip_maps[0]), std::vector<std::string>{"ty"});
}

TEST(PublishedMap, TakesUnstatedLimitsAsInfinite) {
  const Subject subject = sample();
  const TipStatics statics = statics_from_tip_map(subject, subject.tip_maps[0]);
  EXPECT_EQ(statics.max_tension[0], 5);
  EXPECT_TRUE(std::isinf(statics.max_tension[1]));
}

TEST(PublishedMap, KeepsAMuscleThatCannotPullAtZero) {
  Subject subject = sample();
  subject.muscles[0].max_force = 0;
  EXPECT_EQ(statics_from_tip_map(subject, subject.tip_maps[0]).max_tension[0], 0);
}

TEST(PublishedMap, NeedsAllThreeForces) {
  Subject subject = sample();
  subject.tip_maps[0].rows[1] = "tz";
  try {
    (void)statics_from_tip_map(subject, subject.tip_maps[0]);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "tip map 'm' of subject 'sample' has no row 'Fz'; forces need Fx, Fy and Fz");
  }
}

TEST(PublishedMap, NamesTheMapsThereAre) {
  try {
    (void)find_tip_map(sample(), "index", "n");
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "digit 'index' of subject 'sample' has no tip map 'n'; there are m");
  }
}

}  // namespace
}  // namespace thenar
