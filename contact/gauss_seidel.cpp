#include "contact/gauss_seidel.h"

#include "base/stop_scope.h"

namespace thenar::internal {

void GaussSeidel::assign(const ScaledContacts& contacts) {
  local_.clear();
  for (const ScaledBlock& block : contacts.blocks()) {
    if (!block.is_cone()) continue;
    // Factor the cone's own matrix once for all sweeps.
    local_.emplace_back();
    local_.back().assign(contacts.A().block(block.start, block.start, block.rows, block.rows));
  }
}

void GaussSeidel::sweep(const ScaledContacts& contacts, int sweeps,
                        Eigen::Ref<Eigen::VectorXd> f) const {
  const auto A = contacts.A();
  const auto b = contacts.b();
  for (int k = 0; k < sweeps; ++k) {
    end_if_stopped();
    auto local = local_.begin();
    for (const ScaledBlock& block : contacts.blocks()) {
      const int i = block.start;
      if (!block.is_cone()) {
        // Interval: velocity q without its own impulse, then the local solution.
        const double q = b(i) + A.col(i).dot(f) - A(i, i) * f(i);
        f(i) = solve_interval(block, A(i, i), q, f(i));
        continue;
      }
      // Cone: velocity q without the block's own impulse, then the local solution.
      Eigen::Vector4d q = Eigen::Vector4d::Zero();
      for (int r = 0; r < block.rows; ++r) q(r) = b(i + r) + A.col(i + r).dot(f);
      q.head(block.rows).noalias() -=
          A.block(i, i, block.rows, block.rows).lazyProduct(f.segment(i, block.rows));
      const Eigen::Vector4d solution =
          (local++)->solve(q.head(block.rows), block.mu, f.segment(i, block.rows));
      f.segment(i, block.rows) = solution.head(block.rows);
    }
  }
}

}  // namespace thenar::internal
