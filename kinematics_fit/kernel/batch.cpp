#include "kinematics_fit/kernel/batch.h"

#include <algorithm>
#include <array>
#include <new>

namespace thenar::kernel {
namespace {

constexpr std::align_val_t kLineAlignment{64};  // size of a cache line [bytes]
constexpr int kMaxLanes = 8;  // largest number of doubles in a register; as many fill a cache line

/// Rounds a number of doubles up to whole cache lines.
long padded(long doubles) { return (doubles + kMaxLanes - 1) / kMaxLanes * kMaxLanes; }

/// Returns pointers to columns of a matrix; surplus lanes repeat the last column.
template <typename Matrix, typename Column>
std::array<Column, kMaxLanes> columns(Matrix& matrix, Eigen::Index first, int count) {
  std::array<Column, kMaxLanes> columns;
  for (int k = 0; k < kMaxLanes; ++k)
    columns[k] = matrix.data() + (first + std::min(k, count - 1)) * matrix.outerStride();
  return columns;
}
std::array<const double*, kMaxLanes> columns_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                                                Eigen::Index first, int count) {
  return columns<const Eigen::Ref<const Eigen::MatrixXd>, const double*>(matrix, first, count);
}
std::array<double*, kMaxLanes> columns_of(Eigen::MatrixXd& matrix, Eigen::Index first, int count) {
  return columns<Eigen::MatrixXd, double*>(matrix, first, count);
}

/// Returns the narrowest backend for a number of points, or else the widest.
const SimdBackend& backend_for(const std::vector<SimdBackend>& choice, Eigen::Index points) {
  for (auto backend = choice.rbegin(); backend != choice.rend(); ++backend)
    if (backend->lanes >= points) return *backend;
  return choice.front();
}

/// Groups of points, with offsets and total length of their tapes in memory [doubles].
struct Division {
  std::vector<Group> groups;
  std::vector<long> begins;
  long length = 0;
};
Division divide(const Program& program, const std::vector<SimdBackend>& choice, Eigen::Index points,
                KeepTape keep) {
  Division all;
  for (Eigen::Index first = 0; first < points;) {
    // Take as many points as the backend evaluates at once.
    const SimdBackend& backend = backend_for(choice, points - first);
    const int count = static_cast<int>(std::min<Eigen::Index>(backend.lanes, points - first));
    // Place tapes one behind the other, or all in the same place.
    const long tape = padded(backend.lanes * backend.tape_length(program));
    all.begins.push_back(keep == KeepTape::kYes ? all.length : 0);
    all.length = keep == KeepTape::kYes ? all.length + tape : std::max(all.length, tape);
    all.groups.push_back({&backend, first, count, nullptr});
    first += count;
  }
  return all;
}

long scratch_doubles(const Program& program, const SimdBackend& backend) {
  return padded(backend.lanes * backend.scratch_length(program));
}

}  // namespace

SimdBuffer::SimdBuffer(long doubles)
    : first_(static_cast<double*>(
          ::operator new(static_cast<std::size_t>(doubles) * sizeof(double), kLineAlignment))) {}
void SimdBuffer::Free::operator()(double* p) const { ::operator delete(p, kLineAlignment); }

Batch run_batch(const Program& program, const std::vector<SimdBackend>& choice,
                const Eigen::Ref<const Eigen::MatrixXd>& u, KeepTape keep) {
  // Allocate the workspace and the tapes in one block of memory.
  Division division = divide(program, choice, u.cols(), keep);
  const long scratch = scratch_doubles(program, choice.front());
  Batch batch{Eigen::MatrixXd(3 * program.trials, u.cols()), std::move(division.groups),
              SimdBuffer(scratch + division.length)};
  for (std::size_t g = 0; g < batch.groups.size(); ++g) {
    // Run each group in the same workspace.
    Group& group = batch.groups[g];
    group.tape = batch.memory.first() + scratch + division.begins[g];
    group.backend->run(program, columns_of(u, group.first, group.count).data(), group.count,
                       group.tape, batch.memory.first(),
                       columns_of(batch.forces, group.first, group.count).data(), keep);
  }
  return batch;
}

Eigen::MatrixXd adjoint_batch(const Program& program, const Batch& batch,
                              const Eigen::Ref<const Eigen::MatrixXd>& weights) {
  Eigen::MatrixXd gradient(program.fit_coordinates, weights.cols());
  if (batch.groups.empty()) return gradient;
  // Use the tapes of the run, with a new workspace.
  const SimdBuffer scratch(scratch_doubles(program, *batch.groups.front().backend));
  for (const Group& group : batch.groups)
    group.backend->run_adjoint(
        program, group.tape, columns_of(weights, group.first, group.count).data(), group.count,
        scratch.first(), columns_of(gradient, group.first, group.count).data());
  return gradient;
}

}  // namespace thenar::kernel
