#include "posterior/kernel/batch.h"

#include <algorithm>
#include <array>
#include <new>

namespace thenar::kernel {
namespace {

constexpr std::align_val_t kAlignment{64};
constexpr int kMostLanes = 8;

/// Columns of a matrix, the last one again in lanes that are left over.
template <typename Matrix, typename Column>
std::array<Column, kMostLanes> columns(Matrix& matrix, Eigen::Index first, int count) {
  std::array<Column, kMostLanes> columns;
  for (int k = 0; k < kMostLanes; ++k)
    columns[k] = matrix.data() + (first + std::min(k, count - 1)) * matrix.outerStride();
  return columns;
}
std::array<const double*, kMostLanes> columns_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                                                 Eigen::Index first, int count) {
  return columns<const Eigen::Ref<const Eigen::MatrixXd>, const double*>(matrix, first, count);
}
std::array<double*, kMostLanes> columns_of(Eigen::MatrixXd& matrix, Eigen::Index first, int count) {
  return columns<Eigen::MatrixXd, double*>(matrix, first, count);
}

/// The narrowest unit for so many points, or the widest.
const Unit& unit_for(const std::vector<Unit>& choice, Eigen::Index points) {
  for (auto unit = choice.rbegin(); unit != choice.rend(); ++unit)
    if (unit->lanes >= points) return *unit;
  return choice.front();
}

Packs packs(const Unit& unit, long length) { return Packs(length * unit.lanes); }

}  // namespace

Packs::Packs(long doubles)
    : first_(static_cast<double*>(
          ::operator new(static_cast<std::size_t>(doubles) * sizeof(double), kAlignment))) {}
void Packs::Free::operator()(double* p) const { ::operator delete(p, kAlignment); }

Batch run_batch(const Program& program, const std::vector<Unit>& choice,
                const Eigen::Ref<const Eigen::MatrixXd>& u, KeepTape keep) {
  Batch batch{Eigen::MatrixXd(3 * program.trials, u.cols()), {}};
  const Unit& widest = choice.front();
  const Packs scratch = packs(widest, widest.scratch_length(program));
  Packs tape(0);
  for (Eigen::Index first = 0; first < u.cols();) {
    const Unit& unit = unit_for(choice, u.cols() - first);
    const int count = static_cast<int>(std::min<Eigen::Index>(unit.lanes, u.cols() - first));
    if (keep == KeepTape::kYes || first == 0) tape = packs(unit, unit.tape_length(program));
    unit.run(program, columns_of(u, first, count).data(), count, tape.first(), scratch.first(),
             columns_of(batch.forces, first, count).data());
    if (keep == KeepTape::kYes) batch.groups.push_back({&unit, first, count, std::move(tape)});
    first += count;
  }
  return batch;
}

Eigen::MatrixXd pull_batch(const Program& program, const Batch& batch,
                           const Eigen::Ref<const Eigen::MatrixXd>& weights) {
  Eigen::MatrixXd gradient(program.fit_coordinates, weights.cols());
  if (batch.groups.empty()) return gradient;
  const Unit& widest = *batch.groups.front().unit;
  const Packs scratch = packs(widest, widest.scratch_length(program));
  for (const Group& group : batch.groups)
    group.unit->pull(program, group.tape.first(),
                     columns_of(weights, group.first, group.count).data(), group.count,
                     scratch.first(), columns_of(gradient, group.first, group.count).data());
  return gradient;
}

}  // namespace thenar::kernel
