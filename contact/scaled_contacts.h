#pragma once

/// Dimensionless contact problem of intervals and cones.

#include <vector>

#include <Eigen/Core>

#include "contact/contact_problem.h"

namespace thenar::internal {

/// Block of an interval  lower <= f <= upper  (one row), or of a cone  |t| <= mu n  (three or four
/// rows). Bilateral rows are unbounded intervals; rows that can have no impulse (tangents without
/// friction, torsion without radius) are intervals [0, 0].
struct ScaledBlock {
  int start = 0, rows = 1;      // first row and number of rows
  double mu = -1;               // coefficient of friction of a cone; negative: an interval [1]
  double lower = 0, upper = 0;  // bounds of an interval [sqrt(J)]

  [[nodiscard]] bool is_cone() const { return rows > 1; }
};

/// Scaled contact problem  u' = A f' + b'  with  f = s f',  u' = s u,  A = s W s  and the scales s
/// of ContactResidual.
class ScaledContacts {
 public:
  /// Scales a problem. Memory is allocated only for more rows or blocks than ever before.
  /// @param problem  problem that satisfies check_contact_problem()
  void assign(const ContactProblem& problem);

  [[nodiscard]] Eigen::Index rows() const { return rows_; }
  [[nodiscard]] const std::vector<ScaledBlock>& blocks() const { return blocks_; }
  [[nodiscard]] auto A() const { return A_.topLeftCorner(rows_, rows_); }  // (rows, rows)
  [[nodiscard]] auto b() const { return b_.head(rows_); }                  // (rows) [sqrt(J)]
  [[nodiscard]] auto s() const { return s_.head(rows_); }                  // (rows)
  [[nodiscard]] double scale() const { return scale_; }                    // [sqrt(J)]

  /// Returns the largest entry of the natural map, over the scale [1].
  /// @param f, u  scaled impulses and velocities (rows)
  [[nodiscard]] double residual(const Eigen::Ref<const Eigen::VectorXd>& f,
                                const Eigen::Ref<const Eigen::VectorXd>& u) const;

  /// Returns ContactResidual::rounding of scaled impulses, at most kMaxRounding [1].
  [[nodiscard]] double rounding(const Eigen::Ref<const Eigen::VectorXd>& f) const;

 private:
  void add_block(const ContactBlock& block, int start, double s);

  std::vector<ScaledBlock> blocks_;
  // Storage, of which the first rows_ entries are used
  Eigen::MatrixXd A_;
  Eigen::VectorXd b_, s_;
  Eigen::Index rows_ = 0;
  double scale_ = 0;
};

}  // namespace thenar::internal
