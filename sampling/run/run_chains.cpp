#include "sampling/run/run_chains.h"

#include <optional>

#include "base/error.h"
#include "base/provenance.h"
#include "sampling/run/chain_run.h"
#include "sampling/run/communicator.h"
#include "sampling/run/draws.h"
#include "sampling/run/run_folder.h"

namespace thenar {
namespace internal {
namespace {

void check_run(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options) {
  // Starts.
  require(options.groups >= 1, "groups must be >= 1, got {}", options.groups);
  require(options.walkers >= 1, "walkers must be >= 1, got {}", options.walkers);
  require(starts.rows() == target.size(), "starts have {} entries, the target has {}",
          starts.rows(), target.size());
  require(starts.cols() == Eigen::Index{options.groups} * options.walkers,
          "wanted a start for each of {} groups of {} walkers, got {}", options.groups,
          options.walkers, starts.cols());
  // Lengths and times.
  require(options.swap_every >= 1, "steps between swaps must be >= 1, got {}", options.swap_every);
  require(options.draws >= 0, "draws must be >= 0, got {}", options.draws);
  require(options.thin >= 1, "steps a draw must be >= 1, got {}", options.thin);
  require(options.checkpoint_every >= 0, "seconds between checkpoints must be >= 0, got {}",
          options.checkpoint_every);
  require(options.threads >= 0, "threads must be >= 0, got {}", options.threads);
  require(options.fingerprint.find('\n') == std::string::npos,
          "a fingerprint has one line, got '{}'", options.fingerprint);
}

std::string hash_of(const Eigen::MatrixXd& matrix) {
  StateWriter writer;
  writer.write(matrix);
  return sha256(writer.bytes()).substr(0, 16);
}

/// Lists everything that the draws depend on.
RunIdentity identity_of(const Eigen::MatrixXd& starts, const RunOptions& options) {
  const SamplerOptions& sampler = options.sampler;
  return {{"version", versions().at("thenar")},
          {"layout of states", "2"},  // another one is refused, not misread
          {"target", options.fingerprint},
          {"parameters", std::to_string(starts.rows())},
          {"method", name_of(options.method)},
          {"seed", std::to_string(sampler.seed)},
          {"warm-up", std::to_string(sampler.warm_up)},
          {"target acceptance", fmt::format("{}", sampler.target_acceptance)},
          {"tree depth", std::to_string(sampler.max_depth)},
          {"metric", sampler.metric == Metric::kDense ? "dense" : "diagonal"},
          {"covariance", hash_of(sampler.covariance)},
          {"starts", hash_of(starts)},
          {"groups", std::to_string(options.groups)},
          {"walkers", std::to_string(options.walkers)},
          {"temperatures", std::to_string(options.temperatures)},
          {"least temper", fmt::format("{}", options.min_beta)},
          {"swap every", std::to_string(options.swap_every)},
          {"thin", std::to_string(options.thin)}};
}

/// Opens the folder on rank 0; on failure, all ranks throw the same error.
std::optional<RunFolder> open_folder(const Eigen::MatrixXd& starts, const RunOptions& options,
                                     const Communicator& ranks) {
  std::optional<RunFolder> folder;
  std::string refusal;  // prefix '!': checkpoint of another run, '#': damaged checkpoint
  if (ranks.rank() == 0 && !options.folder.empty()) try {
      const Eigen::Index rows = rows_of_draw(starts.rows()) * options.walkers;
      folder.emplace(options.folder, identity_of(starts, options),
                     std::vector<Eigen::Index>(static_cast<std::size_t>(options.groups), rows));
    } catch (const CheckpointError& error) {
      const bool damaged = error.kind() == CheckpointError::Kind::kDamaged;
      refusal = std::string(damaged ? "#" : "!") + error.what();
    } catch (const std::exception& error) {
      refusal = error.what();
    }
  // Broadcast the error.
  refusal = all_gather_bytes(ranks, refusal).front();
  if (refusal[0] == '!') throw CheckpointError(CheckpointError::Kind::kOtherRun, refusal.substr(1));
  if (refusal[0] == '#') throw CheckpointError(CheckpointError::Kind::kDamaged, refusal.substr(1));
  if (!refusal.empty()) throw InputError(refusal);
  return folder;
}

}  // namespace
}  // namespace internal

Draws run_chains(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options,
                 const Communicator& ranks) {
  internal::check_run(target, starts, options);
  std::optional<internal::RunFolder> folder = internal::open_folder(starts, options, ranks);
  try {
    internal::ChainRun run(target, starts, options, ranks, folder);
    run.resume();
    run.run_to_end();
    return run.result();
  } catch (const std::exception& error) {
    // The other ranks would wait for this one forever.
    if (ranks.size() > 1) ranks.abort(error.what());
    throw;
  }
}

Draws run_chains(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options) {
  return run_chains(target, starts, options, *single_process());
}

}  // namespace thenar
