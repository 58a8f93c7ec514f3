// Tests for tendons/net/build_net.cpp, finger_frame.cpp and fit_slack.cpp.

#include "tendons/net/build_net.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tendons/linear_tendons.h"
#include "tendons/net/fit_slack.h"
#include "tendons/net/net_statics.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Subject subject(const std::string& name) {
  return read_subject(kData + "/subjects/" + name + ".toml");
}
NetDescription net(const std::string& name) { return read_net(kData + "/nets/" + name + ".toml"); }

TendonDigit separate(const Subject& s, const std::string& digit) {
  return build_tendon_digit(s, digit, {Path::kViaPoint, Hood::kSeparate});
}

BuiltNet built(const std::string& subject_name, const std::string& digit,
               const std::string& net_name) {
  const Subject s = subject(subject_name);
  return build_net(s, separate(s, digit), net(net_name));
}

std::string refusal(const Subject& s, const std::string& digit, const NetDescription& plan) {
  try {
    (void)build_net(s, separate(s, digit), plan);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

// -- Fingers ----------------------------------------------------------------------------------

// A pull along one line has the moment  distance x |axis x direction|  about another; virtual work
// finds it by another way.
TEST(FingerFrame, HeightsAreTheStrandsMomentArms) {
  const Subject s = subject("an_chao_middle");
  const TendonDigit digit = separate(s, "middle");
  const FingerFrame frame = finger_frame(s, digit, net("winslow"));
  const VectorXd straight = VectorXd::Zero(4);
  const auto arms = strand_arms(digit.model, pose_tree(digit.model.tree, straight), straight);
  const auto height = [&](const std::string& strand, int joint) {
    const auto& names = digit.names.strands;
    const auto row = std::find(names.begin(), names.end(), strand) - names.begin();
    const auto& path = digit.model.paths[static_cast<std::size_t>(row)];
    const Vector3d u = (path[1].p - path[0].p).normalized();
    return -arms(row, joint) / Vector3d::UnitZ().cross(u).norm();
  };
  EXPECT_NEAR(frame.height[0], height("LE", 0), 1e-12);
  EXPECT_NEAR(frame.height[1], height("ES", 2), 1e-12);
  EXPECT_NEAR(frame.height[2], height("TE", 3), 1e-12);
}

TEST(FingerFrame, StraightFingerHasNoBendLeftAboutItsAxes) {
  const Subject s = subject("mirakhorlo2016");
  for (const char* name : {"index", "middle", "ring", "little"}) {
    const TendonDigit digit = separate(s, name);
    const FingerFrame frame = finger_frame(s, digit, net("winslow"));
    const TreeState<double> state = pose_tree(digit.model.tree, frame.straight);
    const auto now = [&](const FingerBone& bone) {
      return bone.link < 0 ? bone.along
                           : Vector3d(state[static_cast<std::size_t>(bone.link)].X.R * bone.along);
    };
    for (std::size_t b = 1; b < 3; ++b) {  // joints with one hinge
      const Vector3d axis = state[static_cast<std::size_t>(frame.bones[b + 1].link)].axis;
      EXPECT_NEAR(axis.dot(now(frame.bones[b]).cross(now(frame.bones[b + 1]))), 0, 1e-12)
          << name << b;
      EXPECT_GT(now(frame.bones[b]).dot(now(frame.bones[b + 1])), 0.9) << name << b;
    }
  }
}

TEST(FingerFrame, DorsalLiesOverTheExtensor) {
  const Subject s = subject("mirakhorlo2016");
  for (const char* name : {"index", "middle", "ring", "little"}) {
    const FingerFrame frame = finger_frame(s, separate(s, name), net("winslow"));
    for (const FingerBone& bone : frame.bones) {
      EXPECT_GT(bone.dorsal.z(), 0.5) << name;  // z is dorsal in this subject's frame
      EXPECT_GT(bone.radial.x(), 0.5) << name;  // x is radial
    }
  }
}

// -- Every finger -----------------------------------------------------------------------------

struct Case {
  const char *subject, *digit, *net;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.subject << " " << c.digit << " " << c.net;
}

class EveryFinger : public testing::TestWithParam<Case> {};

TEST_P(EveryFinger, RestsInTheStraightFinger) {
  const Case c = GetParam();
  const Subject s = subject(c.subject);
  const TendonDigit digit = separate(s, c.digit);
  const BuiltNet b = build_net(s, digit, net(c.net));
  const VectorXd load = VectorXd::Ones(static_cast<Eigen::Index>(b.net.muscles.size()));
  const NetEquilibrium rest =
      NetSolver(b.net).solve(pose_tree(digit.model.tree, b.frame.straight), {load, {}});
  EXPECT_EQ(rest.status, NetStatus::kBalanced) << rest.residual;
  for (int band : b.terminal) EXPECT_GT(rest.tension[band], 0.1);  // [N]
}

std::vector<Case> every_finger() {
  std::vector<Case> cases;
  for (const char* name : {"winslow", "dogadov2017", "chao_an", "extensor_hood"}) {
    for (const char* digit : {"index", "middle", "ring", "little"})
      cases.push_back({"mirakhorlo2016", digit, name});
    cases.push_back({"synek2019_middle", "middle", name});
    cases.push_back({"an_chao_middle", "middle", name});
    cases.push_back({"an_chao_index", "index", name});
  }
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Data, EveryFinger, testing::ValuesIn(every_finger()));

TEST(BuildNet, RefusesTheThumb) {
  EXPECT_EQ(refusal(subject("mirakhorlo2016"), "thumb", net("winslow")),
            "net 'winslow' is for fingers and cannot be used for the thumb");
}

TEST(BuildNet, NamesTheMuscleThatIsMissing) {
  NetDescription plan = net("winslow");
  plan.muscles[1].names = {"nobody"};
  plan.muscles[1].optional = false;
  EXPECT_EQ(refusal(subject("an_chao_middle"), "middle", plan),
            "net 'winslow' needs muscle 'RI' (nobody), and none crosses the middle of "
            "'an_chao_middle'");
}

// -- Size -------------------------------------------------------------------------------------

// Over the knuckle the extensor bends round a cylinder as high as the subject's own strand runs.
TEST(BuildNet, BentExtensorHasTheMeasuredArm) {
  const Subject s = subject("an_chao_middle");
  const TendonDigit digit = separate(s, "middle");
  const BuiltNet b = build_net(s, digit, net("winslow"));
  VectorXd q = b.frame.straight;
  q[0] += 40 * kDegree;
  VectorXd pull = VectorXd::Zero(4);
  pull[0] = 2;  // the extensor [N]
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  const NetEquilibrium rest = NetSolver(b.net).solve(state, {pull, {}});
  const VectorXd tau = net_torque(b.net, digit.model.tree, state, rest, 4);
  EXPECT_NEAR(tau[0], -2 * b.frame.height[0], 2e-5);  // [N m]; the run is 0.5 % longer than its
                                                      // projection across the axis at the most
}

/// A finger with the bones and extensor heights that a description's lengths belong to.
Subject reference_subject(const NetDescription& plan) {
  const auto mm = [](double m) { return 1e3 * m; };
  const double dp = mm(plan.bone_length.at(BoneRole::kDistal));
  const double mp = dp + mm(plan.bone_length.at(BoneRole::kMiddle));
  const double pp = mp + mm(plan.bone_length.at(BoneRole::kProximal));
  const double h_mcp = mm(plan.height.at(FingerJoint::kMcp));
  const double h_pip = mm(plan.height.at(FingerJoint::kPip));
  const double h_dip = mm(plan.height.at(FingerJoint::kDip));
  std::string text = "name = 'reference'\nside = 'right'\nbase = 'MC'\nsource = 'Dogadov2017'\n";
  for (const char* segment : {"MC", "PP", "MP", "DP"})
    text += fmt::format("[[segment]]\nname = '{}'\n", segment);
  const auto joint = [&](const char* name, const char* parent, const char* child, double x) {
    text += fmt::format(
        "[[joint]]\nname = '{}'\nparent = '{}'\nchild = '{}'\ndirection = [0, 0, 1]\n"
        "point_mm = [{}, 0, 0]\n",
        name, parent, child, x);
  };
  joint("MCP", "MC", "PP", pp);
  joint("PIP", "PP", "MP", mp);
  joint("DIP", "MP", "DP", dp);
  text += fmt::format(
      "[[strand]]\nname = 'EDC'\npath = [\n"
      "{{segment = 'DP', point_mm = [{0}, {3}, 0]}}, {{segment = 'MP', point_mm = [{4}, {3}, "
      "0]}},\n"
      "{{segment = 'MP', point_mm = [{5}, {6}, 0]}}, {{segment = 'PP', point_mm = [{7}, {6}, "
      "0]}},\n"
      "{{segment = 'PP', point_mm = [{8}, {9}, 0]}}, {{segment = 'MC', point_mm = [{10}, {9}, "
      "0]}},\n"
      "]\n",
      dp - 2, 0, 0, h_dip, dp + 2, mp - 2, h_pip, mp + 2, pp - 2, h_mcp, pp + 2);
  text +=
      "[[muscle]]\nname = 'EDC'\n[[digit]]\nname = 'middle'\ntip_segment = 'DP'\n"
      "tip_mm = [0, 0, 0]\nproximal = [1, 0, 0]\ndorsal = [0, 1, 0]\n";
  return parse_subject(text, "reference.toml");
}

TEST(BuildNet, KeepsStatedSlackLengthsInTheReferenceFinger) {
  const NetDescription plan = net("dogadov2017");
  const Subject s = reference_subject(plan);
  const BuiltNet b = build_net(s, separate(s, "middle"), plan);
  EXPECT_NEAR(b.frame.scale, 1, 1e-12);
  for (std::size_t k = 0; k < plan.bands.size(); ++k)
    EXPECT_NEAR(b.net.bands[k].slack, plan.bands[k].slack, 1e-12) << plan.bands[k].name;
}

// -- Slack lengths ----------------------------------------------------------------------------

TEST(BuildNet, FittedBandsAreTautAndStrainAlikeInTheStraightFinger) {
  const Subject s = subject("an_chao_middle");
  const TendonDigit digit = separate(s, "middle");
  const NetDescription plan = net("winslow");
  const BuiltNet b = build_net(s, digit, plan);
  VectorXd load(static_cast<Eigen::Index>(b.pulls.size()));
  for (std::size_t p = 0; p < b.pulls.size(); ++p)
    load[static_cast<Eigen::Index>(p)] = b.pulls[p].share;
  const NetEquilibrium rest =
      NetSolver(b.net).solve(pose_tree(digit.model.tree, b.frame.straight), {load, {}});
  const auto strain = [&](int band) {
    return rest.length[band] / b.net.bands[static_cast<std::size_t>(band)].slack - 1;
  };
  for (std::size_t k = 0; k < plan.bands.size(); ++k) {
    EXPECT_GT(strain(static_cast<int>(k)), -1e-5) << plan.bands[k].name;
    if (plan.bands[k].strains_like.empty()) continue;
    const int like = band_index(b.net, plan.bands[k].strains_like);
    EXPECT_NEAR(strain(static_cast<int>(k)), strain(like), 1e-5) << plan.bands[k].name;
  }
}

TEST(Cut, TakesOneBandAndKeepsTheSlips) {
  const BuiltNet whole = built("an_chao_middle", "middle", "winslow");
  const BuiltNet left = cut(whole, "central_slip");
  EXPECT_EQ(left.net.bands.size(), whole.net.bands.size() - 1);
  EXPECT_TRUE(left.central.empty());
  for (std::size_t k = 0; k < whole.radial.size(); ++k)
    EXPECT_EQ(left.net.bands[static_cast<std::size_t>(left.radial[k])].name,
              whole.net.bands[static_cast<std::size_t>(whole.radial[k])].name);
}

TEST(Cut, RefusesUnknownBandsAndMuscles) {
  const BuiltNet b = built("an_chao_middle", "middle", "winslow");
  EXPECT_THROW((void)cut(b, "no such band"), InputError);
  EXPECT_THROW((void)cut(b, "EDC"), InputError);
}

}  // namespace
}  // namespace thenar
