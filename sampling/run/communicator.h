#pragma once

/// Processes that share a run. One alone unless started by mpirun.
///
/// All ranks must meet the same gathers in the same order. Who catches an error that the others do
/// not have must call abort(): they would wait for ever.

#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/error.h"

namespace thenar {

class Communicator {
 public:
  virtual ~Communicator() = default;
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
[[nodiscard]] std::unique_ptr<Communicator> single_process();

/// All processes that mpirun started; single_process() if there is no mpirun. To be called once,
/// and kept until the end of main(): MPI is finalised with it. MPI_Init must come from libmpi:
/// Debian's sequential MUMPS (below Ipopt) has a fake one.
/// @throws InputError if it does not, or if mpirun started us and no MPI was built in.
[[nodiscard]] std::unique_ptr<Communicator> world_communicator();

}  // namespace thenar

namespace thenar::internal {

/// The strings of all ranks, in their order; every rank gets all of them.
[[nodiscard]] std::vector<std::string> all_gather_bytes(const Communicator& ranks,
                                                        const std::string& mine);

}  // namespace thenar::internal

namespace thenar {

// Work that several ranks do side by side, and whose failure they share.

/// Calls work() on this rank; once all ranks have, throws on every one if it threw on any: each its
/// own error, or that of the first rank that has one. So nobody waits for a rank that has given up.
/// Every rank must call it alike, and `work` must meet no gathers.
template <typename Work>
void collective_call(const Communicator& ranks, Work work) {
  std::exception_ptr mine;
  std::string message;  // "!" and the error; empty: none
  try {
    work();
  } catch (const std::exception& error) {
    mine = std::current_exception();
    message = std::string("!") + error.what();
  }
  const auto all = internal::all_gather_bytes(ranks, message);
  if (mine) std::rethrow_exception(mine);
  for (const std::string& other : all)
    if (!other.empty()) throw Error(other.substr(1));
}

}  // namespace thenar
