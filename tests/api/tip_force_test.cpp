// Tests for api/tip_force.cpp.

#include "api/tip_force.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"

#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TipForceRequest flexed_middle_finger() {
  TipForceRequest request;
  request.digit.subject = "synek2019_middle";
  request.digit.data = kData;
  request.digit.posture = {{{"MCP3_FE", 40}, {"PIP3", 55}, {"DIP3", 35}}, {}, PostureUnit::kTyped};
  request.tension = {{"FDP", 10}};
  return request;
}

// The balance is linear: twice the tension, twice the force.
TEST(AskTipForce, DoublesWithTheTension) {
  TipForceRequest request = flexed_middle_finger();
  const Eigen::Vector3d once = compute_tip_force(request).points.front().force;
  request.tension["FDP"] = 20;
  EXPECT_TRUE(matrix_near(compute_tip_force(request).points.front().force, 2 * once, 1e-12));
}

TEST(AskTipForce, AnswersAGridPostureByPosture) {
  TipForceRequest request = flexed_middle_finger();
  const Eigen::Vector3d alone = compute_tip_force(request).points.front().force;
  request.digit.vary = {{"DIP3", 30, 40, 5}};
  const TipForceResult answer = compute_tip_force(request);
  ASSERT_EQ(answer.points.size(), 3u);
  EXPECT_TRUE(matrix_near(answer.points[1].force, alone, 1e-12));
}

TEST(AskTipForce, KeepsWhatIsDoneWhenStopped) {
  TipForceRequest request = flexed_middle_finger();
  request.digit.vary = {{"DIP3", 10, 40, 5}};
  int left = 2;
  Progress progress;
  progress.stop_requested = [&] { return left-- == 0; };
  const TipForceResult answer = compute_tip_force(request, progress);
  EXPECT_EQ(answer.points.size(), 2u);
  EXPECT_EQ(answer.outcome.done, 2u);
  EXPECT_EQ(answer.outcome.asked, 7u);
}

/// The index finger of the whole hand of [Mirakhorlo2016], pulled by its deep flexor and the
/// lumbrical that rides on it.
TipForceRequest pulled_index_finger() {
  TipForceRequest request;
  request.digit.subject = "mirakhorlo2016";
  request.digit.digit = "index";
  request.digit.data = kData;
  request.digit.posture = {{{"MCP2_FE", 60}, {"PIP2", 60}, {"DIP2", 30}}, {}, PostureUnit::kTyped};
  request.tension = {{"FDP2", 10}, {"LU1", 5}};
  request.digit.passive = PassiveMoments::kOff;
  return request;
}

// Proximal, dorsal, radial [N], by a program of its own: lengths of strings over cylinders in
// closed form, the lumbrical's origin at its place along the flexor, arms as differences of
// lengths, along the axes of the tip as the file rounds them, to six digits.
TEST(AskTipForce, WrapsWhereTheSubjectStatesSurfaces) {
  const TipForceResult answer = compute_tip_force(pulled_index_finger());
  const TipForcePoint& point = answer.points.front();
  EXPECT_TRUE(matrix_near(Eigen::Vector3d(point.tip_axes->transpose() * point.force),
                          Eigen::Vector3d(-1.909196, -0.292375, 0.511426), 5e-6));
  EXPECT_NE(answer.built.find("wrapped"), std::string::npos);
}

// Straight paths leave the lumbrical's origin on the metacarpal: it has no arm at PIP and DIP.
TEST(AskTipForce, RunsStraightWhereThatIsAsked) {
  TipForceRequest request = pulled_index_finger();
  request.digit.path = Path::kViaPoint;
  const TipForcePoint point = compute_tip_force(request).points.front();
  EXPECT_TRUE(matrix_near(Eigen::Vector3d(point.tip_axes->transpose() * point.force),
                          Eigen::Vector3d(-2.22, -1.07, -0.26), 0.005));
}

TEST(AskTipForce, RefusesATensionThatNoTendonBears) {
  TipForceRequest request = flexed_middle_finger();
  request.tension["FDP"] = 1e6;
  EXPECT_EQ(message_of([&] { (void)compute_tip_force(request); }),
            "wanted a tension of 'FDP' up to 10000 N, got 1000000 N: no tendon withstands it");
}

TEST(AskTipForce, RefusesAHoldOfAMap) {
  TipForceRequest request = flexed_middle_finger();
  request.digit = {};
  request.digit.subject = "valero_cuevas_index";
  request.digit.data = kData;
  request.hold = TipConstraint::kRigid;
  EXPECT_NE(message_of([&] { (void)compute_tip_force(request); }).find("got a rigid one"),
            std::string::npos);
}

/// A finger without abduction: all its axes are parallel.
TipForceRequest planar_index_finger(TipConstraint hold) {
  TipForceRequest request;
  request.digit.subject = "an_chao_index";
  request.digit.data = kData;
  request.digit.posture = {{{"MCP2_FE", 35}, {"PIP2", 45}, {"DIP2", 25}}, {}, PostureUnit::kTyped};
  request.digit.frozen = {{{"MCP2_AA", 0}}, {}, PostureUnit::kTyped};
  request.tension = {{"FDP", 10}};
  request.hold = hold;
  return request;
}

// What a degree changes is what differences of the force itself say, and the plane is no
// singularity.
TEST(AskTipForce, KnowsThePlaneOfParallelAxes) {
  for (const TipConstraint hold : {TipConstraint::kPinned, TipConstraint::kRigid}) {
    TipForceRequest request = planar_index_finger(hold);
    const TipForcePoint at = compute_tip_force(request).points.front();
    EXPECT_TRUE(at.planar);
    EXPECT_FALSE(at.singular);
    EXPECT_FALSE(at.minimum_norm);
    EXPECT_TRUE(std::isfinite(at.condition));
    EXPECT_NEAR((at.tip_axes->transpose() * at.force)[2], 0, 1e-12);
    constexpr double kStep = 0.0078125;  // [deg], exact in binary
    request.digit.vary = {{"PIP2", 45 - kStep, 45 + kStep, 2 * kStep}};
    const TipForceResult near = compute_tip_force(request);
    ASSERT_EQ(near.points.size(), 2U);
    const double slope =
        (near.points[1].force - near.points[0].force).norm() / (2 * kStep * kDegree);
    const auto& rows = near.rows;
    const auto pip = std::find(rows.begin(), rows.end(), "PIP2") - rows.begin();
    EXPECT_NEAR(at.change[pip], slope, 1e-5 * slope);  // the third derivative of a step
  }
}

}  // namespace
}  // namespace thenar
