// Tests for dynamics/human/tendon_group.cpp: which digits pull as one.

#include "dynamics/human/tendon_group.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dynamics/human/digit_pull.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/scene/measure_run.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/tendons/muscle/moving_samples.h"

namespace thenar {
namespace {

using Groups = std::vector<std::vector<int>>;

// Four digits in a row: each shares a muscle with the next.
const std::vector<std::vector<std::string>> kRow{{"a", "ab"}, {"ab", "bc"}, {"bc", "cd"}, {"cd"}};

TEST(ContractingGroups, DigitsThatDoNotContractStandAlone) {
  EXPECT_EQ(contracting_groups(kRow, {false, false, false, false}), (Groups{{0}, {1}, {2}, {3}}));
}

// What joins a digit that contracts contracts as well: both ways along the row, whichever begins.
TEST(ContractingGroups, WhatJoinsMakesTheNextJoin) {
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<bool> excited(4, false);
    excited[i] = true;
    EXPECT_EQ(contracting_groups(kRow, excited), (Groups{{0, 1, 2, 3}})) << i;
  }
}

TEST(ContractingGroups, AMuscleThatIsNotSharedJoinsNothing) {
  EXPECT_EQ(contracting_groups({{"a"}, {"b", "bd"}, {"c"}, {"bd"}}, {true, true, false, false}),
            (Groups{{0}, {1, 3}, {2}}));
}

/// Tendons that warn of every posture below one.
class WarningTendons final : public DigitTendons {
 public:
  WarningTendons(std::shared_ptr<const DigitTendons> of, double below)
      : of_(std::move(of)), below_(below) {}
  [[nodiscard]] const TendonDigit& digit() const override { return of_->digit(); }
  TendonTorque evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                        const Eigen::Matrix3Xd& start) const override {
    TendonTorque out = of_->evaluate(q, t, start);
    if (q.maxCoeff() < below_) out.warning = "a tendon lifts off";
    return out;
  }
  [[nodiscard]] Eigen::VectorXd lengths(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                        const TendonTorque& at) const override {
    return of_->lengths(q, t, at);
  }

 private:
  std::shared_ptr<const DigitTendons> of_;
  double below_;  // [rad]
};

// Excursions at the start are found on a walk from the reference posture; what is warned of there
// comes to the warnings of the run, though no instant of the run itself is warned of.
TEST(TendonGroup, WarnsOfTheWayToTheStart) {
  sample::Mover owned(sample::index_finger(), Muscle::kRigidTendon);
  const std::shared_ptr<const DigitTendons> tendons = std::move(owned.tendons);
  const auto group =
      std::make_shared<const TendonGroup>(std::vector<std::shared_ptr<const DigitTendons>>{
          tendons, std::make_shared<const WarningTendons>(tendons, 0.1)});
  EXPECT_EQ(group->excursion(Eigen::VectorXd::Constant(4, 0.5)).warning, "a tendon lifts off");
  EXPECT_EQ(TendonGroup({tendons}).excursion(Eigen::VectorXd::Constant(4, 0.5)).warning, "");

  MovingScene scene;
  scene.mechanism = skeleton_mechanism(tendons->digit().skeleton);
  const MechanismLayout layout = layout_of(scene.mechanism);
  scene.q = Eigen::VectorXd::Constant(layout.q, 0.5);
  scene.v = Eigen::VectorXd::Zero(layout.v);
  DigitPullModel model;
  model.name = "digit";
  model.tendons = group;
  model.indices = {layout.coordinate_q, layout.coordinate_v};
  model.contraction = std::move(owned.contraction);
  scene.elements.push_back(std::make_shared<const DigitPull>(std::move(model)));
  SceneOptions options;
  options.duration = 1e-3;
  const RunMeasures measures = measure_run(scene, simulate_scene(scene, options));
  EXPECT_THAT(measures.pulls.warnings,
              testing::ElementsAre("digit, on the way to the start: a tendon lifts off"));
}

}  // namespace
}  // namespace thenar
