// Speed of both machines at the size of a hand: 21 hinges, five tips.

#include <benchmark/benchmark.h>

#include "hand/multibody.h"
#include "tests/hand/fast_kinematics.h"
#include "tests/hand/sample_subjects.h"

namespace thenar {
namespace {

/// A random hand with postures to go round.
struct Bench {
  Skeleton skeleton = build_skeleton(sample::random_hand(1, 1));
  std::vector<Eigen::VectorXd> postures;
  std::size_t next = 0;

  Bench() {
    sample::Draw draw(2);  // fixed seed: runs are comparable across commits
    for (int i = 0; i < 64; ++i) postures.push_back(draw.posture(skeleton));
  }
  const Eigen::VectorXd& q() { return postures[next++ % postures.size()]; }
};

// Poses of all links and five tip Jacobians, on the templated chain.
void BM_Chain(benchmark::State& state) {
  Bench bench;
  const Tree<double>& tree = bench.skeleton.tree;
  for ([[maybe_unused]] auto _ : state) {
    const TreeState<double> posed = pose_tree(tree, bench.q());
    for (const SkeletonTip& tip : bench.skeleton.tips)
      benchmark::DoNotOptimize(position_jacobian(
          tree, posed, tip.link, moved(posed, tip.link, tip.p), bench.skeleton.coordinates()));
  }
}
BENCHMARK(BM_Chain)->Unit(benchmark::kMicrosecond);

// The same without the heap, on what every processor has and on what this one has.
void BM_FastKinematics(benchmark::State& state, InstructionSet simd) {
  Bench bench;
  const FastKinematics fast(bench.skeleton, simd);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(fast.pose(bench.q()));
}
BENCHMARK_CAPTURE(BM_FastKinematics, baseline, InstructionSet::kBaseline)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_FastKinematics, best, InstructionSet::kBest)->Unit(benchmark::kMicrosecond);

void BM_MultibodyBuild(benchmark::State& state) {
  const Bench bench;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(Multibody(bench.skeleton));
}
BENCHMARK(BM_MultibodyBuild)->Unit(benchmark::kMicrosecond);

void BM_MultibodyInverseDynamics(benchmark::State& state) {
  Bench bench;
  Multibody body(bench.skeleton);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(bench.skeleton.coordinates());
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(body.inverse_dynamics({bench.q(), zero}, zero, {{0, 0, -9.81}, {}}));
}
BENCHMARK(BM_MultibodyInverseDynamics)->Unit(benchmark::kMicrosecond);

void BM_MultibodyForwardDynamics(benchmark::State& state) {
  Bench bench;
  Multibody body(bench.skeleton);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(bench.skeleton.coordinates());
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(body.forward_dynamics({bench.q(), zero}, zero, {{0, 0, -9.81}, {}}));
}
BENCHMARK(BM_MultibodyForwardDynamics)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace thenar
