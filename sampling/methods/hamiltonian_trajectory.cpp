#include "sampling/methods/hamiltonian_trajectory.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace thenar::internal {

void begin_leapfrog(PhasePoint& point, const Whitening& whitening, double step) {
  point.r += 0.5 * step * point.slope;
  if (!whitening.orbits()) {
    point.y += step * point.r;
    return;
  }
  const double cosine = std::cos(step), sine = std::sin(step);
  for (Eigen::Index i = 0; i < point.y.size(); ++i) {
    const double y = point.y[i], r = point.r[i];
    point.y[i] = cosine * y + sine * r;
    point.r[i] = cosine * r - sine * y;
  }
}

void end_leapfrog(PhasePoint& point, const Whitening& whitening, const Eigen::VectorXd& gradient,
                  double step) {
  whitening.whiten_gradient(point.y, gradient, point.slope);
  point.r += 0.5 * step * point.slope;
}

namespace {

class JitteredLength : public HamiltonianTrajectory {
 public:
  void start(const PhasePoint& from, double step, RandomStream& random) override {
    constexpr double kMaxSteps = 1000;  // Most leapfrog steps of a trajectory
    // As many leapfrogs as the jittered length takes.
    point_ = from;
    const double length = kPi / 2 * (0.9 + 0.7 * random.uniform());
    left_ = static_cast<int>(std::clamp(std::ceil(length / step), 1.0, kMaxSteps));
    leap_ = std::min(step, length / left_);
    acceptance_sum_ = told_ = 0;
  }

  PhasePoint& moving() override { return point_; }
  [[nodiscard]] double leap() const override { return leap_; }

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
  int left_ = 0;     // leapfrogs [1]
  double leap_ = 0;  // length of each [1]
  double acceptance_sum_ = 0, told_ = 0;
};

}  // namespace

std::unique_ptr<HamiltonianTrajectory> jittered_length() {
  return std::make_unique<JitteredLength>();
}

}  // namespace thenar::internal
