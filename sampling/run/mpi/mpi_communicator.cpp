#include "sampling/run/mpi/mpi_communicator.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <vector>

#include <dlfcn.h>
#include <mpi.h>

#include "base/error.h"

namespace thenar::internal {
namespace {

/// Returns the library of MPI_Init: the sequential MUMPS used by Ipopt has a dummy one.
std::string library_of_mpi() {
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&MPI_Init), &info) == 0 || !info.dli_fname) return "";
  return info.dli_fname;
}

void require_real_mpi() {
  const std::string path = library_of_mpi();
  const std::string name = path.substr(path.rfind('/') + 1);
  require(name.rfind("libmpi.", 0) == 0 || name.rfind("libmpich.", 0) == 0,
          "MPI_Init must come from libmpi, but comes from '{}': link MPI before Ipopt", path);
}

/// Communicator of all processes of MPI_COMM_WORLD.
class MpiRanks : public Communicator {
 public:
  MpiRanks() {
    require_real_mpi();
    int provided = 0;
    require(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) == MPI_SUCCESS &&
                provided >= MPI_THREAD_FUNNELED,
            "MPI could not start, or supports no threads");
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }

  ~MpiRanks() override {
    if (std::uncaught_exceptions() > 0) MpiRanks::abort("one rank failed");
    MPI_Finalize();
  }

  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int size() const override { return size_; }

  // MPI errors end all ranks, by its default error handler.
  [[nodiscard]] Eigen::VectorXd all_gather(const Eigen::VectorXd& mine) const override {
    // Gather the lengths.
    const int length = static_cast<int>(mine.size());
    std::vector<int> lengths(static_cast<std::size_t>(size_)), starts(lengths.size(), 0);
    MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, MPI_COMM_WORLD);
    std::partial_sum(lengths.begin(), lengths.end() - 1, starts.begin() + 1);
    // Gather the numbers, rank by rank.
    Eigen::VectorXd all(starts.back() + lengths.back());
    MPI_Allgatherv(mine.data(), length, MPI_DOUBLE, all.data(), lengths.data(), starts.data(),
                   MPI_DOUBLE, MPI_COMM_WORLD);
    return all;
  }

  void barrier() const override { MPI_Barrier(MPI_COMM_WORLD); }

  [[noreturn]] void abort(const std::string& why) const override {
    // Report the error, because no exception can reach the caller.
    std::fprintf(stderr, "thenar: rank %d: %s\n", rank_, why.c_str());
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    std::abort();
  }

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace

std::unique_ptr<Communicator> mpi_communicator() { return std::make_unique<MpiRanks>(); }

}  // namespace thenar::internal
