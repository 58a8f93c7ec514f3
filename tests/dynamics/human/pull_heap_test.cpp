// Tests that dynamics/human/digit_pull.cpp and joint_stops.cpp leave the heap alone, call after
// call.

#include <gtest/gtest.h>

#include "dynamics/human/digit_pull.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/mechanism/tree_model.h"
#include "dynamics/mechanism/tree_motion.h"
#include "tests/counted_malloc.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

TEST(PullHeap, IsLeftAloneAtEveryPostureAndNeed) {
  // The middle finger of a specimen, its tendons wrapped over cylinders, all muscles excited.
  Subject subject = read_subject(THENAR_DATA_DIR "/subjects/mirakhorlo2016.toml");
  TendonOptions options;
  options.path = Path::kWrapped;
  const std::shared_ptr<const DigitTendons> tendons =
      build_linear_tendons(subject, "middle", options);
  const TendonDigit& digit = tendons->digit();
  const Mechanism bones = skeleton_mechanism(digit.skeleton);
  const MechanismLayout layout = layout_of(bones);
  const TreeModel tree = tree_model(bones);
  const TreeMotion<double> motion(tree);
  const CoordinateIndices places{layout.coordinate_q, layout.coordinate_v};
  DigitPullModel model;
  model.name = "digit";
  model.tendons = std::make_shared<const TendonGroup>(
      std::vector<std::shared_ptr<const DigitTendons>>{tendons});
  model.indices = places;
  for (MuscleUnit& unit : subject.muscles) {
    unit.fibre_length = 0.05;
    if (!unit.max_force) unit.max_force = 50;
  }
  model.contraction =
      build_contraction(musculotendons(subject, digit, Muscle::kRigidTendon), Muscle::kRigidTendon);
  for (std::size_t m = 0; m < digit.names.muscles.size(); ++m)
    model.excitations.push_back(
        {static_cast<int>(m), {}, VectorXd::Zero(1), VectorXd::Constant(1, 0.2)});
  DigitPull pull(model);
  JointStops stops("stops", digit.skeleton, places);

  // States of the pull at a posture; the stiffness by posture is known from the first on.
  VectorXd q = VectorXd::Zero(layout.q), z = pull.initial_states(q);
  const VectorXd v = VectorXd::Constant(layout.v, 0.3);
  z.head(z.size() / 2).setConstant(0.2);
  ElementAction out;
  out.clear(layout.v, z.size());
  double t = 0;
  const auto act = [&](double part, ElementNeed need) {
    q.setConstant(part);
    const ElementInput at{t, t, q, v, z, motion, 0, need};
    EXPECT_TRUE(pull.add_action(at, out));
    EXPECT_TRUE(stops.add_action(at, out));
    t += 1e-3;
  };
  pull.accept_step({t, t, q, v, z, motion, 0});
  for (const double part : {0.0, 0.3, 0.6, 0.2}) act(part, ElementNeed::kAll);
  const std::size_t before = allocations;
  for (const double part : {0.1, 0.4, 0.5, 0.25})
    for (const ElementNeed need : {ElementNeed::kStates, ElementNeed::kAll, ElementNeed::kRates})
      act(part, need);
  EXPECT_EQ(allocations, before);
}

TEST(PullHeap, IsCountedHere) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "sanitizers count for themselves";
#endif
  const std::size_t before = allocations;
  const VectorXd block(100);
  EXPECT_GE(allocations, before + 1) << block.size();
}

}  // namespace
}  // namespace thenar
