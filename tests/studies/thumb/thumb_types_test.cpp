// Tests for studies/thumb/thumb_types.cpp and data/io/axis_variability.cpp: thumbs made by hand,
// shares against a closed form, and Denavit-Hartenberg rows that give back the axes.

#include "studies/thumb/thumb_types.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/spatial.h"
#include "base/units.h"
#include "tests/data/axes_from_dh.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Axes of a thumb: CMC flexion and abduction, MCP flexion and abduction, IP.
enum DrawnAxis { kFirst, kSecond, kMcpFlexionAxis, kMcpAbductionAxis, kLast };

ThumbTypesInputs inputs() { return thumb_types_inputs(THENAR_DATA_DIR); }

DigitVariability variability_of(const ThumbTypesInputs& from) {
  return parse_variability(from.variability.text, from.variability.path);
}

MeanThumb mean_of(const DigitVariability& variability) {
  const ThumbTypesInputs from = inputs();
  return mean_thumb(variability, parse_subject(from.subject.text, from.subject.path));
}

/// A straight thumb along -x, dorsal y, radial z, by hand: lengths in metres.
MeanThumb straight_thumb() {
  MeanThumb mean;
  const Vector3d y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  mean.axes = {{{0, 0, 0}, z},
               {{-0.005, 0, 0}, y},
               {{-0.045, 0, 0}, z},
               {{-0.043, 0, 0}, y},
               {{-0.080, 0, 0}, z}};
  mean.along.assign(5, -Vector3d::UnitX());
  mean.spread.resize(5);
  mean.tip.p = {-0.11, 0, 0};
  mean.mcp_flexion = kMcpFlexionAxis;
  mean.mcp_abduction = kMcpAbductionAxis;
  mean.first = kSecond;
  mean.second = kMcpFlexionAxis;
  return mean;
}

// The flexion axis lies 2 mm distal of the abduction axis; moved 3 mm proximally it does not.
TEST(ThumbTypes, OrderIsThatAlongTheDigit) {
  const MeanThumb mean = straight_thumb();
  std::vector<AxisLine> axes = mean.axes;
  EXPECT_TRUE(classify_thumb(mean, axes).flexion_distal);
  axes[kMcpFlexionAxis].point.x() += 0.003;
  EXPECT_FALSE(classify_thumb(mean, axes).flexion_distal);
  // Any other point and either sense of an axis describe the same thumb.
  axes[kMcpFlexionAxis].point.z() += 0.02;
  axes[kMcpAbductionAxis].direction *= -1;
  EXPECT_FALSE(classify_thumb(mean, axes).flexion_distal);
}

// Axes y + c z and z, 4 cm apart along x: their common normal is along x alone. With z + s x in
// place of z it is square to both, n = (1, 0, 0) - .. ; its radial part has the sign of s for a
// normal that runs along -x: n is parallel to y x (z + s x) = x - s z, and n.x < 0.
TEST(ThumbTypes, SecondCriterionIsTheSideOfTheNormal) {
  const MeanThumb mean = straight_thumb();
  for (const double s : {0.1, -0.1}) {
    std::vector<AxisLine> axes = mean.axes;
    axes[kMcpFlexionAxis].direction = Vector3d(s, 0, 1).normalized();
    EXPECT_EQ(classify_thumb(mean, axes).toward, s > 0);
    // The length of the normal's radial part: 40 mm, seen along x - s z, times the part along z.
    EXPECT_NEAR(normal_component(axes[kSecond], axes[kMcpFlexionAxis], Vector3d::UnitZ()),
                0.040 * s / (1 + s * s), 1e-15);
  }
}

// Without shifts across, both axes pass through the bone's line, so that tilts cannot change their
// order: the share is Phi((m_FE - m_AA) / sqrt(s_FE^2 + s_AA^2)).
TEST(ThumbTypes, OrderHasItsClosedForm) {
  ThumbTypesInputs from = inputs();
  for (std::size_t at; (at = from.variability.text.find("across_sd_mm = 2")) != std::string::npos;)
    from.variability.text.replace(at, 16, "across_sd_mm = 0");
  from.variability.text.replace(from.variability.text.find("across_sd_mm = 1"), 16,
                                "across_sd_mm = 0");
  ThumbTypesSettings settings;
  settings.draws = 20000;
  const ThumbTypes types = study_thumb_types(from, settings);
  const double p = 0.5 * std::erfc(-0.04 / std::hypot(0.05, 0.13) / std::sqrt(2.0));
  EXPECT_NEAR(types.flexion_distal_by_places, p, 1e-12);
  // Four standard errors of a share.
  const double share = static_cast<double>(types.flexion_distal) / types.draws;
  EXPECT_NEAR(share, p, 4 * std::sqrt(p * (1 - p) / types.draws));
}

TEST(ThumbTypes, CountsEveryDrawOnce) {
  ThumbTypesSettings settings;
  settings.draws = 700;
  const ThumbTypes types = study_thumb_types(inputs(), settings);
  EXPECT_TRUE(types.complete);
  int all = 0;
  for (const ThumbTypeShare& share : types.types) {
    EXPECT_EQ(share.type.index(), &share - types.types.data());
    all += share.count;
  }
  EXPECT_EQ(all, 700);
  EXPECT_EQ(types.types[0].count + types.types[1].count, types.flexion_distal);
}

// A share is the quotient of two whole numbers, rounded once, and so never beyond 1.
TEST(ThumbTypes, SharesOfNormalsAreQuotients) {
  ThumbTypesSettings settings;
  settings.draws = 700;
  for (const NormalShares& normal : study_thumb_types(inputs(), settings).normals)
    for (const double share : normal.toward) EXPECT_EQ(share, std::round(700 * share) / 700);
}

// A thumb is a function of the seed and its number: no thread and no batch can change it.
TEST(ThumbTypes, DrawsDependOnSeedAndNumberAlone) {
  const MeanThumb mean = mean_of(variability_of(inputs()));
  ThumbTypesSettings settings;
  settings.draws = 600;
  settings.seed = 3;
  const ThumbTypes types = study_thumb_types(inputs(), settings);
  std::array<int, 4> counts{};
  for (int number = 599; number >= 0; --number)
    ++counts[static_cast<std::size_t>(classify_thumb(mean, draw_thumb(mean, 3, number)).index())];
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(counts[i], types.types[i].count);
}

// Tilts of sd s in two directions: the mean angle from the mean axis is s sqrt(pi / 2), which is
// where the sds of the CMC axes in the data come from (9 and 22 degrees of [Chang2008]).
TEST(ThumbTypes, CmcAxesDeviateAsPublished) {
  const MeanThumb mean = mean_of(variability_of(inputs()));
  const int draws = 4000;
  double flexion = 0, abduction = 0;
  for (int number = 0; number < draws; ++number) {
    const std::vector<AxisLine> axes = draw_thumb(mean, 1, number);
    const auto angle = [&](std::size_t i) {
      return std::acos(axes[i].direction.dot(mean.axes[i].direction)) / draws;
    };
    flexion += angle(kFirst);
    abduction += angle(kSecond);
  }
  // Four standard errors: the sd of one angle is about half of its mean.
  EXPECT_NEAR(degrees(flexion), 9, 4 * 4.7 / std::sqrt(draws));
  EXPECT_NEAR(degrees(abduction), 22, 4 * 11.5 / std::sqrt(draws));
}

// Rows with outward normals carry the same axes and the same tip, at any joint angles.
TEST(ThumbTypes, OutwardNormalsKeepAxesAndTip) {
  const MeanThumb mean = mean_of(variability_of(inputs()));
  for (int number = 0; number < 50; ++number) {
    const std::vector<AxisLine> axes = draw_thumb(mean, 2, number);
    const DhChain chain = with_normals_outwards(dh_from_axes(axes, mean.tip));
    EXPECT_NEAR(chain.rows.front().theta, 0, 1e-12);  // which the base carries
    const DhAxes found = axes_from_dh(chain.base, chain.rows);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      EXPECT_GE(chain.rows[i].a, 0);
      EXPECT_TRUE(matrix_near(found.axes[i].direction, axes[i].direction, 1e-12));
      // The true point lies on the axis found.
      const Vector3d apart = axes[i].point - found.axes[i].point;
      EXPECT_LT(apart.cross(axes[i].direction).norm(), 1e-12);
    }
    // Bent: hinges in turn, and the product of rows with theta + q.
    Pose<double> by_hinges, by_rows = chain.base;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const double q = 0.2 + 0.1 * static_cast<double>(i);
      const Eigen::Matrix3d R = rotation_about(axes[i].direction, q);
      by_hinges = by_hinges * Pose<double>{R, axes[i].point - R * axes[i].point};
      DhRow row = chain.rows[i];
      row.theta += q;
      by_rows = by_rows * dh_motion(row);
    }
    const Pose<double> tip = by_hinges * mean.tip, same = by_rows * chain.tool;
    EXPECT_TRUE(matrix_near(same.p, tip.p, 1e-12));
    EXPECT_TRUE(matrix_near(same.R, tip.R, 1e-12));
  }
}

// In the mean thumb the abduction axis lies 4 % of the metacarpal nearer to its base.
TEST(ThumbTypes, MeanThumbHasTheOrderOfHollister) {
  const MeanThumb mean = mean_of(variability_of(inputs()));
  EXPECT_TRUE(classify_thumb(mean, mean.axes).flexion_distal);
  EXPECT_NEAR((mean.axes[kMcpFlexionAxis].point - mean.axes[kMcpAbductionAxis].point).norm(),
              0.04 * 0.0477, 1e-15);
}

TEST(ThumbTypes, NamesWhatIsMissing) {
  DigitVariability variability = variability_of(inputs());
  variability.axes[kLast].joint = "IP9";
  EXPECT_THROW((void)mean_of(variability), InputError);
  ThumbTypesSettings settings;
  settings.draws = 0;
  EXPECT_THROW((void)study_thumb_types(inputs(), settings), InputError);
}

TEST(AxisVariability, SaysWhichNumbersAreAssumed) {
  const DigitVariability variability = variability_of(inputs());
  EXPECT_EQ(variability.axes.at(kMcpAbductionAxis).assumed.front(), "along_sd_ratio");
  EXPECT_NEAR(variability.axes.at(kMcpAbductionAxis).along_sd, 0.13 * 0.0477, 1e-15);
  // A number that is not there cannot be assumed.
  const std::string text =
      "name = \"a\"\nmean_subject = \"b\"\nsource = \"Chang2008\"\n"
      "[second]\nfirst = \"c\"\nsecond = \"d\"\ntoward = \"radial\"\n"
      "[[axis]]\njoint = \"c\"\nbone = \"e\"\nbone_length_mm = 1\nalong_sd_ratio = 0.1\n"
      "across_sd_mm = 1\ntilt_sd_deg = 1\nassumed = [\"length\"]\n";
  EXPECT_THROW((void)parse_variability(text, "text"), DataError);
}

}  // namespace
}  // namespace thenar
