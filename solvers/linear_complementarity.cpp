#include "solvers/linear_complementarity.h"

#include <cmath>
#include <vector>

#include <Eigen/LU>

#include "base/error.h"
#include "base/stop_scope.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Minimum pivot over the largest entry of its column [1]
constexpr double kPivotTolerance = 1e-11;
constexpr double kTieTolerance = 1e-12;    // relative difference below which ratios are equal [1]
constexpr double kFarkasTolerance = 1e-9;  // relative rounding error of a Farkas certificate [1]
constexpr int kPivotsPerTableau = 60;      // number of pivots after which the tableau is recomputed

double nonzero_or_one(double size) { return size > 0 ? size : 1; }

/// Tableau of Lemke's method. Variables 0 .. n-1 are w, n .. 2n-1 are z, 2n is the artificial z0.
class LemkeTableau {
 public:
  explicit LemkeTableau(const LinearComplementarity& problem)
      : n_(problem.q.size()), all_(n_, 2 * n_ + 2), basis_(static_cast<std::size_t>(n_)) {
    // Set up w - M z - z0 = q.
    all_.leftCols(n_).setIdentity();
    all_.middleCols(n_, n_) = -problem.M;
    all_.col(2 * n_).setConstant(-1);
    all_.col(2 * n_ + 1) = problem.q;
    table_ = all_;
    for (Index i = 0; i < n_; ++i) basis_[i] = i;
  }

  [[nodiscard]] Index artificial() const { return 2 * n_; }
  [[nodiscard]] Index basic_variable(Index row) const { return basis_[row]; }
  [[nodiscard]] Index complement(Index variable) const {
    return variable < n_ ? variable + n_ : variable - n_;
  }

  /// Returns the leaving row for an entering column: the lexicographic minimum of (q, B^-1) /
  /// entry; -1: none. z0 is preferred among ties.
  [[nodiscard]] Index leaving_row(Index column) const {
    const VectorXd a = table_.col(column);
    const double min_pivot = kPivotTolerance * std::max(a.cwiseAbs().maxCoeff(), 1e-3);
    Index best = -1;
    for (Index i = 0; i < n_; ++i)
      if (a(i) > min_pivot && (best < 0 || is_smaller(i, best, a))) best = i;
    if (best < 0) return best;
    for (Index i = 0; i < n_; ++i)
      if (basic_variable(i) == artificial() && a(i) > min_pivot &&
          ratio_gap(i, best, a, 2 * n_ + 1) == 0)
        return i;
    return best;
  }

  /// Returns the row of the lexicographically smallest q, where z0 enters.
  [[nodiscard]] Index initial_row() const {
    const VectorXd ones = VectorXd::Ones(n_);
    Index best = 0;
    for (Index i = 1; i < n_; ++i)
      if (is_smaller(i, best, ones)) best = i;
    return best;
  }

  /// Pivots on an entry of the tableau.
  void pivot(Index row, Index column) {
    basis_[row] = column;
    if (++pivots_ % kPivotsPerTableau == 0 && rebuild()) return;
    table_.row(row) /= table_(row, column);
    const VectorXd a = table_.col(column);
    for (Index j = 0; j < table_.cols(); ++j) {
      const double head = table_(row, j);
      if (head == 0) continue;
      table_.col(j) -= head * a;
      table_(row, j) = head;
    }
  }

  /// Returns whether z0 is zero to rounding: the basis is a solution even if z0 is still basic.
  [[nodiscard]] bool is_artificial_zero() const {
    for (Index i = 0; i < n_; ++i)
      if (basic_variable(i) == artificial())
        return std::abs(table_(i, 2 * n_ + 1)) <=
               kTieTolerance * nonzero_or_one(all_.col(2 * n_ + 1).cwiseAbs().maxCoeff());
    return true;
  }

  /// Returns z of the basis, without z0.
  [[nodiscard]] VectorXd basic_solution() const {
    VectorXd out = VectorXd::Zero(n_);
    for (Index i = 0; i < n_; ++i)
      if (basic_variable(i) >= n_ && basic_variable(i) < 2 * n_)
        out(basic_variable(i) - n_) = std::max(table_(i, 2 * n_ + 1), 0.0);
    return out;
  }
  /// Returns the direction of z as `column` grows without limit.
  [[nodiscard]] VectorXd ray(Index column) const {
    VectorXd out = VectorXd::Zero(n_);
    if (column >= n_ && column < 2 * n_) out(column - n_) = 1;
    for (Index i = 0; i < n_; ++i)
      if (basic_variable(i) >= n_ && basic_variable(i) < 2 * n_)
        out(basic_variable(i) - n_) = std::max(-table_(i, column), 0.0);
    return out;
  }
  [[nodiscard]] std::vector<Index> basic_z() const {
    std::vector<Index> out;
    for (const Index variable : basis_)
      if (variable >= n_ && variable < 2 * n_) out.push_back(variable - n_);
    return out;
  }

 private:
  /// Returns the difference of two rows' ratios in a column, 0 within rounding.
  [[nodiscard]] double ratio_gap(Index i, Index k, const VectorXd& a, Index column) const {
    const double x = table_(i, column) / a(i), y = table_(k, column) / a(k);
    return std::abs(x - y) <= kTieTolerance * std::max({std::abs(x), std::abs(y), 1e-300}) ? 0
                                                                                           : x - y;
  }
  [[nodiscard]] bool is_smaller(Index i, Index k, const VectorXd& a) const {
    double gap = ratio_gap(i, k, a, 2 * n_ + 1);
    for (Index column = 0; gap == 0 && column < n_; ++column) gap = ratio_gap(i, k, a, column);
    return gap < 0;
  }
  /// Recomputes the tableau of this basis from the data; false if the basis is singular.
  bool rebuild() {
    MatrixXd B(n_, n_);
    for (Index i = 0; i < n_; ++i) B.col(i) = all_.col(basic_variable(i));
    const MatrixXd built = B.partialPivLu().solve(all_);
    if (!built.allFinite() || !((B * built - all_).cwiseAbs().maxCoeff() <
                                1e-9 * nonzero_or_one(all_.cwiseAbs().maxCoeff())))
      return false;
    table_ = built;
    return true;
  }

  Index n_;
  MatrixXd all_, table_;  // [I, -M, -1, q], and its product with B^-1 (n, 2 n + 2)
  std::vector<Index> basis_;
  int pivots_ = 0;
};

/// Returns z of the final basis, solved again from M and q; that of the tableau if it is better.
VectorXd refined_z(const LinearComplementarity& problem, const LemkeTableau& tableau) {
  VectorXd tableau_z = tableau.basic_solution();
  const std::vector<Index> basic = tableau.basic_z();
  if (basic.empty()) return tableau_z;
  const MatrixXd sub = problem.M(basic, basic);
  const VectorXd q = problem.q(basic);
  const Eigen::PartialPivLU<MatrixXd> lu(sub);
  VectorXd part = lu.solve(-q);
  part -= lu.solve(sub * part + q);
  VectorXd solved_z = VectorXd::Zero(problem.q.size());
  solved_z(basic) = part.cwiseMax(0.0);
  if (!solved_z.allFinite()) return tableau_z;
  return complementarity_residual(problem, solved_z) <= complementarity_residual(problem, tableau_z)
             ? solved_z
             : tableau_z;
}

void check(const LinearComplementarity& problem) {
  require(problem.M.rows() == problem.q.size() && problem.M.cols() == problem.q.size(),
          "q has {} rows, M is {} by {}", problem.q.size(), problem.M.rows(), problem.M.cols());
  require(problem.M.allFinite() && problem.q.allFinite(), "M and q must be finite");
}

void finish(const LinearComplementarity& problem, double tolerance, ComplementaritySolution* out) {
  out->w = problem.M * out->z + problem.q;
  out->residual = complementarity_residual(problem, out->z);
  if (out->residual <= tolerance) out->status = Status::kSolved;
}

}  // namespace

double complementarity_residual(const LinearComplementarity& problem, const VectorXd& z) {
  if (z.size() == 0) return 0;
  const VectorXd w = problem.M * z + problem.q;
  const double w_size = nonzero_or_one(problem.q.cwiseAbs().maxCoeff()),
               z_size = nonzero_or_one(z.cwiseAbs().maxCoeff());
  return (z / z_size).cwiseMin(w / w_size).cwiseAbs().maxCoeff();
}

bool proves_infeasible(const LinearComplementarity& problem, const VectorXd& y) {
  if (y.size() == 0 || !(y.minCoeff() >= 0) || !(y.maxCoeff() > 0)) return false;
  const double size = y.maxCoeff();
  const VectorXd scale = problem.M.cwiseAbs().transpose() * y;
  const VectorXd column = problem.M.transpose() * y;
  const double value = problem.q.dot(y);
  return (column.array() <= kFarkasTolerance * (scale.array() + 1e-300)).all() &&
         value < -kFarkasTolerance * size * problem.q.cwiseAbs().maxCoeff();
}

ComplementaritySolution solve_complementarity(const LinearComplementarity& problem,
                                              const ComplementarityOptions& options) {
  check(problem);
  const Index n = problem.q.size();
  ComplementaritySolution out;
  out.z = VectorXd::Zero(n);
  finish(problem, options.tolerance, &out);
  if (n == 0 || problem.q.minCoeff() >= 0) return out;

  // Let z0 enter at the smallest q, then always the complement of the variable that left.
  LemkeTableau tableau(problem);
  Index row = tableau.initial_row(), entering = tableau.artificial();
  const Index max_pivots = options.max_pivots > 0 ? options.max_pivots : 50 * (n + 1);
  while (true) {
    const Index leaving = tableau.basic_variable(row);
    end_if_stopped();
    tableau.pivot(row, entering);
    ++out.pivots;
    if (leaving == tableau.artificial() || tableau.is_artificial_zero()) break;
    if (out.pivots >= max_pivots) {
      out.status = Status::kLimit;
      out.message = "limit of pivots";
      break;
    }
    entering = tableau.complement(leaving);
    row = tableau.leaving_row(entering);
    if (row < 0) {
      out.ray = tableau.ray(entering);
      out.message = "ended on a ray";
      break;
    }
  }
  // Solve the final basis again, and check for infeasibility.
  out.z = refined_z(problem, tableau);
  finish(problem, options.tolerance, &out);
  if (out.status != Status::kSolved && proves_infeasible(problem, out.ray)) {
    out.status = Status::kInfeasible;
    out.message = "no z >= 0 has M z + q >= 0";
  }
  return out;
}

}  // namespace thenar
