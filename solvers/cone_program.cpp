#include "solvers/cone_program.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <Eigen/QR>

#include "base/error.h"
#include "base/numbers.h"
#include "solvers/second_order_cone.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using internal::ConeScaling;
using Qr = Eigen::ColPivHouseholderQR<MatrixXd>;

constexpr double kRankPivot = 1e-11;  // pivot, over the largest, below which it counts as zero [1]
// Relative residual of dependent equalities that rounding may cause [1]
constexpr double kConsistencyError = 1e-9;
constexpr int kStepRefinements = 2;  // iterative refinements of a Newton step
// Iterations without a better iterate or certificate after which a run stalls
constexpr int kStalledIterations = 12;
constexpr double kBoundaryFraction = 0.99;  // step length over the distance to the boundary [1]

void check(const ConeProgram& p) {
  const Index n = p.c.size(), m = p.h.size();
  require(p.A.cols() == n || p.A.rows() == 0, "c has {} variables, A {}", n, p.A.cols());
  require(p.A.rows() == p.b.size(), "A has {} rows, b {}", p.A.rows(), p.b.size());
  require(p.G.rows() == m && p.G.cols() == n, "G is {} x {}, h has {} rows, c {} variables",
          p.G.rows(), p.G.cols(), m, n);
  for (const int rows : p.cones) require(rows > 0, "a cone has {} rows", rows);
  require(std::accumulate(p.cones.begin(), p.cones.end(), 0) == m,
          "cones have {} rows in all, h {}", std::accumulate(p.cones.begin(), p.cones.end(), 0), m);
  require(
      p.c.allFinite() && p.A.allFinite() && p.b.allFinite() && p.G.allFinite() && p.h.allFinite(),
      "the cone programme must be finite");
}

/// Reduced problem:  minimise c' v  subject to  h - G v in K, where x = x0 + N v.
struct ReducedProgram {
  VectorXd x0, c, h;
  MatrixXd N, G;
};

/// Result of the elimination of equalities and free directions.
struct Presolve {
  std::optional<ReducedProgram> reduced;  // empty: the equalities are inconsistent
  VectorXd misfit;                        // least-squares residual A x - b
  VectorXd descent;  // direction of descent that no cone constrains; may be empty
};

Qr rank_revealing(const MatrixXd& M) {
  Qr qr;
  qr.setThreshold(kRankPivot);
  qr.compute(M);
  return qr;
}

/// Orthonormal bases of the row space and the null space of M.
struct RowSpaces {
  MatrixXd row_space, null_space;
};
RowSpaces row_spaces(const MatrixXd& M) {
  if (M.size() == 0) return {MatrixXd(M.cols(), 0), MatrixXd::Identity(M.cols(), M.cols())};
  const Qr qr = rank_revealing(M.transpose());
  const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(M.cols(), M.cols());
  return {Q.leftCols(qr.rank()), Q.rightCols(M.cols() - qr.rank())};
}

/// Eliminates equalities, then directions that no cone constrains.
Presolve presolve(const ConeProgram& p) {
  Presolve result;
  // Find the least-squares solution of the equalities.
  VectorXd x0 = VectorXd::Zero(p.c.size());
  if (p.A.size() > 0) x0 = Eigen::CompleteOrthogonalDecomposition<MatrixXd>(p.A).solve(p.b);
  if (p.A.rows() > 0) result.misfit = p.A * x0 - p.b;
  if (result.misfit.norm() > kConsistencyError * (1 + p.b.norm())) return result;
  // Find the directions within the equalities that cones constrain.
  MatrixXd N =
      p.A.rows() > 0 ? row_spaces(p.A).null_space : MatrixXd::Identity(p.c.size(), p.c.size());
  const RowSpaces constrained = row_spaces(p.G * N);
  const VectorXd c = N.transpose() * p.c;
  // Project the objective on the unconstrained directions.
  const VectorXd free_gradient = constrained.null_space.transpose() * c;
  if (free_gradient.norm() > kConsistencyError * (1 + c.norm()))
    result.descent = -N * constrained.null_space * free_gradient;
  N = (N * constrained.row_space).eval();
  result.reduced = ReducedProgram{x0, N.transpose() * p.c, p.h - p.G * x0, N, p.G * N};
  return result;
}

/// Solves  [0 G'; G -W W] [x; z] = [a; b]  through the QR factors of W^-1 G.
class KktSolver {
 public:
  KktSolver(const MatrixXd& G, const ConeScaling& W) : G_(G), W_(W), scaled_G_(W.divide(G)) {
    if (G.cols() > 0) qr_.compute(scaled_G_);
  }

  /// Solves with iterative refinement: near the optimum W is so ill-conditioned that QR alone loses
  /// half of the digits.
  void solve(const VectorXd& a, const VectorXd& b, VectorXd& x, VectorXd& z) const {
    solve_once(a, b, x, z);
    VectorXd left_a = a - G_.transpose() * z, left_b = b - G_ * x + W_.times(W_.times(z)), dx, dz;
    for (int again = 0; again < kStepRefinements; ++again) {
      solve_once(left_a, left_b, dx, dz);
      const VectorXd next_x = x + dx, next_z = z + dz;
      const VectorXd next_a = a - G_.transpose() * next_z,
                     next_b = b - G_ * next_x + W_.times(W_.times(next_z));
      if (!(next_a.norm() + next_b.norm() < left_a.norm() + left_b.norm())) return;
      x = next_x;
      z = next_z;
      left_a = next_a;
      left_b = next_b;
    }
  }

 private:
  /// Solves once with the QR factors.
  void solve_once(const VectorXd& a, const VectorXd& b, VectorXd& x, VectorXd& z) const {
    const VectorXd scaled_b = W_.divide(b);
    x = VectorXd::Zero(a.size());
    if (a.size() > 0) {
      const Index n = a.size();
      const auto R = qr_.matrixQR().topRows(n).triangularView<Eigen::Upper>();
      const VectorXd Qb = (qr_.householderQ().transpose() * scaled_b).head(n);
      x = R.solve(R.transpose().solve(a) + Qb);
    }
    z = W_.divide(scaled_G_ * x - scaled_b);
  }

  const MatrixXd& G_;
  const ConeScaling& W_;
  MatrixXd scaled_G_;
  Eigen::HouseholderQR<MatrixXd> qr_;
};

/// Iterate of the homogeneous embedding:  G'z + c tau = 0,  s + G x = h tau,  c'x + h'z + kappa =
/// 0.
class Embedding {
 public:
  Embedding(const ReducedProgram& p, const std::vector<int>& cones)
      : p_(p), cones_(cones), e_(internal::cone_identity(cones)), s(e_), z(e_) {
    x = VectorXd::Zero(p.c.size());
  }

  /// Takes one predictor-corrector step.
  void step() {
    const ConeScaling W(cones_, s, z);
    const KktSolver kkt(p_.G, W);
    const VectorXd lambda = W.times(z);
    const Step h_direction = solve_for(kkt, -p_.c, p_.h);
    const VectorXd pure = -internal::cone_product(cones_, lambda, lambda);
    const Step affine = direction(kkt, W, lambda, h_direction, {1, pure, -kappa * tau});
    // Choose the centring parameter from the length of the affine step.
    const double length = step_length(W, lambda, affine, 1);
    const double sigma = std::pow(1 - length, 3);
    const VectorXd corrected =
        pure - internal::cone_product(cones_, W.divide(affine.s), W.times(affine.z)) +
        sigma * gap_per_cone() * e_;
    // Take a step along the corrected direction that stays in the interior.
    const Step full = direction(
        kkt, W, lambda, h_direction,
        {1 - sigma, corrected, -kappa * tau - affine.kappa * affine.tau + sigma * gap_per_cone()});
    advance(full, std::min(1.0, kBoundaryFraction * step_length(W, lambda, full, kInfinity)));
  }

  [[nodiscard]] VectorXd dual_residual() const { return p_.G.transpose() * z + p_.c * tau; }
  [[nodiscard]] VectorXd primal_residual() const { return s + p_.G * x - p_.h * tau; }
  [[nodiscard]] double gap_residual() const { return kappa + p_.c.dot(x) + p_.h.dot(z); }

 private:
  struct Step {
    VectorXd x, s, z;
    double tau = 0, kappa = 0;
  };
  /// Right-hand side of a Newton direction.
  struct NewtonTarget {
    double share;      // fraction of the residuals to be removed [1]
    VectorXd product;  // right-hand side of lambda o (...)
    double kappa_tau;  // right-hand side of the equation of kappa and tau
  };

  static Step solve_for(const KktSolver& kkt, const VectorXd& a, const VectorXd& b) {
    Step step;
    kkt.solve(a, b, step.x, step.z);
    return step;
  }

  [[nodiscard]] double gap_per_cone() const {
    return (s.dot(z) + kappa * tau) / (static_cast<double>(cones_.size()) + 1);
  }

  /// Computes the Newton direction that removes the fraction `target.share` of the residuals and
  /// satisfies lambda o (...) = target.product.
  [[nodiscard]] Step direction(const KktSolver& kkt, const ConeScaling& W, const VectorXd& lambda,
                               const Step& h_direction, const NewtonTarget& target) const {
    const double share = target.share, kappa_tau = target.kappa_tau;
    const VectorXd ratio = internal::cone_quotient(cones_, lambda, target.product);
    Step step =
        solve_for(kkt, -share * dual_residual(), -share * primal_residual() - W.times(ratio));
    const double left =
        -share * gap_residual() - kappa_tau / tau - p_.c.dot(step.x) - p_.h.dot(step.z);
    step.tau = left / (p_.c.dot(h_direction.x) + p_.h.dot(h_direction.z) - kappa / tau);
    step.x += step.tau * h_direction.x;
    step.z += step.tau * h_direction.z;
    step.kappa = (kappa_tau - kappa * step.tau) / tau;
    step.s = p_.h * step.tau - p_.G * step.x - share * primal_residual();  // preserves feasibility
    return step;
  }

  [[nodiscard]] double step_length(const ConeScaling& W, const VectorXd& lambda, const Step& step,
                                   double max_length) const {
    double length = internal::step_to_cone(cones_, lambda, W.divide(step.s), max_length);
    length = internal::step_to_cone(cones_, lambda, W.times(step.z), length);
    if (step.tau < 0) length = std::min(length, -tau / step.tau);
    if (step.kappa < 0) length = std::min(length, -kappa / step.kappa);
    return length;
  }

  void advance(const Step& step, double length) {
    x += length * step.x;
    s += length * step.s;
    z += length * step.z;
    tau += length * step.tau;
    kappa += length * step.kappa;
  }

  const ReducedProgram& p_;
  const std::vector<int>& cones_;
  VectorXd e_;

 public:
  VectorXd x, s, z;
  double tau = 1, kappa = 1;
};

/// Errors of an iterate as solution and as certificates.
struct IterateQuality {
  double solved;      // KKT residual of (x, s, z) / tau
  double infeasible;  // residual of z as a certificate: |G'z| with h'z = -1
  double unbounded;   // residual of x as a certificate: |G x + s| with c'x = -1
};

IterateQuality measure_iterate(const ReducedProgram& p, const Embedding& e) {
  const double cx = p.c.dot(e.x) / e.tau, hz = p.h.dot(e.z) / e.tau;
  const double primal = e.primal_residual().norm() / e.tau / (1 + p.h.norm());
  const double dual = e.dual_residual().norm() / e.tau / (1 + p.c.norm());
  const double gap = std::abs(cx + hz) / (1 + std::abs(cx));
  const double hz_raw = p.h.dot(e.z), cx_raw = p.c.dot(e.x);
  return {max_or_nan({primal, dual, gap}),
          hz_raw < 0 ? (p.G.transpose() * e.z).norm() / -hz_raw : kInfinity,
          cx_raw < 0 ? (p.G * e.x + e.s).norm() / -cx_raw : kInfinity};
}

/// Best iterate and certificates of the reduced problem.
struct BestIterate {
  Status status = Status::kStalled;
  VectorXd v, z;
  double residual = kInfinity;
  double infeasible = kInfinity, unbounded = kInfinity;  // errors of the best certificates
  VectorXd infeasible_z, unbounded_v;                    // best certificates
  int iterations = 0, last_better = 0;  // iterations done, and the last one with an improvement
};

void update_best(BestIterate& best, const Embedding& e, const IterateQuality& progress) {
  // Keep the best certificates.
  if (progress.infeasible < best.infeasible || progress.unbounded < best.unbounded)
    best.last_better = best.iterations;
  if (progress.infeasible < best.infeasible) best.infeasible_z = e.z;
  if (progress.unbounded < best.unbounded) best.unbounded_v = e.x;
  best.infeasible = std::min(best.infeasible, progress.infeasible);
  best.unbounded = std::min(best.unbounded, progress.unbounded);
  // Keep the best iterate.
  if (!(progress.solved < best.residual)) return;
  best.last_better = best.iterations;
  best.residual = progress.solved;
  best.v = e.x / e.tau;
  best.z = e.z / e.tau;
}

/// Returns the status that the best iterate and the best certificates prove to a tolerance.
Status status_of(const BestIterate& best, double tolerance) {
  if (best.residual <= tolerance) return Status::kSolved;
  if (best.infeasible <= tolerance) return Status::kInfeasible;
  if (best.unbounded <= tolerance) return Status::kUnbounded;
  return Status::kStalled;
}

/// Iterates until something is proved, or nothing improves any more.
BestIterate solve_reduced(const ReducedProgram& p, const std::vector<int>& cones,
                          const ConeOptions& options) {
  Embedding embedding(p, cones);
  BestIterate best;
  best.v = VectorXd::Zero(p.c.size());
  best.z = VectorXd::Zero(p.h.size());
  for (;; ++best.iterations) {
    update_best(best, embedding, measure_iterate(p, embedding));
    best.status = status_of(best, options.tolerance);
    if (best.status != Status::kStalled) return best;
    const bool lost = !(embedding.tau > 0) || !embedding.z.allFinite() || !embedding.s.allFinite();
    if (lost || best.iterations == options.max_iterations ||
        best.iterations - best.last_better > kStalledIterations) {
      best.status = status_of(best, options.acceptable_tolerance);
      if (best.status == Status::kStalled && best.iterations == options.max_iterations)
        best.status = Status::kLimit;
      return best;
    }
    embedding.step();
  }
}

/// Solves A'y = rest for the multipliers of the equalities.
VectorXd equality_multipliers(const ConeProgram& p, const VectorXd& rest) {
  if (p.A.size() == 0) return VectorXd::Zero(p.b.size());
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(p.A.transpose()).solve(rest);
}

/// Returns the largest distance of the parts of v from their cones; negative if all are inside.
double outside_cones(const VectorXd& v, const std::vector<int>& cones) {
  double worst = 0;
  Index row = 0;
  for (const int size : cones) {
    worst = max_or_nan(worst, v.segment(row + 1, size - 1).norm() - v(row));
    row += size;
  }
  return worst;
}

/// Returns the largest KKT residual of the original program.
double residual_of(const ConeProgram& p, const ConeResult& r) {
  // Divide each error by one plus the size of its terms.
  const auto relative = [](double error, double size) { return error / (1 + size); };
  VectorXd stationary = p.c + p.G.transpose() * r.z;
  double equalities = 0;
  if (p.A.size() > 0) {
    stationary += p.A.transpose() * r.y;
    equalities = relative((p.A * r.x - p.b).norm(), p.b.norm());
  }
  return max_or_nan({equalities, relative(outside_cones(p.h - p.G * r.x, p.cones), p.h.norm()),
                     relative(stationary.norm(), p.c.norm()),
                     relative(outside_cones(r.z, p.cones), r.z.norm()),
                     relative(std::abs(r.objective - r.dual), std::abs(r.objective))});
}

/// Returns the error of y and z as a Farkas certificate of infeasibility: with A'y + G'z = e, z in
/// K and -(b'y + h'z) = g > 0, no x shorter than g / |e| is feasible.
/// @return the larger of |e| / g and the relative distance of z outside of K, infinite if g <= 0
double farkas_error(const ConeProgram& p, const VectorXd& y, const VectorXd& z) {
  VectorXd e = p.G.transpose() * z;
  double gain = -p.h.dot(z);
  if (p.A.size() > 0) e += p.A.transpose() * y;
  if (p.b.size() > 0) gain -= p.b.dot(y);
  if (!(gain > 0)) return kInfinity;
  return max_or_nan(e.norm() / gain, outside_cones(z, p.cones) / std::max(gain, z.norm()));
}

/// Returns the error of d as a direction along which the objective decreases without limit: A d =
/// 0, -G d in K, c'd < 0.
/// @return largest violation over -c'd; infinite if the objective does not decrease
double recession_error(const ConeProgram& p, const VectorXd& d) {
  const double gain = -p.c.dot(d);
  if (!(gain > 0)) return kInfinity;
  const double equalities = p.A.size() > 0 ? (p.A * d).norm() : 0;
  return max_or_nan(equalities, outside_cones(-p.G * d, p.cones)) / gain;
}

/// Sets kInfeasible if y and z of the result prove it; returns whether they do.
bool certify_infeasible(const ConeProgram& p, double max_error, ConeResult& result) {
  result.residual = farkas_error(p, result.y, result.z);
  if (result.residual <= max_error) result.status = Status::kInfeasible;
  return result.status == Status::kInfeasible;
}

/// Sets kUnbounded if the objective decreases along a direction and a feasible point exists; the
/// search for that point may prove kInfeasible instead. Returns whether the status was decided.
// NOLINTNEXTLINE(misc-no-recursion): recurses once, without objective
bool certify_unbounded(const ConeProgram& p, const VectorXd& direction, const ConeOptions& options,
                       double max_error, ConeResult& result) {
  const double error = recession_error(p, direction);
  if (!(error <= max_error)) return false;
  ConeProgram without_objective = p;
  without_objective.c.setZero();
  const ConeResult point = solve(without_objective, options);
  if (point.status == Status::kInfeasible) result = point;
  if (point.status != Status::kSolved) return point.status == Status::kInfeasible;
  result.status = Status::kUnbounded;
  result.residual = error;
  result.objective = result.dual = -kInfinity;
  return true;
}

}  // namespace

// NOLINTNEXTLINE(misc-no-recursion): recurses once, without objective
ConeResult solve(const ConeProgram& program, const ConeOptions& options) {
  check(program);
  const double max_error = 10 * options.acceptable_tolerance;
  const Presolve pre = presolve(program);
  ConeResult result;
  result.x = VectorXd::Zero(program.c.size());
  result.y = VectorXd::Zero(program.b.size());
  result.z = VectorXd::Zero(program.h.size());
  result.objective = result.dual = result.residual = kInfinity;
  // Inconsistent equalities prove infeasibility.
  if (!pre.reduced) {
    result.y = pre.misfit;
    (void)certify_infeasible(program, max_error, result);
    return result;
  }
  const BestIterate best = solve_reduced(*pre.reduced, program.cones, options);
  // Return to the original variables.
  const MatrixXd& N = pre.reduced->N;
  result.iterations = best.iterations;
  result.x = pre.reduced->x0 + N * best.v;

  // Verify claims of infeasibility and unboundedness on the original program.
  if (best.status == Status::kInfeasible) {
    result.z = best.infeasible_z;
    result.y = equality_multipliers(program, -program.G.transpose() * result.z);
    if (certify_infeasible(program, max_error, result)) return result;
  }
  const bool has_descent = best.status == Status::kSolved && pre.descent.size() > 0;
  if ((best.status == Status::kUnbounded || has_descent) &&
      certify_unbounded(program, has_descent ? pre.descent : VectorXd(N * best.unbounded_v),
                        options, max_error, result))
    return result;

  // Compute multipliers and residual of the original program.
  result.z = best.z;
  result.y = equality_multipliers(program, -program.c - program.G.transpose() * result.z);
  result.objective = program.c.dot(result.x);
  result.dual = -program.b.dot(result.y) - program.h.dot(result.z);
  result.residual = max_or_nan(best.residual, residual_of(program, result));
  if (best.status == Status::kSolved && !has_descent && result.residual <= max_error)
    result.status = Status::kSolved;
  else if (best.status == Status::kLimit)
    result.status = Status::kLimit;
  return result;
}

}  // namespace thenar
