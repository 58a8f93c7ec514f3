#pragma once

/// The fence of MPI; compiled only where MPI is installed.

#include <memory>

#include "sampling/run/communicator.h"

namespace thenar::internal {

/// Initialises MPI; the destructor finalises it. Call it once in a process. Destruction while an
/// exception unwinds the stack ends all ranks, since the others would wait for ever.
/// @throws InputError if MPI_Init does not come from an MPI library.
[[nodiscard]] std::unique_ptr<Communicator> mpi_communicator();

}  // namespace thenar::internal
