#include "sampling/run/chain_run.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "sampling/methods/saved_shape.h"
#include "sampling/run/communicator.h"
#include "sampling/run/draws.h"

namespace thenar::internal {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

ChainRun::ChainRun(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options,
                   const Communicator& ranks, std::optional<RunFolder>& folder)
    : options_(options),
      ranks_(ranks),
      folder_(folder),
      samplers_(target, starts, options, ranks),
      rows_(rows_of_draw(target.size())),
      total_(options.sampler.warm_up + options.draws * options.thin),
      kept_(static_cast<std::size_t>(options.groups)) {}

void ChainRun::resume() {
  // Broadcast the checkpoint of rank 0.
  const bool found = folder_ && folder_->state();
  const std::string state = all_gather_bytes(ranks_, found ? *folder_->state() : "").front();
  if (state.empty()) return;
  // Read step, time and ladder, then the state of every sampler.
  StateReader reader(state);
  const long step = reader.integer();
  seconds_before_ = reader.number();
  const Eigen::VectorXd beta = saved_vector(reader, "temperatures", options_.temperatures);
  std::vector<std::string> all;
  while (!reader.at_end()) all.push_back(reader.bytes());
  const int wanted = options_.groups * options_.temperatures;
  require(all.size() == static_cast<std::size_t>(wanted), "the checkpoint has {} samplers",
          all.size());
  samplers_.restore(step, beta, all);
  saved_step_ = step;
}

void ChainRun::run_to_end() {
  stop_ = ended_at_divergence();  // a resumed run may have ended at a divergence
  while (samplers_.step() < total_ && !stop_) {
    run_leg();
    if (checkpoint_due_) checkpoint();
  }
  checkpoint();
}

/// Advances for about a quarter of a second, so that stop requests are handled and timing is known.
/// The number of steps does not affect the draws.
void ChainRun::run_leg() {
  // Stop at the end of warm-up, and of the run.
  const long warm_up = options_.sampler.warm_up, from = samplers_.step();
  const long end = from < warm_up ? std::min(warm_up, total_) : total_;
  const Clock::time_point start = Clock::now();
  samplers_.advance_to(std::min(end, from + next_leg_));
  agree_on_next_leg(seconds_since(start), samplers_.step() - from);
  report();
}

void ChainRun::agree_on_next_leg(double seconds, long steps) {
  // Estimate the steps that fill the target time, at most twice as many as before.
  constexpr double kLegTime = 0.25;  // target time of a leg [s]
  const double goal = std::min(kLegTime, options_.checkpoint_every);
  const double next = double(steps) * goal / std::max(seconds, 1e-9);
  Eigen::Vector4d mine;
  mine << (options_.progress.stop() ? 1 : 0), double(samplers_.divergent()),
      seconds_since(last_checkpoint_) >= options_.checkpoint_every ? 1 : 0,
      std::clamp(std::floor(next), 1.0, 2.0 * double(next_leg_));
  const Eigen::VectorXd all = ranks_.all_gather(mine);
  const Eigen::Map<const Eigen::Matrix4Xd> ranks(all.data(), 4, ranks_.size());
  // Any rank may stop the run; rank 0 determines the timing.
  divergent_ = static_cast<long>(ranks.row(1).sum());
  stop_ = ranks.row(0).maxCoeff() > 0 || (options_.end_at_divergence && divergent_ > 0);
  checkpoint_due_ = ranks(2, 0) > 0;
  next_leg_ = static_cast<long>(ranks(3, 0));
  seconds_per_step_ = seconds / double(steps);
}

void ChainRun::report() const {
  if (!is_root()) return;
  // Estimate the remaining time from the last leg.
  const long step = samplers_.step(), warm_up = options_.sampler.warm_up;
  const long left = std::lround(double(total_ - step) * seconds_per_step_);
  std::string what = step < warm_up ? fmt::format("warm-up, step {} of {}", step, warm_up)
                                    : fmt::format("sampling, draw {} of {}",
                                                  (step - warm_up) / options_.thin, options_.draws);
  if (divergent_ > 0) what += fmt::format(", {} divergent", divergent_);
  options_.progress(double(step) / double(std::max(1L, total_)),
                    fmt::format("{}, {} s left", what, left));
}

std::string ChainRun::state(const std::vector<std::string>& samplers) const {
  StateWriter writer;
  writer.write(std::int64_t{samplers_.step()});
  writer.write(seconds_before_ + seconds_since(start_));
  writer.write(samplers_.beta());
  for (const std::string& sampler : samplers) writer.write_bytes(sampler);
  return writer.bytes();
}

/// Gathers the new draws and, if there is a folder, the states on rank 0, which stores them.
void ChainRun::checkpoint() {
  last_checkpoint_ = Clock::now();
  if (saved_step_ == samplers_.step()) return;
  saved_step_ = samplers_.step();
  Gathered all{samplers_.take_draws(),
               options_.folder.empty() ? std::vector<std::string>{} : samplers_.save()};
  if (ranks_.size() > 1) all = gather(all);
  // Write to the folder, or keep in memory.
  if (folder_) folder_->commit(all.draws, state(all.states));
  for (std::size_t g = 0; g < all.draws.size() && !folder_; ++g)
    kept_[g].push_back(std::move(all.draws[g]));
}

ChainRun::Gathered ChainRun::gather(const Gathered& mine) const {
  // Pack draws and states of this rank.
  StateWriter writer;
  writer.write(static_cast<std::int64_t>(mine.draws.size()));
  for (const Eigen::MatrixXd& group : mine.draws) writer.write(group);
  for (const std::string& sampler : mine.states) writer.write_bytes(sampler);
  // Unpack those of all ranks on rank 0.
  Gathered all;
  for (const std::string& bytes : all_gather_bytes(ranks_, writer.bytes())) {
    if (!is_root()) break;
    StateReader reader(bytes);
    for (std::int64_t left = reader.integer(); left > 0; --left)
      all.draws.push_back(reader.matrix());
    while (!reader.at_end()) all.states.push_back(reader.bytes());
  }
  return all;
}

Eigen::MatrixXd ChainRun::draws_of(std::size_t group) const {
  if (folder_) return folder_->read(group);
  // Concatenate the parts of the group.
  Eigen::Index columns = 0;
  for (const Eigen::MatrixXd& part : kept_[group]) columns += part.cols();
  Eigen::MatrixXd all(rows_ * options_.walkers, columns);
  columns = 0;
  for (const Eigen::MatrixXd& part : kept_[group]) {
    all.middleCols(columns, part.cols()) = part;
    columns += part.cols();
  }
  return all;
}

bool ChainRun::ended_at_divergence() const {
  if (!options_.end_at_divergence) return false;
  const auto divergent = double(samplers_.divergent());  // count of this rank
  return ranks_.all_gather(Eigen::VectorXd::Constant(1, divergent)).sum() > 0;
}

Draws ChainRun::result() const {
  // Collect what is equal on all ranks.
  Draws draws;
  draws.beta = samplers_.beta();
  const Eigen::VectorXd rates = ranks_.all_gather(samplers_.swap_rates());
  draws.swap_rate =
      Eigen::Map<const Eigen::MatrixXd>(rates.data(), draws.beta.size() - 1, options_.groups);
  draws.warm_up = options_.sampler.warm_up;
  draws.complete = samplers_.step() >= total_;
  draws.ended_at_divergence = ended_at_divergence();
  draws.seconds = seconds_before_ + seconds_since(start_);
  if (!is_root()) return draws;
  for (int g = 0; g < options_.groups; ++g) {
    // Read the draws of the group, walkers stacked by rows.
    const Eigen::MatrixXd rows = draws_of(static_cast<std::size_t>(g));
    const Eigen::Index count = std::min<Eigen::Index>(rows.cols(), options_.draws);
    for (int w = 0; w < options_.walkers; ++w) {
      // Split position and statistics of each draw of a walker.
      const auto chain = rows.block(w * rows_, 0, rows_, count);
      Eigen::MatrixXd x(samplers_.size(), count);
      std::vector<StepStats> stats;
      for (Eigen::Index k = 0; k < count; ++k) {
        x.col(k) = position_of(chain.col(k));
        stats.push_back(stats_of(chain.col(k)));
      }
      draws.x.push_back(std::move(x));
      draws.stats.push_back(std::move(stats));
      draws.group.push_back(g);
    }
  }
  return draws;
}

}  // namespace thenar::internal
