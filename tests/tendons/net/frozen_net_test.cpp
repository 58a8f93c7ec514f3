// A net on a finger with frozen joints is the net of the finger that can bend them.

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/digit_sweep.h"
#include "tendons/net/net_tendons.h"
#include "tendons/net/posture_sweep.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using Angles = std::map<std::string, double>;

constexpr double kSame = 1e-6;  // [N]

struct FrozenCase {
  const char *subject, *digit, *net;
};
void PrintTo(const FrozenCase& c, std::ostream* out) {
  *out << c.subject << " " << c.digit << " " << c.net;
}

/// A finger with some joints frozen, at rest under a pull of its extensors and lumbrical.
DigitPoint at_rest(const FrozenCase& c, const Angles& frozen, const Angles& posed) {
  const Subject subject = read_subject(kData + "/subjects/" + c.subject + ".toml");
  const NetDescription plan = read_net(kData + "/nets/" + c.net + ".toml");
  TendonOptions options;
  options.frozen = frozen;
  const auto tendons = build_net_tendons(subject, c.digit, options, plan);
  const TendonNames& names = tendons->digit().names;
  VectorXd t = VectorXd::Zero(static_cast<Eigen::Index>(names.muscles.size()));
  for (std::size_t m = 0; m < names.muscles.size(); ++m) {
    if (names.muscles[m].rfind("ED", 0) == 0) t[static_cast<Eigen::Index>(m)] = 2.9;
    if (names.muscles[m].rfind("LU", 0) == 0) t[static_cast<Eigen::Index>(m)] = 0.4;
  }
  VectorXd q = VectorXd::Zero(static_cast<Eigen::Index>(names.coordinates.size()));
  for (std::size_t j = 0; j < names.coordinates.size(); ++j)
    q[static_cast<Eigen::Index>(j)] = posed.at(names.coordinates[j]);
  return sweep_digit(*tendons, {q}, t).front();
}

class FrozenNet : public testing::TestWithParam<FrozenCase> {};

TEST_P(FrozenNet, HasTheTensionsOfTheFreeFinger) {
  const Subject subject = read_subject(kData + "/subjects/" + GetParam().subject + ".toml");
  // Natural flexion, and the knuckle to one side.
  Angles posed;
  std::vector<std::string> joints;
  for (const std::string& joint : build_tendon_digit(subject, GetParam().digit).names.coordinates) {
    posed[joint] = (joint.find("AA") != std::string::npos ? 5
                    : joint.rfind("PIP", 0) == 0          ? 45
                    : joint.rfind("DIP", 0) == 0          ? 30
                    : joint.rfind("MCP", 0) == 0          ? 20
                                                          : 0) *
                   kDegree;
    joints.push_back(joint);
  }
  const DigitPoint free = at_rest(GetParam(), {}, posed);
  // All joints but one, and every joint alone.
  std::vector<Angles> cases{posed, posed};
  cases[0].erase(joints.front());
  cases[1].erase(joints.back());
  for (const std::string& joint : joints) cases.push_back({{joint, posed[joint]}});
  for (const Angles& frozen : cases) {
    const DigitPoint point = at_rest(GetParam(), frozen, posed);
    EXPECT_EQ(point.rest.status, free.rest.status) << frozen.begin()->first;
    EXPECT_LT((point.rest.tension - free.rest.tension).cwiseAbs().maxCoeff(), kSame)
        << frozen.begin()->first;
    EXPECT_NEAR(point.pull.slips.central, free.pull.slips.central, kSame);
    EXPECT_NEAR(point.pull.slips.terminal, free.pull.slips.terminal, kSame);
    // What is left to move feels the same torque.
    if (frozen.size() > 1) continue;
    VectorXd others(static_cast<Eigen::Index>(joints.size()) - 1);
    for (std::size_t j = 0, k = 0; j < joints.size(); ++j)
      if (frozen.count(joints[j]) == 0)
        others[static_cast<Eigen::Index>(k++)] = free.pull.tau[static_cast<Eigen::Index>(j)];
    EXPECT_LT((point.pull.tau - others).cwiseAbs().maxCoeff(), 1e-8) << frozen.begin()->first;
  }
}

std::vector<FrozenCase> frozen_cases() {
  std::vector<FrozenCase> cases;
  for (const char* name : {"winslow", "dogadov2017", "chao_an", "extensor_hood"}) {
    for (const char* hand : {"mirakhorlo2016", "human_hand"})
      for (const char* digit : {"index", "middle", "ring", "little"})
        cases.push_back({hand, digit, name});
    cases.push_back({"synek2019_middle", "middle", name});
    cases.push_back({"an_chao_middle", "middle", name});
    cases.push_back({"an_chao_index", "index", name});
  }
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Data, FrozenNet, testing::ValuesIn(frozen_cases()));

}  // namespace
}  // namespace thenar
