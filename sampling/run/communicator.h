#pragma once

/// Communication between the processes (ranks) of a run; a single process unless started by mpirun.
///
/// All ranks must reach the same gathers in the same order. A rank that catches an error which the
/// others do not have must call abort(): otherwise they wait forever.

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "base/error.h"

namespace thenar {

/// Processes of a run.
class Communicator {
 public:
  virtual ~Communicator() = default;
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  /// Concatenates the vectors of all ranks; lengths may differ.
  [[nodiscard]] virtual Eigen::VectorXd all_gather(const Eigen::VectorXd& mine) const = 0;
  virtual void barrier() const = 0;
  /// Ends all ranks at once because this one cannot continue. With several ranks it writes the
  /// reason to stderr, because no exception reaches the others; a single process throws InputError.
  [[noreturn]] virtual void abort(const std::string& why) const = 0;
};

/// Returns the communicator of this process alone.
[[nodiscard]] std::unique_ptr<Communicator> single_process();

/// Returns all processes that mpirun started; single_process() without mpirun. Call it once and
/// keep the result until the end of main(): its destructor finalises MPI. MPI_Init must come from
/// libmpi: Debian's sequential MUMPS (used by Ipopt) contains a dummy one.
/// @throws InputError if MPI_Init is the dummy, or if mpirun started a program built without MPI.
[[nodiscard]] std::unique_ptr<Communicator> world_communicator();

}  // namespace thenar

namespace thenar::internal {

/// Gathers the strings of all ranks, in order, on every rank.
[[nodiscard]] std::vector<std::string> all_gather_bytes(const Communicator& ranks,
                                                        const std::string& mine);

}  // namespace thenar::internal

namespace thenar {

/// Runs work() on every rank and throws on all ranks if it failed on one: each rank throws its own
/// error, or the error of the first rank that has one, so that no rank waits for another that has
/// failed. Every rank must call it, and `work` must not gather.
template <typename Work>
void collective_call(const Communicator& ranks, Work work) {
  std::exception_ptr mine;
  std::string message;  // "!" and the error message; empty: none
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

/// Does work on all ranks together. An exception of the first rank is thrown there after MPI has
/// ended, those of other ranks are dropped.
/// @param work  function of the communicator  @return its result on the first rank, else nothing
template <typename Work>
[[nodiscard]] auto result_of_first_rank(const Work& work) {
  std::optional<decltype(work(std::declval<const Communicator&>()))> result;
  // The communicator ends with this block, before an exception leaves it.
  std::exception_ptr failure;
  {
    const std::unique_ptr<Communicator> ranks = world_communicator();
    try {
      auto found = work(*ranks);
      if (ranks->rank() == 0) result = std::move(found);
    } catch (const std::exception&) {
      if (ranks->rank() == 0) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
  return result;
}

}  // namespace thenar
