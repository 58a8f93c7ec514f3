#include "sampling/methods/hamiltonian_trajectory.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace thenar::internal {

void begin_leapfrog(PhasePoint& point, const Whitening& whitening, double step) {
  point.r += 0.5 * step * point.slope;
  if (!whitening.follows_orbits()) {
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

/// Trajectories of jittered fixed length.
class JitteredLength : public HamiltonianTrajectory {
 public:
  void start(const PhasePoint& from, double step, RandomStream& random) override {
    constexpr double kMaxSteps = 1000;  // maximum number of leapfrog steps of a trajectory
    // Divide the jittered length into equal leapfrog steps.
    point_ = from;
    const double length = kPi / 2 * (0.9 + 0.7 * random.uniform());
    left_ = static_cast<int>(std::clamp(std::ceil(length / step), 1.0, kMaxSteps));
    leap_ = std::min(step, length / left_);
    acceptance_sum_ = point_count_ = 0;
  }

  PhasePoint& moving_point() override { return point_; }
  [[nodiscard]] double leapfrog_length() const override { return leap_; }

  PointVerdict assess_point(double energy_error, RandomStream& random) override {
    ++point_count_;
    // Reject a divergent trajectory.
    if (!(energy_error <= kMaxEnergyError)) return {false, false, true};
    const double acceptance = std::min(1.0, std::exp(-energy_error));
    acceptance_sum_ += acceptance;
    // Accept or reject the end point.
    if (--left_ > 0) return {};
    return {true, random.uniform() < acceptance, true};
  }

  // Mean over all points: the end point alone would drive the step size to zero if trajectories hit
  // a wall.
  [[nodiscard]] double acceptance() const override { return acceptance_sum_ / point_count_; }
  [[nodiscard]] int depth() const override { return 0; }

 private:
  PhasePoint point_;
  int left_ = 0;                                 // remaining leapfrog steps [1]
  double leap_ = 0;                              // length of a leapfrog step [1]
  double acceptance_sum_ = 0, point_count_ = 0;  // sum over the points so far, and their number
};

}  // namespace

std::unique_ptr<HamiltonianTrajectory> jittered_trajectory() {
  return std::make_unique<JitteredLength>();
}

}  // namespace thenar::internal
