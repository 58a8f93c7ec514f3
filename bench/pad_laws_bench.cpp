// Reduced laws of a pad, one call each, at the constants of a soft pad pressed by about 1 mm.

#include <vector>

#include <benchmark/benchmark.h>

#include "geometry/primitives.h"
#include "pad_laws/elastic_foundation.h"
#include "pad_laws/point_laws.h"
#include "pads/pad_shape.h"

namespace thenar {
namespace {

constexpr RelativeCurvatures kGap{240, 150};
constexpr int kRings = 18;
constexpr FoundationConstants kFoundation{4e4, 0.9, 3, 0.6, 1.3, 5.5e-3, 8e3};
const std::vector<ExponentialTerm> kTerms{{0.3, 4e-3}, {0.25, 70e-3}, {0.2, 1.4}};

/// Depths around 1 mm, lest the same numbers come again.
double depth_of(std::size_t i) { return 1e-3 + 1e-6 * static_cast<double>(i % 64); }

template <typename Law>
void at_depth(benchmark::State& state, const Law& law) {
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(law.at_depth(kGap, depth_of(i++), 0.6));
}
template <typename Law>
void at_force(benchmark::State& state, const Law& law) {
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(law.at_force(kGap, 300 * depth_of(i++), 0.6));
}

const PowerLaw kPower({0.3, 1.9, 4e-3, 0.2, 0.6});
const SoftFinger kFinger({0.3, 1.8, 0.7, 4e-3, 0.22, 0.3, 0.55, 0.6});
const ElasticFoundation kElastic(kFoundation);

BENCHMARK_CAPTURE(at_depth, power_law, kPower);
BENCHMARK_CAPTURE(at_force, power_law, kPower);
BENCHMARK_CAPTURE(at_depth, soft_finger, kFinger);
BENCHMARK_CAPTURE(at_force, soft_finger, kFinger);
BENCHMARK_CAPTURE(at_depth, elastic_foundation, kElastic);
BENCHMARK_CAPTURE(at_force, elastic_foundation, kElastic);

/// An object over the pad's pole.
struct Pressing {
  std::shared_ptr<const Shape> object;
  Pose<double> X;
  double height;  // of the origin when it touches [m]
};

Pressing pressing(int kind) {
  Pressing out;
  out.object = kind == 0 ? build_box({0.1, 0.1, 0.1}) : build_sphere(8e-3);
  out.height = PadShape{}.height + (kind == 0 ? 0.05 : 8e-3);
  return out;
}

void bed_press(benchmark::State& state, int kind) {
  const FoundationBed bed(pad_columns({}, kRings), kFoundation);
  Pressing p = pressing(kind);
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    p.X.p[2] = p.height - depth_of(i++);
    benchmark::DoNotOptimize(bed.press(*p.object, p.X, 0.6));
  }
}
BENCHMARK_CAPTURE(bed_press, plane, 0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(bed_press, ball, 1)->Unit(benchmark::kMicrosecond);

void bed_step(benchmark::State& state, int kind, bool relaxes) {
  const FoundationBed bed(pad_columns({}, kRings), kFoundation,
                          relaxes ? kTerms : std::vector<ExponentialTerm>{});
  Pressing p = pressing(kind);
  BedState at;
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    p.X.p[2] = p.height - depth_of(i++);
    benchmark::DoNotOptimize(bed.step(*p.object, p.X, 0.6, 1e-3, at));
  }
}
BENCHMARK_CAPTURE(bed_step, plane_with_friction, 0, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(bed_step, plane_that_relaxes, 0, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(bed_step, ball_that_relaxes, 1, true)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace thenar
