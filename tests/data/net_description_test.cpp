// Tests for data/io/net_description.cpp.

#include "data/io/net_description.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

// A net of one band and one muscle; a test breaks one line of it.
const std::string kGoodNet = R"(name = "small"
source = "Dogadov2017"
[bone_lengths]
metacarpal_mm = 60
proximal_mm = 40
middle_mm = 25
distal_mm = 18
[extensor_heights]
MCP_mm = 9
PIP_mm = 6
DIP_mm = 4
[[surface]]
name = "head"
shape = "sphere"
bone = "proximal"
along = 1
radius_mm = 6
[[surface]]
name = "shaft"
shape = "capsule"
bone = "proximal"
along = 0.5
axis = "bone"
radius_mm = 4
half_length_mm = 15
[[node]]
name = "insertion"
kind = "bone"
bone = "middle"
along = 0.2
angle_deg = 90
height_mm = 5
[[node]]
name = "knot"
kind = "floating"
bone = "proximal"
along = 0.5
height_mm = 7
surfaces = ["shaft"]
[[band]]
name = "slip"
from = "insertion"
to = "knot"
modulus_MPa = 100
area_mm2 = 1.5
over = "head"
[[muscle]]
role = "EDC"
names = ["EDC", "EDC3"]
exit = "metacarpal"
pulls = [{node = "knot", share = 0.75}]
[slips]
central = ["slip"]
)";

std::string net_refusal(const std::string& from, const std::string& to) {
  std::string text = kGoodNet;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    (void)parse_net(text, "net.toml");
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

TEST(Net, ReadsPlacesInSi) {
  const NetDescription net = parse_net(kGoodNet, "net.toml");
  EXPECT_DOUBLE_EQ(net.bone_length.at(BoneRole::kMiddle), 0.025);
  EXPECT_DOUBLE_EQ(net.height.at(FingerJoint::kPip), 0.006);
  EXPECT_EQ(net.nodes[0].place.bone, BoneRole::kMiddle);
  EXPECT_DOUBLE_EQ(net.nodes[0].place.angle, 90 * kDegree);
  EXPECT_TRUE(net.nodes[1].floating);
}

// 100 MPa on 1.5 mm^2 is 150 N per unit strain.
TEST(Net, TakesStiffnessFromModulusAndArea) {
  EXPECT_NEAR(parse_net(kGoodNet, "net.toml").bands[0].EA, 150, 1e-9);
}

TEST(Net, NamesUnknownNode) {
  EXPECT_EQ(net_refusal("to = \"knot\"", "to = \"knob\"").rfind("net.toml:43: ", 0), 0U)
      << net_refusal("to = \"knot\"", "to = \"knob\"");
}

// Lines as counted in kGoodNet, in which friction takes the third.
TEST(Net, RefusesNumbersOutOfRangeAtTheirLines) {
  const std::string slips = net_refusal("[bone_lengths]", "friction = 5\n[bone_lengths]");
  EXPECT_EQ(slips.rfind("net.toml:3: ", 0), 0U) << slips;
  EXPECT_NE(slips.find("in 0..1, got 5"), std::string::npos) << slips;
  const std::string far = net_refusal("along = 0.2", "along = 20");
  EXPECT_EQ(far.rfind("net.toml:30: ", 0), 0U) << far;
  EXPECT_NE(far.find("wanted 'along' in -1..2 bone lengths, got 20"), std::string::npos) << far;
  EXPECT_EQ(net_refusal("along = 1\n", "along = -1.5\n").rfind("net.toml:16: ", 0), 0U);
  EXPECT_EQ(net_refusal("along = 0.2", "along = -0.3"), "");
}

TEST(Net, RefusesBandOverCapsule) {
  EXPECT_NE(net_refusal("over = \"head\"", "over = \"shaft\"").find("'shaft' is a capsule"),
            std::string::npos);
}

TEST(Net, RefusesSharesAboveOne) {
  EXPECT_NE(net_refusal("share = 0.75", "share = 0.75}, {node = \"knot\", share = 0.5")
                .find("wanted shares of at most 1 in all, got 1.25"),
            std::string::npos);
}

TEST(Net, RefusesBandFromNodeToItself) {
  EXPECT_NE(net_refusal("to = \"knot\"", "to = \"insertion\"").find("begins and ends at node"),
            std::string::npos);
}

TEST(Net, RefusesBoneNodeOnSurface) {
  EXPECT_NE(net_refusal("height_mm = 5\n", "height_mm = 5\nsurfaces = [\"head\"]\n")
                .find("only a floating node rests on surfaces"),
            std::string::npos);
}

TEST(Net, EveryFileReads) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(THENAR_DATA_DIR) + "/nets"))
    EXPECT_EQ(read_net(entry.path().string()).name, entry.path().stem().string());
}

// The source: 18 nodes, of which 4 are the exits of muscles, and 25 strings, of which 4 are
// muscles.
TEST(Net, DogadovHasTheSourcesCounts) {
  const NetDescription net = read_net(std::string(THENAR_DATA_DIR) + "/nets/dogadov2017.toml");
  EXPECT_EQ(net.nodes.size(), 14U);
  EXPECT_EQ(net.bands.size(), 21U);
  EXPECT_EQ(net.muscles.size(), 4U);
}

}  // namespace
}  // namespace thenar
