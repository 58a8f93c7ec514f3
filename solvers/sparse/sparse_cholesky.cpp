#include "solvers/sparse/sparse_cholesky.h"

#include <algorithm>

#include <suitesparse/cholmod.h>

#include "base/error.h"

// Functions of the OpenMP runtime with which CHOLMOD is linked; omp.h belongs to the compiler, and
// each compiler has its own runtime.
extern "C" int omp_get_max_active_levels();
extern "C" void omp_set_max_active_levels(int);

namespace thenar {
namespace {

/// Scope in which CHOLMOD's parallel regions run on the calling thread. CHOLMOD starts threads for
/// many small parts, which wait for each other: matrices of a few thousand rows then take longer,
/// and much more processor time.
class SingleThreadScope {
 public:
  SingleThreadScope() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  SingleThreadScope(const SingleThreadScope&) = delete;
  SingleThreadScope& operator=(const SingleThreadScope&) = delete;
  ~SingleThreadScope() { omp_set_max_active_levels(levels_); }

 private:
  int levels_;
};

}  // namespace

struct SparseCholesky::Parts {
  explicit Parts(SymmetricPattern p) : pattern(std::move(p)) {
    cholmod_start(&common);
    common.print = 0;
    // The status of the factor reports that a matrix is not positive definite.
    common.quick_return_if_not_posdef = 1;
    common.final_ll = 1;  // LDL' would accept negative D
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(pattern.size);
    matrix.nzmax = pattern.rows.size();
    matrix.p = pattern.starts.data();
    matrix.i = pattern.rows.data();
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = matrix.packed = 1;
    values.assign(pattern.rows.size(), 1);
    matrix.x = values.data();
    factor = cholmod_analyze(&matrix, &common);
    require(factor != nullptr, "a matrix of {} rows could not be analysed", pattern.size);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
  ~Parts() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_dense(&answer, &common);
    cholmod_free_dense(&work_y, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_finish(&common);
  }

  SymmetricPattern pattern;
  std::vector<double> values;
  cholmod_common common{};
  cholmod_sparse matrix{};
  cholmod_factor* factor = nullptr;
  bool is_factored = false;
  cholmod_dense *answer = nullptr, *work_y = nullptr, *work_e = nullptr;
};

SparseCholesky::SparseCholesky(SymmetricPattern pattern) {
  require(pattern.starts.size() == static_cast<std::size_t>(pattern.size) + 1 &&
              pattern.starts.front() == 0 &&
              pattern.starts.back() == static_cast<int>(pattern.rows.size()) &&
              std::is_sorted(pattern.starts.begin(), pattern.starts.end()),
          "a pattern of {} columns has {} starts", pattern.size, pattern.starts.size());
  for (int j = 0; j < pattern.size; ++j) {
    const auto from = static_cast<std::size_t>(pattern.starts[j]);
    const auto to = static_cast<std::size_t>(pattern.starts[static_cast<std::size_t>(j) + 1]);
    require(from < to && pattern.rows[from] == j && pattern.rows[to - 1] < pattern.size,
            "column {} of a pattern does not begin at its diagonal", j);
    for (std::size_t k = from + 1; k < to; ++k)
      require(pattern.rows[k - 1] < pattern.rows[k], "rows of column {} do not rise", j);
  }
  parts_ = std::make_unique<Parts>(std::move(pattern));
}

SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;
SparseCholesky::~SparseCholesky() = default;

const SymmetricPattern& SparseCholesky::pattern() const { return parts_->pattern; }

bool SparseCholesky::factor(const std::vector<double>& values) {
  require(values.size() == parts_->pattern.rows.size(), "{} values for {} entries", values.size(),
          parts_->pattern.rows.size());
  parts_->is_factored = false;
  if (!Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))
           .allFinite())
    return false;
  parts_->matrix.x = const_cast<double*>(values.data());  // read only
  const SingleThreadScope one_thread;
  const int succeeded = cholmod_factorize(&parts_->matrix, parts_->factor, &parts_->common);
  parts_->matrix.x = nullptr;
  parts_->is_factored = succeeded != 0 && parts_->common.status == CHOLMOD_OK &&
                        parts_->factor->minor == static_cast<std::size_t>(parts_->pattern.size);
  return parts_->is_factored;
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& b) const {
  Parts& parts = *parts_;
  require(parts.is_factored, "a matrix of {} rows has no factor", parts.pattern.size);
  require(b.rows() == parts.pattern.size, "a matrix of {} rows cannot solve {}", parts.pattern.size,
          b.rows());
  cholmod_dense right_side{};
  right_side.nrow = right_side.d = static_cast<std::size_t>(b.rows());
  right_side.ncol = static_cast<std::size_t>(b.cols());
  right_side.nzmax = static_cast<std::size_t>(b.size());
  right_side.x = const_cast<double*>(b.data());  // read only
  right_side.xtype = CHOLMOD_REAL;
  right_side.dtype = CHOLMOD_DOUBLE;
  const SingleThreadScope one_thread;
  const int succeeded = cholmod_solve2(CHOLMOD_A, parts.factor, &right_side, nullptr, &parts.answer,
                                       nullptr, &parts.work_y, &parts.work_e, &parts.common);
  require(succeeded != 0, "a system of {} rows could not be solved", b.rows());
  return Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(parts.answer->x), b.rows(),
                                           b.cols());
}

double SparseCholesky::fill() const { return parts_->common.lnz; }

}  // namespace thenar
