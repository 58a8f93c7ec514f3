// seeded_run METHOD TEMPERATURES DRAWS OUT [FOLDER [KILLED_RANK]]
//
// Draws from a known posterior, alone or under mpirun, and writes all numbers of rank 0 to OUT,
// which is whole or missing.
// With a FOLDER it leaves checkpoints there, and goes on from them. KILLED_RANK kills itself
// half-way.

#include <cmath>
#include <csignal>
#include <cstdio>
#include <string>

#include "base/error.h"
#include "base/file_io.h"
#include "sampling/methods/state_bytes.h"
#include "sampling/run/run_chains.h"
#include "tests/sampling/known_posteriors.h"

namespace thenar {
namespace {

std::string bytes_of(const Draws& draws) {
  StateWriter writer;
  for (std::size_t c = 0; c < draws.x.size(); ++c) {
    writer.write(draws.x[c]);
    for (const StepStats& s : draws.stats[c])
      for (const double number :
           {s.log_prior, s.log_likelihood, s.acceptance, s.step_size, s.energy, double(s.depth),
            double(s.evaluations), double(s.non_finite), double(s.divergent)})
        writer.write(number);
  }
  writer.write(draws.swap_rate);
  return writer.bytes();
}

RunOptions options_of(char** arguments, int count) {
  RunOptions options;
  options.method = sampling_method(arguments[1]);
  options.temperatures = std::stoi(arguments[2]);
  options.min_beta = 0.1;  // the prior is flat
  options.draws = std::stol(arguments[3]);
  options.groups = 4;
  options.walkers = options.method == SamplingMethod::kStretchMove ? 20 : 1;
  options.thin = 10;
  options.swap_every = 5;
  options.sampler.warm_up = 2 * options.draws;
  options.sampler.seed = 11;
  options.fingerprint = "gaussian of 8 dimensions";
  options.checkpoint_every = 0.02;  // [s]
  if (count > 5) options.folder = arguments[5];
  return options;
}

void run(char** arguments, int count, const Communicator& ranks) {
  RunOptions options = options_of(arguments, count);
  const bool killed = count > 6 && std::stoi(arguments[6]) == ranks.rank();
  long asked = 0;
  options.progress.stop_requested = [&] {
    if (killed && ++asked == 30) (void)std::raise(SIGKILL);
    return false;
  };
  const sample::KnownPosterior posterior = sample::gaussian(8, 1e4);
  const Eigen::Index chains = Eigen::Index{options.groups} * options.walkers;
  Eigen::MatrixXd starts(8, chains);
  for (Eigen::Index c = 0; c < chains; ++c)
    for (int i = 0; i < 8; ++i) starts(i, c) = std::sin(1 + double(i + 8 * c));
  const Draws draws = run_chains(posterior.target, starts, options, ranks);
  if (ranks.rank() != 0) return;
  write_file(arguments[4], bytes_of(draws));
  std::printf("%.3f s\n", draws.seconds);
}

}  // namespace
}  // namespace thenar

int main(int count, char** arguments) {
  if (count < 5) return 2;
  std::unique_ptr<thenar::Communicator>
      ranks;  // outlives an error, so that others may have it, too
  try {
    ranks = thenar::world_communicator();
    thenar::run(arguments, count, *ranks);
  } catch (const thenar::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
