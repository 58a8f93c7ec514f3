#pragma once

/// Work of all processes of mpirun, whose result the first one has.

#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include "sampling/run/communicator.h"

namespace thenar {

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
