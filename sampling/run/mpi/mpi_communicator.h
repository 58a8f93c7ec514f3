#pragma once

/// The one fence of MPI; compiled only where it is installed.

#include <memory>

#include "sampling/run/communicator.h"

namespace thenar::internal {

/// Initialises MPI, and finalises it when it goes. To be called once in a process. Going while an
/// exception is on its way ends all ranks: the others would wait for ever.
/// @throws InputError if MPI_Init is not that of an MPI library.
[[nodiscard]] std::unique_ptr<Communicator> mpi_communicator();

}  // namespace thenar::internal
