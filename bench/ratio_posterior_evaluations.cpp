// Forces of a skewed thumb at new axes: points side by side in registers against one after the
// other through the same steps, and the adjoint against the forces alone.

#include "bench/ratios.h"
#include "kinematics_fit/kernel/batch.h"
#include "kinematics_fit/kernel/compile.h"
#include "tests/posterior/thumb_scene.h"

namespace thenar::bench {
namespace {

/// The scene that samplers are timed on, compiled, at as many points as the widest unit takes.
struct Thumb {
  Thumb() : problem(sample::thumb_problem()) {
    const FitParameters& p = problem.parameters();
    kernel::compile(problem.digit(), p, problem.plans().front(), program);
    std::mt19937 rng(3);
    std::normal_distribution<double> normal;
    u.resize(p.coordinates(), 8);
    weights = Eigen::MatrixXd::NullaryExpr(3 * program.trials, 8, [&] { return normal(rng); });
    for (Eigen::Index k = 0; k < u.cols(); ++k)
      for (Eigen::Index c = 0; c < u.rows(); ++c)
        u(c, k) = 0.2 * p.all[p.leader[c]].sd * normal(rng);
  }
  [[nodiscard]] Eigen::MatrixXd forces(
      const std::vector<kernel::SimdBackend>& simd_backends) const {
    return kernel::run_batch(program, simd_backends, u, kernel::KeepTape::kNo).forces;
  }
  [[nodiscard]] Eigen::MatrixXd gradient(
      const std::vector<kernel::SimdBackend>& simd_backends) const {
    const kernel::Batch batch =
        kernel::run_batch(program, simd_backends, u, kernel::KeepTape::kYes);
    return kernel::adjoint_batch(program, batch, weights);
  }
  /// Greatest difference from Ceres' J' w, relative.
  [[nodiscard]] double gradient_error() const {
    const Eigen::MatrixXd ours = gradient(kernel::simd_backends());
    double error = 0;
    for (Eigen::Index k = 0; k < u.cols(); ++k) {
      const Eigen::VectorXd expected =
          force_jacobian(problem.digit(), problem.parameters(), problem.plans().front(), u.col(k))
              .J.transpose() *
          weights.col(k);
      error = std::max(error, (ours.col(k) - expected).norm() / expected.norm());
    }
    return error;
  }

  FitProblem problem;
  kernel::Program program;
  Eigen::MatrixXd u, weights;
};

}  // namespace

Row ratio_posterior_lanes() {
  const Thumb thumb;
  const std::vector<kernel::SimdBackend> widest{kernel::simd_backends().front()},
      scalar{kernel::simd_backends().back()};
  Duel duel{"thumb forces, 8 points in " + std::string(widest[0].name) + " lanes", {}, {}, 4, 0, 0};
  duel.error = (thumb.forces(widest) - thumb.forces(scalar)).cwiseAbs().maxCoeff();
  duel.ours = [&] { keep(thumb.forces(widest)); };
  duel.rival = [&] { keep(thumb.forces(scalar)); };
  return measure(duel);
}

Row ratio_posterior_gradient() {
  const Thumb thumb;
  const std::vector<kernel::SimdBackend>& simd_backends = kernel::simd_backends();
  Duel duel{"the same with gradient, against 4 times forces", {}, {}, 1, 0, 1e-10};
  duel.error = thumb.gradient_error();
  duel.ours = [&] { keep(thumb.gradient(simd_backends)); };
  duel.rival = [&] {
    for (int i = 0; i < 4; ++i) keep(thumb.forces(simd_backends));
  };
  return measure(duel);
}

Row ratio_posterior_jets() {
  const Thumb thumb;
  const std::vector<kernel::SimdBackend>& simd_backends = kernel::simd_backends();
  Duel duel{"the same, against derivatives by jets", {}, {}, 0, 0, 1e-10};
  duel.error = thumb.gradient_error();
  duel.ours = [&] { keep(thumb.gradient(simd_backends)); };
  duel.rival = [&] {
    for (Eigen::Index k = 0; k < thumb.u.cols(); ++k)
      keep(force_jacobian(thumb.problem.digit(), thumb.problem.parameters(),
                          thumb.problem.plans().front(), thumb.u.col(k)));
  };
  return measure(duel);
}

}  // namespace thenar::bench
