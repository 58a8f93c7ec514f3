#include "sampling/ranks.h"

#include <cstdlib>

#include "base/error.h"
#include "sampling/mpi/mpi_ranks.h"

namespace thenar {
namespace {

class OneRank : public Ranks {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 1; }
  [[nodiscard]] Eigen::VectorXd all_gather(const Eigen::VectorXd& mine) const override {
    return mine;
  }
  void barrier() const override {}
  [[noreturn]] void abort(const std::string& why) const override { throw InputError(why); }
};

/// Set by the launchers of Open MPI, MPICH and PMIx (Slurm) in every process they start.
bool started_by_mpirun() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

}  // namespace

std::unique_ptr<Ranks> one_rank() { return std::make_unique<OneRank>(); }

std::unique_ptr<Ranks> world_ranks() {
  if (!started_by_mpirun()) return one_rank();
#ifdef THENAR_MPI
  return internal::mpi_ranks();
#else
  throw InputError("started by mpirun, but this program was built without MPI");
#endif
}

}  // namespace thenar
