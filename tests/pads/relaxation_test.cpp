// Relaxing tissue against exact convolutions, and its times found again from a pressed pad.

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "pad_laws/point_laws.h"
#include "pads/pad_press.h"
#include "solvers/least_squares.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

const std::vector<ExponentialTerm> kThreeTerms{{0.3, 0.004}, {0.25, 0.07}, {0.2, 1.4}};

/// A cube sheared at a constant rate for some time, then held. Large shear: the elastic second
/// Piola-Kirchhoff stresses Se13 = mu (g + g^3 / 3), Se33 = -mu g^2 / 3 do not run straight.
struct ShearedCube {
  static constexpr double kRise = 0.1, kShear = 0.8, kModulus = 3;  // [s], [1], [Pa]

  static double shear(double t) { return kShear * std::min(t / kRise, 1.0); }

  /// Shear force on the unit face: P13 = S13 + g S33 with S = integral of g(t - s) dSe(s).
  static double exact(double t) {
    const double rate = kShear / kRise, end = std::min(t, kRise);
    // Integral of exp(-(t - s) / tau) s^n ds to the end of the rise, by parts.
    const auto moment = [&](int n, double tau) {
      double out = tau * (std::exp((end - t) / tau) - std::exp(-t / tau));
      for (int k = 1; k <= n; ++k)
        out = tau * (std::pow(end, k) * std::exp((end - t) / tau) - k * out);
      return out;
    };
    double s13 = 0, s33 = 0;
    const auto add = [&](double share, double m0, double m1, double m2) {
      s13 += share * kModulus * (rate * m0 + std::pow(rate, 3) * m2);
      s33 -= share * kModulus * 2 / 3 * rate * rate * m1;
    };
    double left = 1;
    for (const ExponentialTerm& term : kThreeTerms) {
      left -= term.share;
      add(term.share, moment(0, term.time), moment(1, term.time), moment(2, term.time));
    }
    add(left, end, end * end / 2, std::pow(end, 3) / 3);
    return s13 + shear(t) * s33;
  }

  /// Largest error of the elements' force, over the largest force, in steps of uneven lengths.
  static double error(int steps) {
    const HexMesh mesh = box_mesh({1, 1, 1}, {1, 1, 1});
    Tissue tissue = neo_hookean(kModulus, 0.49);
    tissue.relaxation = kThreeTerms;
    const TissueBody body(mesh, HexElement::kMeanDilatation, {tissue},
                          std::vector<bool>(static_cast<std::size_t>(mesh.nodes()), false));
    const auto displaced = [&](double t) {
      Eigen::Matrix3Xd u = Eigen::Matrix3Xd::Zero(3, mesh.nodes());
      for (int node = 0; node < mesh.nodes(); ++node) u(0, node) = shear(t) * mesh.place(node)[2];
      return u;
    };
    // Lengths within a factor of three; the rise ends at the end of one.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> length(0.5, 1.5);
    std::vector<double> ends;
    double sum = 0;
    for (int k = 0; k < steps; ++k) ends.push_back(sum += length(random));
    for (double& each : ends) each *= kRise / sum;
    for (const double after : {0.001, 0.01, 0.3, 2.0, 50.0}) ends.push_back(kRise + after);
    TissueHistory history;
    double before = 0, worst = 0, largest = 0;
    for (const double t : ends) {
      const Eigen::Matrix3Xd u = displaced(t), f = body.reactions(u, t - before, history);
      double force = 0;
      for (int node = 0; node < mesh.nodes(); ++node)
        if (mesh.place(node)[2] > 0.5) force += f(0, node);
      history = body.advance_history(u, t - before, history);
      worst = std::max(worst, std::abs(force - exact(t)));
      largest = std::max(largest, exact(t));
      before = t;
    }
    return worst / largest;
  }
};

TEST(Relaxation, ARampAtLargeShearIsTheExactConvolution) {
  EXPECT_LT(ShearedCube::error(1000), 1e-6);
}

TEST(Relaxation, ErrorsFallWithTheSquareOfTheStep) {
  EXPECT_NEAR(std::log2(ShearedCube::error(100) / ShearedCube::error(200)), 2, 0.2);
}

/// Force of a pad that a wall presses at once by 1 mm and then holds, at given times.
std::vector<double> held_forces(double poisson_ratio, const std::vector<double>& times) {
  PadModel model;
  model.tissues = {neo_hookean(12e3, poisson_ratio)};
  model.tissues[0].relaxation = kThreeTerms;
  PadPressOptions options;
  options.force_error = 1;
  options.max_penetration = 1;
  Pose<double> X;
  X.p = {0, 0, model.shape.height + 0.051};
  PadPress press(model, {build_box({0.1, 0.1, 0.1}), 0}, X, options);
  (void)press.touch({0, 0, -1});
  PressGoal goal;
  goal.X_PO = press.state().X_PO;
  goal.X_PO.p[2] -= 1e-3;
  std::vector<double> forces;
  double before = 0;
  for (const double t : times) {
    goal.time = t - before;
    before = t;
    const PadPressResult result = press.step(goal);
    EXPECT_EQ(result.solved.status, Status::kSolved) << result.solved.message;
    forces.push_back(-result.push.force[2]);
  }
  return forces;
}

// Laws relax as a whole; in a pad the volume, a share of the order of 1 - 2 nu, does not.
TEST(Relaxation, LawsFollowAPadThatIsHeld) {
  const std::vector<double> times{0, 0.002, 0.01, 0.03, 0.1, 0.4, 1.4, 4.4, 24.4};
  const PowerLaw law({0.3, 1.8, 4e-3, 0.3, 0.6}, kThreeTerms);
  for (const double nu : {0.49, 0.4999}) {
    const std::vector<double> forces = held_forces(nu, times);
    ExponentialMemory memory;
    double before = 0, first = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const MemoryStep step = memory_step(law.relaxation(), times[i] - before);
      const double force = relaxed_contact(law, {100, 100}, 1e-3, 0, step, memory).force;
      if (i == 0) first = force;
      EXPECT_NEAR(forces[i] / forces[0], force / first, 1 - 2 * nu) << nu << ", " << times[i];
      before = times[i];
    }
  }
}

TEST(Relaxation, ThreeTimesOfAPressedPadAreFoundAgain) {
  // The first at once, then eight in each factor of ten.
  std::vector<double> times{0};
  for (int k = 0; k <= 32; ++k) times.push_back(1e-3 * std::pow(10, k / 8.0));
  const std::vector<double> forces = held_forces(0.4999, times);
  // f = c0 + sum ci exp(-t / tau_i) in (c0, c1, c2, c3, ln tau_1, ln tau_2, ln tau_3).
  LeastSquares problem;
  const double infinite = std::numeric_limits<double>::infinity();
  problem.lower = VectorXd::Constant(7, -infinite);
  problem.upper = VectorXd::Constant(7, infinite);
  problem.residuals = [&](const VectorXd& z, WithJacobian) {
    const auto rows = static_cast<Eigen::Index>(times.size());
    Residuals out{VectorXd(rows), Eigen::MatrixXd(rows, 7)};
    for (Eigen::Index row = 0; row < rows; ++row) {
      const double t = times[static_cast<std::size_t>(row)];
      const double scale = 1e4 / forces[0];  // an sd of 1e-4 of the first force
      out.r[row] = scale * (z[0] - forces[static_cast<std::size_t>(row)]);
      out.J(row, 0) = scale;
      for (int i = 1; i <= 3; ++i) {
        const double x = t / std::exp(z[3 + i]), e = std::exp(-x);
        out.r[row] += scale * z[i] * e;
        out.J(row, i) = scale * e;
        out.J(row, 3 + i) = scale * z[i] * e * x;
      }
    }
    return out;
  };
  // From what the measurement alone tells: equal shares, times spread evenly over its decades.
  VectorXd start(7);
  const double last = forces.back(), span = std::log(times.back() / times[1]);
  start << last, VectorXd::Constant(3, (forces[0] - last) / 3), std::log(times[1]) + span / 6,
      std::log(times[1]) + span / 2, std::log(times[1]) + span * 5 / 6;
  const Solution found = solve(problem, start);
  ASSERT_TRUE(found.converged()) << found.message;
  // What does not relax, volume, makes forces of a pad no exact multiples of g(t).
  for (int i = 1; i <= 3; ++i) {
    const ExponentialTerm& term = kThreeTerms[static_cast<std::size_t>(i - 1)];
    EXPECT_NEAR(std::exp(found.z[3 + i]) / term.time, 1, 1e-3) << i;
    EXPECT_NEAR(found.z[i] / forces[0], term.share, 1e-3 * term.share) << i;
  }
}

}  // namespace
}  // namespace thenar
