#pragma once

/// Processes that share a run. One alone unless started by mpirun.
///
/// All ranks must meet the same gathers in the same order. Who catches an error that the others do
/// not have must call abort(): they would wait for ever.

#include <memory>
#include <string>

#include <Eigen/Core>

namespace thenar {

class Ranks {
 public:
  virtual ~Ranks() = default;
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// The vectors of all ranks, one after the other; lengths may differ.
  [[nodiscard]] virtual Eigen::VectorXd all_gather(const Eigen::VectorXd& mine) const = 0;
  virtual void barrier() const = 0;
  /// Ends all ranks at once, because this one cannot go on; of several, it writes why to stderr,
  /// as nobody is left to catch it. One alone throws InputError.
  [[noreturn]] virtual void abort(const std::string& why) const = 0;
};

/// This process alone.
[[nodiscard]] std::unique_ptr<Ranks> one_rank();

/// All processes that mpirun started; one_rank() if there is no mpirun. To be called once, and kept
/// until the end of main(): MPI is finalised with it.
/// MPI_Init must come from libmpi: Debian's sequential MUMPS (below Ipopt) has a fake one.
/// @throws InputError if it does not, or if mpirun started us and no MPI was built in.
[[nodiscard]] std::unique_ptr<Ranks> world_ranks();

}  // namespace thenar
