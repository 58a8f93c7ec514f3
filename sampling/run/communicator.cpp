#include "sampling/run/communicator.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/error.h"
#include "sampling/run/mpi/mpi_communicator.h"

namespace thenar {
namespace {

/// Communicator of a single process.
class OneRank : public Communicator {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 1; }
  [[nodiscard]] Eigen::VectorXd all_gather(const Eigen::VectorXd& mine) const override {
    return mine;
  }
  void barrier() const override {}
  [[noreturn]] void abort(const std::string& why) const override { throw InputError(why); }
};

/// Returns whether a launcher of Open MPI, MPICH or PMIx (Slurm) started this process.
bool started_by_mpirun() {
  constexpr std::array<const char*, 3> kSet{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
  return std::any_of(kSet.begin(), kSet.end(),
                     [](const char* name) { return std::getenv(name) != nullptr; });
}

}  // namespace

std::unique_ptr<Communicator> single_process() { return std::make_unique<OneRank>(); }

std::unique_ptr<Communicator> world_communicator() {
  if (!started_by_mpirun()) return single_process();
#ifdef THENAR_MPI
  return internal::mpi_communicator();
#else
  throw InputError("started by mpirun, but this program was built without MPI");
#endif
}

}  // namespace thenar

namespace thenar::internal {

// Each rank sends its length and its bytes, eight in each double, which is only copied.
std::vector<std::string> all_gather_bytes(const Communicator& ranks, const std::string& mine) {
  if (ranks.size() == 1) return {mine};
  const auto words = [](std::size_t bytes) {
    return static_cast<Eigen::Index>((bytes + sizeof(double) - 1) / sizeof(double));
  };
  // Pack the length and the bytes.
  Eigen::VectorXd sent = Eigen::VectorXd::Zero(1 + words(mine.size()));
  sent[0] = static_cast<double>(mine.size());
  mine.copy(reinterpret_cast<char*>(sent.data() + 1), mine.size());

  const Eigen::VectorXd all = ranks.all_gather(sent);
  // Unpack by length.
  std::vector<std::string> parts;
  for (Eigen::Index at = 0; at < all.size();) {
    const auto size = static_cast<std::size_t>(all[at]);
    parts.emplace_back(reinterpret_cast<const char*>(all.data() + at + 1), size);
    at += 1 + words(size);
  }
  return parts;
}

}  // namespace thenar::internal
