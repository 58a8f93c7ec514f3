// Tests for dynamics/scene/run_bytes.cpp.

#include "dynamics/scene/run_bytes.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "data/io/scene/scene.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

SceneRun run_of(const char* scene, double seconds) {
  const BuiltScene built = build_scene(read_scene(kData + "/scenes/" + scene + ".toml"), {});
  SceneOptions options = built.options;
  options.duration = seconds;
  return simulate_scene(built.scene, options);
}

SceneRun pinched() { return run_of("swinging_pinch", 0.1); }

TEST(RunBytes, ComeBackToTheBit) {
  SceneRun run = pinched();
  ASSERT_FALSE(run.samples.back().contacts.empty());
  run.status = SceneStatus::kUnsolved;
  run.cost.unsolved = 7;
  run.samples[1].q[0] = -0.0;
  run.samples[1].v[0] = std::numeric_limits<double>::denorm_min();
  run.samples.back().contacts.back().torsion = 0.1 + 0.2;
  const SceneRun back = run_from_bytes(bytes_of(run));
  EXPECT_EQ(back.status, run.status);
  EXPECT_EQ(back.cost.unsolved, 7);
  EXPECT_EQ(back.cost.steps, run.cost.steps);
  EXPECT_EQ(back.cost.worst_residual, run.cost.worst_residual);
  ASSERT_GT(run.cost.limit_excess.size(), 0);
  EXPECT_EQ(back.cost.limit_excess, run.cost.limit_excess);
  ASSERT_EQ(back.samples.size(), run.samples.size());
  EXPECT_TRUE(std::signbit(back.samples[1].q[0]));
  for (std::size_t k = 0; k < run.samples.size(); ++k) {
    const SceneSample &a = run.samples[k], &b = back.samples[k];
    EXPECT_EQ(a.t, b.t);
    EXPECT_EQ(a.q, b.q);
    EXPECT_EQ(a.v, b.v);
    EXPECT_EQ(a.energy.total(), b.energy.total());
    ASSERT_EQ(a.contacts.size(), b.contacts.size());
    for (std::size_t c = 0; c < a.contacts.size(); ++c) {
      EXPECT_EQ(a.contacts[c].id, b.contacts[c].id);
      EXPECT_EQ(a.contacts[c].force, b.contacts[c].force);
      EXPECT_EQ(a.contacts[c].torsion, b.contacts[c].torsion);
      EXPECT_EQ(a.contacts[c].gap, b.contacts[c].gap);
      EXPECT_EQ(a.contacts[c].mode, b.contacts[c].mode);
    }
  }
}

TEST(RunBytes, OfElementsAndAReasonComeBack) {
  SceneRun run = run_of("loose_joint", 0.2);
  run.status = SceneStatus::kFailed;
  run.message = "at 0.2 s no step is short enough";
  EXPECT_GT(run.samples.back().energy.springs, 0);
  // The joint is passive and has no state.
  for (std::size_t k = 0; k < run.samples.size(); ++k) {
    run.samples[k].z = Eigen::Vector2d(0.1 * static_cast<double>(k), -0.0);
    run.samples[k].energy.of_elements = 0.3 * static_cast<double>(k);
  }
  const SceneRun back = run_from_bytes(bytes_of(run));
  EXPECT_EQ(back.status, SceneStatus::kFailed);
  EXPECT_EQ(back.message, run.message);
  ASSERT_EQ(back.samples.size(), run.samples.size());
  for (std::size_t k = 0; k < run.samples.size(); ++k) {
    EXPECT_EQ(back.samples[k].z, run.samples[k].z);
    EXPECT_TRUE(std::signbit(back.samples[k].z[1]));
    EXPECT_EQ(back.samples[k].energy.springs, run.samples[k].energy.springs);
    EXPECT_EQ(back.samples[k].energy.of_elements, run.samples[k].energy.of_elements);
    EXPECT_EQ(back.samples[k].energy.of_passive, run.samples[k].energy.of_passive);
    EXPECT_EQ(back.samples[k].w, run.samples[k].w);
  }
}

TEST(RunBytes, OfNoRunAreRefused) {
  const std::string bytes = bytes_of(pinched());
  EXPECT_THROW((void)run_from_bytes(""), InputError);
  EXPECT_THROW((void)run_from_bytes(bytes.substr(0, bytes.size() - 1)), InputError);
  EXPECT_THROW((void)run_from_bytes(bytes + "x"), InputError);
  // A count that promises more than there is asks for no memory.
  EXPECT_THROW((void)run_from_bytes(bytes.substr(0, sizeof(SceneStatus)) + std::string(8, '\x7f')),
               InputError);
}

}  // namespace
}  // namespace thenar
