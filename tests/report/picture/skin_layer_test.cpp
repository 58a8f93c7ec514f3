// Tests for report/picture/skin_layer.cpp, and for the words of axes in digit_layers.cpp.

#include "report/picture/skin_layer.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/units.h"
#include "report/picture/digit_layers.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

/// A finger bent by 40 degrees at every joint.
class FingerSkin : public testing::Test {
 protected:
  const Subject subject_ = read_subject(kData + "/subjects/an_chao_middle.toml");
  const TendonDigit digit_ = build_tendon_digit(subject_, "middle");
  const TreeState<double> state_ = pose_tree(
      digit_.model.tree, Eigen::VectorXd::Constant(digit_.model.coordinates, 40 * kDegree).eval());
  MeshTable meshes_;
};

TEST_F(FingerSkin, CoversEachPhalanxAndIsSeenThrough) {
  const Json layer = skin_layer({subject_, digit_, state_}, meshes_);
  ASSERT_EQ(layer["items"].size(), 3u);
  for (const Json& item : layer["items"]) EXPECT_LT(item["opacity"].get<double>(), 0.5);
}

TEST_F(FingerSkin, MovesWithItsLinks) {
  const Json layer = skin_layer({subject_, digit_, state_}, meshes_);
  // The last item is that of the last link, which moves farthest.
  const Json& tip = layer["items"].back();
  const Pose<double>& X = state_.back().X;
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(tip["position"][i].get<double>(), X.p[i] / kMm, 1e-6);
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(tip["rotation"][i][j].get<double>(), X.R(i, j), 1e-9);
  }
}

TEST_F(FingerSkin, HasANailOnTheFingertipAlone) {
  const Json layer = skin_layer({subject_, digit_, state_}, meshes_);
  std::vector<bool> colored;
  for (const Json& item : layer["items"])
    colored.push_back(meshes_.json()[item["mesh"].get<std::string>()].contains("colors"));
  EXPECT_EQ(colored, (std::vector<bool>{false, false, true}));
}

// A finger of two bones has no anatomy to lay a skin on, and is drawn without.
TEST_F(FingerSkin, IsLeftOutWhereBonesAreMissing) {
  Subject stump = subject_;
  stump.digits.front().name = "other";
  EXPECT_TRUE(skin_layer({stump, digit_, state_}, meshes_).is_null());
  Json layers = Json::array();
  add_skin({stump, digit_, state_}, meshes_, layers);
  EXPECT_TRUE(layers.empty());
}

TEST(AxisWords, NameDirectionsOfADigit) {
  EXPECT_EQ(axis_words(Eigen::Matrix3d::Identity()), Json({"proximal", "dorsal", "radial"}));
  // Columns proximal = -x, dorsal = z, radial = -y.
  Eigen::Matrix3d turned;
  turned << -1, 0, 0, 0, 0, -1, 0, 1, 0;
  EXPECT_EQ(axis_words(turned), Json({"distal", "ulnar", "dorsal"}));
}

TEST(AxisWords, AreSilentAboutDirectionsBetweenAxes) {
  const Eigen::Matrix3d half =
      Eigen::AngleAxisd(45 * kDegree, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_EQ(axis_words(half), Json({"", "", "radial"}));
}

}  // namespace
}  // namespace thenar
