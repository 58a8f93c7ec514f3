#include "sampling/methods/hamiltonian_trajectory.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace thenar::internal {

void begin_leapfrog(PhasePoint& point, const MassMatrix& metric, double step) {
  point.r += 0.5 * step * point.slope;
  metric.drift(point.x, point.r, step);
}

void end_leapfrog(PhasePoint& point, const MassMatrix& metric, const Eigen::VectorXd& gradient,
                  double step) {
  metric.whiten_gradient(gradient, point.slope);
  point.r += 0.5 * step * point.slope;
}

namespace {

class JitteredLength : public HamiltonianTrajectory {
 public:
  void start(const PhasePoint& from, double step, RandomStream& random) override {
    constexpr double kMaxSteps = 1000;
    // As many leapfrogs as the jittered length takes.
    point_ = from;
    const double length = kPi / 2 * (0.5 + random.uniform());
    left_ = static_cast<int>(std::clamp(std::round(length / step), 1.0, kMaxSteps));
    acceptance_sum_ = told_ = 0;
  }

  PhasePoint& moving() override { return point_; }
  [[nodiscard]] int direction() const override { return 1; }

  Verdict judge(double energy_error, RandomStream& random) override {
    ++told_;
    // A divergent trajectory is refused.
    if (!(energy_error <= kMaxEnergyError)) return {false, false, true};
    const double acceptance = std::min(1.0, std::exp(-energy_error));
    acceptance_sum_ += acceptance;
    // The end is accepted or refused.
    if (--left_ > 0) return {};
    return {true, random.uniform() < acceptance, true};
  }

  // Of the end alone, no step size would be small enough where trajectories hit a wall.
  [[nodiscard]] double acceptance() const override { return acceptance_sum_ / told_; }
  [[nodiscard]] int depth() const override { return 0; }

 private:
  PhasePoint point_;
  int left_ = 0;  // leapfrogs [1]
  double acceptance_sum_ = 0, told_ = 0;
};

}  // namespace

std::unique_ptr<HamiltonianTrajectory> jittered_length() {
  return std::make_unique<JitteredLength>();
}

}  // namespace thenar::internal
