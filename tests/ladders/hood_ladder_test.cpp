// Wherever what a poorer hood leaves out does not matter, neighbouring rungs agree.

#include <random>

#include <gtest/gtest.h>

#include "tendons/linear_tendons.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/net_tendons.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

Subject subject(const std::string& name) {
  return read_subject(std::string(THENAR_DATA_DIR) + "/subjects/" + name + ".toml");
}

NetDescription net(const std::string& name) {
  return read_net(std::string(THENAR_DATA_DIR) + "/nets/" + name + ".toml");
}

std::unique_ptr<DigitTendons> rung(const Subject& s, Hood hood,
                                   const NetDescription* description = nullptr) {
  TendonOptions options;
  options.hood = hood;
  return build_digit_tendons(s, "middle", options, description);
}

/// Angles between a hyperextended and a bent finger [rad] (coordinates).
VectorXd any_posture(std::mt19937& rng, int coordinates) {
  std::uniform_real_distribution<double> angle(-0.3, 1.0);
  return VectorXd::NullaryExpr(coordinates, [&] { return angle(rng); });
}

VectorXd any_tension(std::mt19937& rng, std::size_t muscles) {
  std::uniform_real_distribution<double> tension(0.1, 10);  // [N]
  return VectorXd::NullaryExpr(static_cast<Eigen::Index>(muscles), [&] { return tension(rng); });
}

// Tolerance of a torque: the solver's, 1e-9 N, on arms of 1 cm, for a handful of nodes [N m].
constexpr double kTorque = 1e-10;

// -- Floating net and separate tendons --------------------------------------------------------

/// Three slips that run side by side to insertions of their own, and the cross bands between them.
const std::string kSlips = R"(name = "slips"
source = "Dogadov2017"
[bone_lengths]
metacarpal_mm = 64.6
proximal_mm = 47.02
middle_mm = 28.83
distal_mm = 19.02
[extensor_heights]
MCP_mm = 9.17
PIP_mm = 5.57
DIP_mm = 3.96
[height_strands]
PIP = ["ES"]
DIP = ["TE"]
)";

struct Slip {
  std::string muscle;
  double angle;  // [deg]
};
const std::vector<Slip> kMuscles{{"EDC", 0}, {"RI", 60}, {"UI", -60}};

/// The net of `kSlips`, its slips two bands long.
std::string slips(bool crossed) {
  std::string text = kSlips;
  for (const Slip& slip : kMuscles)
    text += fmt::format(
        "[[node]]\nname = '{0} end'\nkind = 'bone'\nbone = 'proximal'\nalong = 0.2\nangle_deg = "
        "{1}\n"
        "height_mm = 6\nstrand = ['{2}']\npoint = 0\n"
        "[[node]]\nname = '{0} knot'\nkind = 'floating'\nbone = 'proximal'\nalong = 0.1\n"
        "angle_deg = {1}\nheight_mm = 7\n",
        slip.muscle, slip.angle, slip.muscle == "EDC" ? "LE" : slip.muscle);
  for (const Slip& slip : kMuscles)
    text += fmt::format("[[band]]\nname = '{0}'\nfrom = '{0} end'\nto = '{0} knot'\nEA_N = 100\n",
                        slip.muscle);
  if (crossed)
    text +=
        "[[band]]\nname = 'cross_r'\nfrom = 'EDC knot'\nto = 'RI knot'\nEA_N = 100\n"
        "[[band]]\nname = 'cross_u'\nfrom = 'EDC knot'\nto = 'UI knot'\nEA_N = 100\n";
  for (const Slip& slip : kMuscles)
    text += fmt::format(
        "[[muscle]]\nrole = '{0}'\nnames = ['{0}']\nexit = 'metacarpal'\n"
        "pulls = [{{node = '{0} knot'}}]\n",
        slip.muscle);
  return text;
}

TEST(HoodLadder, NetWithItsCrossBandsCutIsSeparateTendons) {
  const Subject finger = subject("an_chao_middle");
  const NetDescription uncrossed = parse_net(slips(false), "slips.toml");
  const auto separate = rung(finger, Hood::kSeparate);
  const auto floating = rung(finger, Hood::kFloatingNet, &uncrossed);
  std::mt19937 rng(1);
  for (int trial = 0; trial < 50; ++trial) {
    const VectorXd q = any_posture(rng, 4);
    const VectorXd t = any_tension(rng, separate->digit().names.muscles.size());
    const TendonTorque net_pull = floating->evaluate(q, t);
    EXPECT_EQ(net_pull.warning, "");
    EXPECT_TRUE(matrix_near(net_pull.tau, separate->evaluate(q, t).tau, kTorque));
    EXPECT_TRUE(matrix_near(net_pull.R, separate->evaluate(q, t).R, kTorque));
  }
}

// Cutting one band at a time leads down to the same rung as leaving them out.
TEST(HoodLadder, CuttingCrossBandsLeadsToTheUncrossedNet) {
  const Subject finger = subject("an_chao_middle");
  const auto separate = build_linear_tendons(finger, "middle", {Path::kViaPoint, Hood::kSeparate});
  const BuiltNet crossed =
      build_net(finger, separate->digit(), parse_net(slips(true), "slips.toml"));
  const NetTendons floating(
      build_linear_tendons(finger, "middle", {Path::kViaPoint, Hood::kSeparate}),
      cut(cut(crossed, "cross_r"), "cross_u"));
  std::mt19937 rng(2);
  const VectorXd q = any_posture(rng, 4);
  const VectorXd t = any_tension(rng, separate->digit().names.muscles.size());
  EXPECT_TRUE(matrix_near(floating.evaluate(q, t, {}).tau, separate->evaluate(q, t).tau, kTorque));
}

// What the test above would not see if cross bands did nothing.
TEST(HoodLadder, CrossBandsMatter) {
  const Subject finger = subject("an_chao_middle");
  const NetDescription crossed = parse_net(slips(true), "slips.toml");
  const auto separate = rung(finger, Hood::kSeparate);
  const auto floating = rung(finger, Hood::kFloatingNet, &crossed);
  const VectorXd q = VectorXd::Constant(4, 0.4), t = VectorXd::Constant(6, 3.0);
  EXPECT_GT((floating->evaluate(q, t).tau - separate->evaluate(q, t).tau).norm(), 1e-3);
}

// -- Floating net and fixed fractions ---------------------------------------------------------

TEST(HoodLadder, NetOfFixedFractionsIsFixedFractions) {
  const Subject finger = subject("synek2019_middle");
  const NetDescription chao_an = net("chao_an");
  const auto fractions = rung(finger, Hood::kFractions);
  const auto floating = rung(finger, Hood::kFloatingNet, &chao_an);
  std::mt19937 rng(3);
  for (int trial = 0; trial < 50; ++trial) {
    const VectorXd q = any_posture(rng, 4);
    // Half of them, as the terminal band strains by more than 10 % under all of some.
    const VectorXd t = 0.5 * any_tension(rng, fractions->digit().names.muscles.size());
    const TendonTorque net_pull = floating->evaluate(q, t), linear = fractions->evaluate(q, t);
    EXPECT_EQ(net_pull.warning, "");
    // The subject states its fractions with four digits, the net their products.
    EXPECT_TRUE(matrix_near(net_pull.tau, linear.tau, 1e-4 * t.sum() * 0.01));
    EXPECT_NEAR(net_pull.slips.terminal, linear.slips.terminal, 1e-4 * t.sum());
    EXPECT_NEAR(net_pull.slips.central, linear.slips.central, 1e-4 * t.sum());
  }
}

// -- Laws of every rung -----------------------------------------------------------------------

class EveryHood : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<DigitTendons> tendons(const Subject& finger) const {
    if (GetParam() == "separate") return rung(finger, Hood::kSeparate);
    if (GetParam() == "fractions") return rung(finger, Hood::kFractions);
    const NetDescription description = net(GetParam());
    return rung(finger, Hood::kFloatingNet, &description);
  }
};

// A bent finger, with bands in contact and some slack.
const VectorXd kPosture = (VectorXd(4) << 0.5, 0.05, 0.4, 0.3).finished();
const VectorXd kTension = (VectorXd(6) << 3, 5, 4, 2, 1, 2.5).finished();

TEST_P(EveryHood, ArmsAreTheSlopeOfTorqueByTension) {
  const auto digit = tendons(subject("an_chao_middle"));
  const TendonTorque pull = digit->evaluate(kPosture, kTension);
  ASSERT_EQ(pull.warning, "");
  constexpr double kStep = 1e-4;  // [N]
  for (Eigen::Index m = 0; m < kTension.size(); ++m) {
    VectorXd more = kTension, less = kTension;
    more[m] += kStep;
    less[m] -= kStep;
    const VectorXd slope = (digit->evaluate(kPosture, more, pull.nodes).tau -
                            digit->evaluate(kPosture, less, pull.nodes).tau) /
                           (2 * kStep);
    // Residuals of 1e-9 N on a step of 1e-4 N leave 1e-5 of an arm of 1 cm.
    EXPECT_TRUE(matrix_near(pull.R.row(m).transpose(), slope, 1e-6)) << m;
  }
}

TEST_P(EveryHood, NoTensionMakesNoTorque) {
  const auto digit = tendons(subject("an_chao_middle"));
  EXPECT_TRUE(
      matrix_near(digit->evaluate(kPosture, VectorXd::Zero(6)).tau, VectorXd::Zero(4), kTorque));
}

// Without a hood's elasticity and with it: torque times speed is what tendons and bands give off.
TEST_P(EveryHood, ConservesPower) {
  const auto digit = tendons(subject("an_chao_middle"));
  const TendonTorque pull = digit->evaluate(kPosture, kTension);
  const auto* with_net = dynamic_cast<const NetTendons*>(digit.get());
  const TendonModel<double>& model = digit->digit().model;
  const auto energy = [&](const VectorXd& q) {
    const TreeState<double> state = pose_tree(model.tree, q);
    VectorXd strand = strand_matrix(model, q) * kTension;
    double E = 0;
    if (with_net != nullptr) {
      E = with_net->rest(q, kTension, pull.nodes).energy;
      for (const NetMuscle& m : with_net->net().muscles) {
        E += m.to_net * kTension[m.muscle] * path_length(state, m.own_path);
        strand[model.pulls[static_cast<std::size_t>(m.muscle)]] -= m.to_net * kTension[m.muscle];
      }
    }
    for (std::size_t s = 0; s < model.paths.size(); ++s)
      E += strand[static_cast<Eigen::Index>(s)] * path_length(state, model.paths[s]);
    return E;
  };
  constexpr double kStep = 1e-5;  // [rad]
  for (int j = 0; j < 4; ++j) {
    const VectorXd dq = kStep * VectorXd::Unit(4, j);
    const double slope = (energy(kPosture + dq) - energy(kPosture - dq)) / (2 * kStep);
    EXPECT_NEAR(pull.tau[j], -slope, 1e-7) << j;  // [N m], of about 0.1
  }
}

INSTANTIATE_TEST_SUITE_P(Hoods, EveryHood,
                         testing::Values("separate", "fractions", "chao_an", "winslow",
                                         "dogadov2017", "extensor_hood"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace thenar
