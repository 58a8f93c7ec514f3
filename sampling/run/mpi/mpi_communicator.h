#pragma once

/// MPI communicator, the only code that includes MPI; compiled only if MPI is installed.

#include <memory>

#include "sampling/run/communicator.h"

namespace thenar::internal {

/// Initialises MPI; the destructor finalises it. Call it once in a process. Destruction while an
/// exception unwinds the stack ends all ranks, since the others would wait forever.
/// @throws InputError if MPI_Init does not come from an MPI library.
[[nodiscard]] std::unique_ptr<Communicator> mpi_communicator();

}  // namespace thenar::internal
