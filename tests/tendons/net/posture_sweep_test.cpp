// Tests for tendons/net/posture_sweep.cpp.

#include "tendons/net/posture_sweep.h"

#include <gtest/gtest.h>

#include "tendons/net/build_tendons.h"
#include "tendons/net/digit_sweep.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

const VectorXd kSweepTension = (VectorXd(6) << 3, 5, 4, 2, 1, 2.5).finished();

std::unique_ptr<DigitTendons> finger_with_net() {
  const NetDescription winslow = read_net(kData + "/nets/winslow.toml");
  return build_net_tendons(read_subject(kData + "/subjects/an_chao_middle.toml"), "middle", {},
                           winslow);
}

std::vector<VectorXd> bending() {
  return postures_between(VectorXd::Zero(4), (VectorXd(4) << 0.5, 0, 1.2, 0.6).finished(), 6);
}

// One equilibrium a posture: what the tendons do is what they do where the point says it rests,
// to the last bit.
TEST(SweepDigit, SolvesEachPostureOnce) {
  const auto tendons = finger_with_net();
  const auto& net = dynamic_cast<const NetTendons&>(*tendons);
  for (const DigitPoint& point : sweep_digit(*tendons, bending(), kSweepTension)) {
    EXPECT_EQ(point.pull.nodes, point.rest.x);
    EXPECT_TRUE(matrix_near(point.pull.tau, net.torque(point.q, kSweepTension, point.rest), 0));
  }
}

TEST(SweepDigit, KeepsWhatIsDoneWhereItIsStopped) {
  const auto tendons = finger_with_net();
  int asked = 0;
  Progress progress;
  progress.stop_requested = [&] { return ++asked > 3; };
  EXPECT_EQ(sweep_digit(*tendons, bending(), kSweepTension, progress).size(), 3u);
}

}  // namespace
}  // namespace thenar
