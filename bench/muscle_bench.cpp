// Speed of an index finger in motion, on every rung of muscles.

#include <cmath>
#include <memory>

#include <benchmark/benchmark.h>

#include "tendons/linear_tendons.h"
#include "tendons/muscle/simulate.h"
#include "tendons/net/build_tendons.h"

namespace thenar {
namespace {

constexpr double kSeconds = 0.5;  // [s]

/// The index finger of data/subjects; its tendons are 20 cm long, as it does not say.
struct Finger {
  explicit Finger(Muscle rung)
      : subject(read_subject(THENAR_DATA_DIR "/subjects/an_chao_index.toml")) {
    for (MuscleUnit& muscle : subject.muscles) muscle.tendon_slack = 0.2;  // [m]
    tendons = build_linear_tendons(subject, "index");
    contraction = build_contraction(musculotendons(subject, tendons->digit(), rung), rung);
  }
  [[nodiscard]] MotionModel model() const { return {*tendons, *contraction}; }

  Subject subject;
  std::unique_ptr<DigitTendons> tendons;
  std::unique_ptr<Contraction> contraction;
};

/// Deep flexor against extensor, as in the report of `thenar simulate`.
Eigen::VectorXd excitation() {
  Eigen::VectorXd e = Eigen::VectorXd::Constant(7, 0.02);
  e[0] = 0.05;
  e[2] = 0.10;
  return e;
}

/// Half a second of motion; how many times faster than the finger itself.
void BM_Simulate(benchmark::State& state) {
  const Finger finger(static_cast<Muscle>(state.range(0)));
  SimulateOptions options;
  options.seconds = kSeconds;
  options.tolerance = std::pow(10.0, -static_cast<double>(state.range(1)));
  long steps = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Trajectory path =
        simulate(finger.model(), constant_excitation(excitation()),
                 {Eigen::VectorXd::Constant(4, 0.2), {}, Eigen::VectorXd::Zero(7)}, options);
    if (path.status != MotionStatus::kCompleted) state.SkipWithError(path.warning.c_str());
    steps = path.counts.steps;
  }
  state.counters["steps"] = static_cast<double>(steps);
  state.counters["times_real"] =
      benchmark::Counter(kSeconds, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(BM_Simulate)
    ->ArgNames({"rung", "digits"})
    ->ArgsProduct({{0, 1, 2}, {4, 6, 8}})
    ->Unit(benchmark::kMillisecond);

/// One evaluation of the equations of motion.
void BM_Slope(benchmark::State& state) {
  const Finger finger(static_cast<Muscle>(state.range(0)));
  FingerMotion motion(finger.model());
  const MotionState at =
      motion.start(Eigen::VectorXd::Constant(4, 0.2), Eigen::VectorXd::Ones(4), excitation()).state;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(motion.slope(at, excitation()));
}
BENCHMARK(BM_Slope)->ArgName("rung")->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

/// The same under a net of data/nets, on muscles of rung 0 and 1.
void BM_SlopeUnderNet(benchmark::State& state) {
  const auto rung = static_cast<Muscle>(state.range(0));
  const Finger finger(rung);
  TendonOptions rungs;
  rungs.hood = Hood::kFloatingNet;
  const auto tendons = build_net_tendons(finger.subject, "index", rungs,
                                         read_net(THENAR_DATA_DIR "/nets/winslow.toml"));
  FingerMotion motion({*tendons, *finger.contraction});
  const MotionState at =
      motion.start(Eigen::VectorXd::Constant(4, 0.2), Eigen::VectorXd::Ones(4), excitation()).state;
  const std::string warning = motion.accept(at).warning;
  if (!warning.empty()) state.SkipWithError(warning.c_str());
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(motion.slope(at, excitation()));
}
BENCHMARK(BM_SlopeUnderNet)->ArgName("rung")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace thenar
