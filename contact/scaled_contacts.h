#pragma once

/// A contact problem without units, of intervals and cones alone.

#include <vector>

#include <Eigen/Core>

#include "contact/contact_problem.h"

namespace thenar::internal {

/// Rows of an interval  lower <= f <= upper  (one), or of a cone  |t| <= mu n  (three or four).
/// Bilateral rows are intervals without ends; rows that a block cannot load (tangents without
/// friction, torsion without radius) are intervals [0, 0].
struct ScaledBlock {
  int start = 0, rows = 1;
  double mu = -1;               // of a cone; negative: an interval
  double lower = 0, upper = 0;  // of an interval [sqrt(J)]

  [[nodiscard]] bool is_cone() const { return rows > 1; }
};

/// u' = A f' + b'  with  f = s f',  u' = s u,  A = s W s  and  s  of ContactResidual. Vectors and
/// matrices have room to spare, of which the first rows() entries count.
class ScaledContacts {
 public:
  /// The heap is asked only for more rows or blocks than there have been.
  /// @param problem  as check_contact_problem() asks
  void assign(const ContactProblem& problem);

  [[nodiscard]] Eigen::Index rows() const { return rows_; }
  [[nodiscard]] const std::vector<ScaledBlock>& blocks() const { return blocks_; }
  [[nodiscard]] auto A() const { return A_.topLeftCorner(rows_, rows_); }  // (rows, rows)
  [[nodiscard]] auto b() const { return b_.head(rows_); }                  // (rows) [sqrt(J)]
  [[nodiscard]] auto s() const { return s_.head(rows_); }                  // (rows)
  [[nodiscard]] double scale() const { return scale_; }                    // [sqrt(J)]

  /// Largest entry of the natural map, over the scale.
  /// @param f, u  scaled (rows)
  [[nodiscard]] double residual(const Eigen::Ref<const Eigen::VectorXd>& f,
                                const Eigen::Ref<const Eigen::VectorXd>& u) const;

  /// ContactResidual::rounding, up to what counts.
  [[nodiscard]] double rounding(const Eigen::Ref<const Eigen::VectorXd>& f) const;

 private:
  void add(const ContactBlock& block, int start, double s);

  std::vector<ScaledBlock> blocks_;
  Eigen::MatrixXd A_;
  Eigen::VectorXd b_, s_;
  Eigen::Index rows_ = 0;
  double scale_ = 0;
};

}  // namespace thenar::internal
