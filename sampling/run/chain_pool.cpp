#include "sampling/run/chain_pool.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/parallel_for.h"
#include "sampling/run/advance.h"
#include "sampling/run/draws.h"

namespace thenar::internal {

void append_chain_state(const ChainState& chain_state, std::vector<double>& to) {
  const auto put = [&](const auto& numbers) {
    to.insert(to.end(), numbers.data(), numbers.data() + numbers.size());
  };
  put(chain_state.x);
  put(chain_state.at.log_prior);
  put(chain_state.at.log_likelihood);
  put(chain_state.at.prior_gradient);
  put(chain_state.at.likelihood_gradient);
}

ChainState read_chain_state(const double*& from, Eigen::Index size, WithGradient gradient) {
  const auto take = [&](Eigen::Index count) {
    Eigen::VectorXd numbers = Eigen::Map<const Eigen::VectorXd>(from, count);
    from += count;
    return numbers;
  };
  // Read position and densities, and gradients if available.
  ChainState chain_state;
  chain_state.x = take(size);
  chain_state.at.log_prior = take(1);
  chain_state.at.log_likelihood = take(1);
  if (gradient == WithGradient::kNo) return chain_state;
  chain_state.at.prior_gradient = take(size);
  chain_state.at.likelihood_gradient = take(size);
  return chain_state;
}

void ChainSlot::record(long warm_up, int thin) {
  if (temperature_index != 0 || sampler->steps() <= warm_up) return;
  // Divergences are counted at every step, also between draws.
  const bool draw = (sampler->steps() - warm_up) % thin == 0;
  for (int c = 0; c < sampler->chains(); ++c) {
    // Add the counts since the last draw.
    const StepStats& step = sampler->stats()[static_cast<std::size_t>(c)];
    StepStats& sum = stats_since_draw[static_cast<std::size_t>(c)];
    divergent += step.divergent ? 1 : 0;
    sum.evaluations += step.evaluations;
    sum.non_finite += step.non_finite;
    sum.divergent |= step.divergent;
    if (!draw) continue;
    // Record the draw with these counts.
    StepStats stats = step;
    stats.evaluations = sum.evaluations;
    stats.non_finite = sum.non_finite;
    stats.divergent = sum.divergent;
    put_draw(stats, sampler->positions().col(c), pending);
    sum = {};
  }
}

Eigen::MatrixXd ChainSlot::take_pending_draws() {
  const Eigen::Index rows = sampler->chains() * rows_of_draw(sampler->positions().rows());
  Eigen::MatrixXd draws = Eigen::Map<const Eigen::MatrixXd>(
      pending.data(), rows, static_cast<Eigen::Index>(pending.size()) / rows);
  pending.clear();
  return draws;
}

std::vector<ChainState> ChainSlot::chain_states() const {
  std::vector<ChainState> all;
  all.reserve(static_cast<std::size_t>(sampler->chains()));
  for (int c = 0; c < sampler->chains(); ++c)
    all.push_back({sampler->positions().col(c), sampler->density(c)});
  return all;
}

void ChainSlot::set_beta(double beta) {
  sampler->set_beta(beta);
  swap_counts = SwapCounts(static_cast<int>(swap_counts.tried.size()) + 1);
}

void ChainSlot::save(StateWriter& to) const {
  sampler->save(to);
  swap_counts.save(to);
  to.write(std::int64_t{divergent});
  for (const StepStats& sum : stats_since_draw)
    for (const int number : {sum.evaluations, sum.non_finite, int(sum.divergent)})
      to.write(std::int64_t{number});
}

void ChainSlot::restore(StateReader& from) {
  sampler->restore(from);
  swap_counts.restore(from);
  divergent = from.integer();
  for (StepStats& sum : stats_since_draw) {
    sum.evaluations = static_cast<int>(from.integer());
    sum.non_finite = static_cast<int>(from.integer());
    sum.divergent = from.integer() != 0;
  }
}

namespace {

constexpr double kSwapsToLearn = 20;  // number of swaps of each pair before the ladder is adapted

/// Returns the first item of a part if items are divided into consecutive, nearly equal parts.
int first_of(int part, int parts, int items) {
  return static_cast<int>(static_cast<long>(part) * items / parts);
}

/// Returns whether a boundary between parts lies within one of the groups of `length` items. The
/// first part starts at item `offset`.
bool splits(int parts, int items, int length, int offset = 0) {
  for (int part = 1; part < parts; ++part) {
    const int at = offset + first_of(part, parts, items);
    if (at % length != 0 && at > offset && at < offset + items) return true;
  }
  return false;
}

/// Returns the number of threads: as many as fill batches of the target; by default, one if there
/// are several ranks.
int threads_for(const RunOptions& options, const Target& target, int samplers, int ranks) {
  // Use all processors by default, or one if there are several ranks.
  int threads = options.threads;
  if (threads == 0) threads = ranks > 1 ? 1 : threads_or_all(0);
  // Use no more threads than batches of the cheapest size.
  const int batch = std::max(1, target.preferred_batch_size());
  const int batches = (samplers * options.walkers + batch - 1) / batch;
  return std::max(1, std::min({threads, batches, samplers}));
}

/// Returns the temperature_index with which walker w of `temperature_index` exchanges its state;
/// its own if there is no exchange.
int partner(const Swaps& swaps, Eigen::Index w, int temperature_index) {
  if (temperature_index < swaps.exchange.cols() && swaps.exchange(w, temperature_index))
    return temperature_index + 1;
  if (temperature_index > 0 && swaps.exchange(w, temperature_index - 1))
    return temperature_index - 1;
  return temperature_index;
}

}  // namespace

ChainPool::ChainPool(const Target& target, const Eigen::MatrixXd& starts, const RunOptions& options,
                     const Communicator& ranks)
    : target_(target),
      options_(options),
      ranks_(ranks),
      beta_(temperature_ladder(options.temperatures, options.min_beta)) {
  // Build the samplers of this rank.
  const int all = options.groups * options.temperatures;
  first_ = first_of(ranks.rank(), ranks.size(), all);
  const int samplers = first_of(ranks.rank() + 1, ranks.size(), all) - first_;
  for (int k = 0; k < samplers; ++k) slots_.push_back(build_slot(first_ + k, starts));
  // Start threads, and check whether groups are split over threads or ranks.
  pool_ = std::make_unique<ThreadPool>(threads_for(options, target, samplers, ranks.size()));
  split_ranks_ = splits(ranks.size(), all, options.temperatures);
  split_threads_ = splits(pool_->size(), samplers, options.temperatures, first_);
}

ChainSlot ChainPool::build_slot(int number, const Eigen::MatrixXd& starts) const {
  ChainSlot slot;
  slot.group = number / options_.temperatures;
  slot.temperature_index = number % options_.temperatures;
  // Chains of temperature_index 0 have the same numbers, hence the same random streams, for any
  // number of temperatures.
  SamplerOptions options = options_.sampler;
  options.beta = beta_[slot.temperature_index];
  options.first_chain = (slot.temperature_index * options_.groups + slot.group) * options_.walkers;
  const int walkers = options_.walkers;
  slot.sampler = build_sampler(
      options_.method, starts.middleCols(Eigen::Index{slot.group} * walkers, walkers), options);
  slot.swap_counts = SwapCounts(options_.temperatures);
  slot.stats_since_draw.resize(static_cast<std::size_t>(walkers));
  return slot;
}

void ChainPool::advance_slots(std::size_t from, std::size_t to, long step) {
  std::vector<Sampler*> samplers;
  for (std::size_t k = from; k < to; ++k) samplers.push_back(slots_[k].sampler.get());
  advance(samplers, target_, step,
          [&](std::size_t k) { slots_[from + k].record(options_.sampler.warm_up, options_.thin); });
}

long ChainPool::next_stop(long from, long step) const {
  if (options_.temperatures == 1) return step;
  return std::min(step, (from / options_.swap_every + 1) * options_.swap_every);
}

std::size_t ChainPool::first_slot_of(int worker) const {
  return static_cast<std::size_t>(first_of(worker, pool_->size(), static_cast<int>(slots_.size())));
}

void ChainPool::advance_to(long step) {
  while (step_ < step) {
    // Advance to the next change of the ladder.
    const long tuning = next_retuning(step_), stop = std::min(step, tuning);
    // Threads wait for each other at swaps only if a group is split over them.
    if (split_ranks_ || split_threads_)
      advance_together(stop);
    else
      pool_->run([&](int worker) {
        advance_apart(first_slot_of(worker), first_slot_of(worker + 1), stop);
      });
    step_ = stop;
    if (stop == tuning) adapt_ladder();
  }
}

// The ladder is adapted at an eighth, a quarter and a half of warm-up, so that every temperature
// has time to adapt its step size; at the end of warm-up, swap counts are reset.
long ChainPool::next_retuning(long from) const {
  const long warm_up = options_.sampler.warm_up;
  if (options_.temperatures > 1)
    for (const long part : {8, 4, 2, 1})
      if (warm_up / part > from) return warm_up / part;
  return std::numeric_limits<long>::max();
}

void ChainPool::adapt_ladder() {
  // Sum the swaps of all groups in order: the sums are equal on every rank.
  const Eigen::Index pairs = beta_.size() - 1;
  Eigen::VectorXd mine(0);
  for (const ChainSlot& slot : slots_) {
    if (slot.temperature_index != 0) continue;
    mine.conservativeResize(mine.size() + 2 * pairs);
    mine.tail(2 * pairs) << slot.swap_counts.tried, slot.swap_counts.probability;
  }
  const Eigen::VectorXd all = ranks_.all_gather(mine);
  SwapCounts sum(options_.temperatures);
  for (Eigen::Index at = 0; at < all.size(); at += 2 * pairs) {
    sum.tried += all.segment(at, pairs);
    sum.probability += all.segment(at + pairs, pairs);
  }
  // Adapt the ladder once every pair has been tried often enough.
  if (step_ < options_.sampler.warm_up) {
    if ((sum.tried.array() < kSwapsToLearn).any()) return;
    beta_ = adapted_ladder(beta_, sum.rejection_rate());
  }
  for (ChainSlot& slot : slots_) slot.set_beta(beta_[slot.temperature_index]);
}

void ChainPool::advance_together(long step) {
  for (long at = step_; at < step;) {
    // Advance all samplers to the next swap.
    at = next_stop(at, step);
    pool_->run(
        [&](int worker) { advance_slots(first_slot_of(worker), first_slot_of(worker + 1), at); });
    if (at % options_.swap_every != 0) continue;
    // States of other ranks are needed only if a group is split over ranks.
    if (split_ranks_)
      swap(0, slots_.size(), gather_chain_states(), 0, at);
    else
      swap(0, slots_.size(), chain_states(0, slots_.size()), first_ / options_.temperatures, at);
  }
}

void ChainPool::advance_apart(std::size_t from, std::size_t to, long step) {
  for (long at = step_; at < step && from < to;) {
    at = next_stop(at, step);
    advance_slots(from, to, at);
    if (options_.temperatures > 1 && at % options_.swap_every == 0)
      swap(from, to, chain_states(from, to), slots_[from].group, at);
  }
}

std::vector<std::vector<ChainState>> ChainPool::chain_states(std::size_t from,
                                                             std::size_t to) const {
  std::vector<std::vector<ChainState>> all;
  for (std::size_t k = from; k < to; ++k) all.push_back(slots_[k].chain_states());
  return all;
}

std::vector<std::vector<ChainState>> ChainPool::gather_chain_states() const {
  std::vector<double> numbers{0};  // first number: whether there are gradients
  // Pack the states of this rank's samplers.
  for (const ChainSlot& slot : slots_) {
    if (slot.sampler->wants() == WithGradient::kYes) numbers[0] = 1;
    for (const ChainState& chain_state : slot.chain_states())
      append_chain_state(chain_state, numbers);
  }
  const Eigen::VectorXd all = ranks_.all_gather(
      Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size())));
  // Unpack the states of all samplers, rank by rank.
  const int count = options_.groups * options_.temperatures;
  std::vector<std::vector<ChainState>> found;
  const double* at = all.data();
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    const WithGradient gradient = *at++ == 1 ? WithGradient::kYes : WithGradient::kNo;
    for (int k = first_of(rank, ranks_.size(), count); k < first_of(rank + 1, ranks_.size(), count);
         ++k) {
      found.emplace_back();
      for (int w = 0; w < options_.walkers; ++w)
        found.back().push_back(read_chain_state(at, target_.size(), gradient));
    }
  }
  return found;
}

void ChainPool::swap(std::size_t from, std::size_t to,
                     const std::vector<std::vector<ChainState>>& chain_states, int first_group,
                     long step) {
  const int T = options_.temperatures;
  const auto round = static_cast<std::uint32_t>(step / options_.swap_every);
  for (std::size_t k = from; k < to; ++k) {
    // Collect the likelihoods of all walkers and temperatures of the group.
    ChainSlot& slot = slots_[k];
    const int first = (slot.group - first_group) * T;
    const auto* group = &chain_states[static_cast<std::size_t>(first)];
    Eigen::MatrixXd log_likelihood(options_.walkers, T);
    for (int t = 0; t < T; ++t)
      for (int w = 0; w < options_.walkers; ++w)
        log_likelihood(w, t) = group[t][static_cast<std::size_t>(w)].at.log_likelihood[0];
    // Decide, with the same result on every rank and thread.
    const Swaps swaps = decide_swaps(beta_, log_likelihood, options_.sampler.seed,
                                     static_cast<std::uint32_t>(slot.group), round);
    if (slot.temperature_index == 0) slot.swap_counts.add(swaps);
    // Move the walkers that exchange their states.
    for (int w = 0; w < options_.walkers; ++w) {
      const int other = partner(swaps, w, slot.temperature_index);
      if (other == slot.temperature_index) continue;
      const ChainState& chain_state = group[other][static_cast<std::size_t>(w)];
      slot.sampler->move(w, chain_state.x, chain_state.at);
    }
  }
}

std::vector<Eigen::MatrixXd> ChainPool::take_draws() {
  std::vector<Eigen::MatrixXd> all;
  for (ChainSlot& slot : slots_)
    if (slot.temperature_index == 0) all.push_back(slot.take_pending_draws());
  return all;
}

std::vector<std::string> ChainPool::save() const {
  std::vector<std::string> states;
  for (const ChainSlot& slot : slots_) {
    StateWriter writer;
    slot.save(writer);
    states.push_back(writer.bytes());
  }
  return states;
}

void ChainPool::restore(long step, const Eigen::VectorXd& beta,
                        const std::vector<std::string>& all) {
  require(beta.size() == beta_.size(), "the checkpoint has {} temperatures", beta.size());
  beta_ = beta;
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    // Restore each sampler at its own temperature.
    StateReader reader(all.at(static_cast<std::size_t>(first_) + k));
    slots_[k].set_beta(beta_[slots_[k].temperature_index]);
    slots_[k].restore(reader);
    require(reader.at_end() && slots_[k].sampler->steps() == step,
            "the checkpoint does not fit sampler {}", static_cast<std::size_t>(first_) + k);
  }
  step_ = step;
}

long ChainPool::divergent() const {
  long sum = 0;
  for (const ChainSlot& slot : slots_) sum += slot.divergent;
  return sum;
}

Eigen::VectorXd ChainPool::swap_rates() const {
  Eigen::VectorXd rates(0);
  for (const ChainSlot& slot : slots_) {
    if (slot.temperature_index != 0) continue;
    rates.conservativeResize(rates.size() + beta_.size() - 1);
    rates.tail(beta_.size() - 1) = slot.swap_counts.swap_rate();
  }
  return rates;
}

}  // namespace thenar::internal
