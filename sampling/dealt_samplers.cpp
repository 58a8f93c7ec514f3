#include "sampling/dealt_samplers.h"

#include <algorithm>
#include <limits>
#include <thread>

#include "base/error.h"
#include "sampling/advance.h"

namespace thenar::internal {
namespace {

constexpr double kSwapsToLearn = 20;  // of each pair, before the ladder follows them

/// Items are dealt in consecutive shares: `part` has those from first_of(part) to first_of(part+1).
int first_of(int part, int parts, int items) {
  return static_cast<int>(static_cast<long>(part) * items / parts);
}

/// Does a share end within one of the groups of `length` items? The first starts at item `offset`.
bool splits(int parts, int items, int length, int offset = 0) {
  for (int part = 1; part < parts; ++part) {
    const int at = offset + first_of(part, parts, items);
    if (at % length != 0 && at > offset && at < offset + items) return true;
  }
  return false;
}

/// As many threads as fill the lanes of the target; one for each of several ranks, unless told.
int threads_for(const RunOptions& options, const Target& target, int samplers, int ranks) {
  int threads = options.threads;
  if (threads == 0)
    threads = ranks > 1 ? 1 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int lanes = std::max(1, target.lanes());
  const int batches = (samplers * options.walkers + lanes - 1) / lanes;
  return std::max(1, std::min({threads, batches, samplers}));
}

/// The rung that walker w of `rung` changes places with; its own if none.
int partner(const Swaps& swaps, Eigen::Index w, int rung) {
  if (rung < swaps.exchange.cols() && swaps.exchange(w, rung)) return rung + 1;
  if (rung > 0 && swaps.exchange(w, rung - 1)) return rung - 1;
  return rung;
}

}  // namespace

DealtSamplers::DealtSamplers(const Target& target, const Eigen::MatrixXd& starts,
                             const RunOptions& options, const Ranks& ranks)
    : target_(target),
      options_(options),
      ranks_(ranks),
      temper_(temperature_ladder(options.temperatures, options.least_temper)) {
  const int all = options.groups * options.temperatures;
  first_ = first_of(ranks.rank(), ranks.size(), all);
  const int samplers = first_of(ranks.rank() + 1, ranks.size(), all) - first_;
  for (int k = 0; k < samplers; ++k) slots_.push_back(build_slot(first_ + k, starts));
  team_ = std::make_unique<WorkerTeam>(threads_for(options, target, samplers, ranks.size()));
  split_ranks_ = splits(ranks.size(), all, options.temperatures);
  split_threads_ = splits(team_->size(), samplers, options.temperatures, first_);
}

SamplerSlot DealtSamplers::build_slot(int number, const Eigen::MatrixXd& starts) const {
  SamplerSlot slot;
  slot.group = number / options_.temperatures;
  slot.rung = number % options_.temperatures;
  // Chains of rung 0 have the same numbers, and so the same random streams, whatever is above.
  SamplerOptions options = options_.sampler;
  options.temper = temper_[slot.rung];
  options.first_chain = (slot.rung * options_.groups + slot.group) * options_.walkers;
  const int walkers = options_.walkers;
  slot.sampler = build_sampler(
      options_.method, starts.middleCols(Eigen::Index{slot.group} * walkers, walkers), options);
  slot.tally = SwapTally(options_.temperatures);
  slot.since.resize(static_cast<std::size_t>(walkers));
  return slot;
}

void DealtSamplers::advance_slots(std::size_t from, std::size_t to, long step) {
  std::vector<Sampler*> samplers;
  for (std::size_t k = from; k < to; ++k) samplers.push_back(slots_[k].sampler.get());
  advance(samplers, target_, step,
          [&](std::size_t k) { slots_[from + k].record(options_.sampler.warm_up, options_.thin); });
}

long DealtSamplers::next_stop(long from, long step) const {
  if (options_.temperatures == 1) return step;
  return std::min(step, (from / options_.swap_every + 1) * options_.swap_every);
}

std::size_t DealtSamplers::share(int worker) const {
  return static_cast<std::size_t>(first_of(worker, team_->size(), static_cast<int>(slots_.size())));
}

void DealtSamplers::advance_to(long step) {
  while (step_ < step) {
    const long tuning = next_retuning(step_), stop = std::min(step, tuning);
    if (split_ranks_ || split_threads_)
      advance_together(stop);
    else
      team_->run([&](int worker) { advance_apart(share(worker), share(worker + 1), stop); });
    step_ = stop;
    if (stop == tuning) retune();
  }
}

// The ladder changes at an eighth, a quarter and a half of warm-up, so that every rung has time to
// learn its own step; at the end of warm-up swaps are counted anew.
long DealtSamplers::next_retuning(long from) const {
  const long warm_up = options_.sampler.warm_up;
  if (options_.temperatures > 1)
    for (const long part : {8, 4, 2, 1})
      if (warm_up / part > from) return warm_up / part;
  return std::numeric_limits<long>::max();
}

void DealtSamplers::retune() {
  // Swaps of all groups, in their order: the same sums on every rank.
  const Eigen::Index pairs = temper_.size() - 1;
  Eigen::VectorXd mine(0);
  for (const SamplerSlot& slot : slots_) {
    if (slot.rung != 0) continue;
    mine.conservativeResize(mine.size() + 2 * pairs);
    mine.tail(2 * pairs) << slot.tally.tried, slot.tally.probability;
  }
  const Eigen::VectorXd all = ranks_.all_gather(mine);
  SwapTally sum(options_.temperatures);
  for (Eigen::Index at = 0; at < all.size(); at += 2 * pairs) {
    sum.tried += all.segment(at, pairs);
    sum.probability += all.segment(at + pairs, pairs);
  }
  if (step_ < options_.sampler.warm_up) {
    if ((sum.tried.array() < kSwapsToLearn).any()) return;
    temper_ = adapted_ladder(temper_, sum.rejected());
  }
  for (SamplerSlot& slot : slots_) slot.retemper(temper_[slot.rung]);
}

void DealtSamplers::advance_together(long step) {
  for (long at = step_; at < step;) {
    at = next_stop(at, step);
    team_->run([&](int worker) { advance_slots(share(worker), share(worker + 1), at); });
    if (at % options_.swap_every != 0) continue;
    if (split_ranks_)
      swap(0, slots_.size(), gather_places(), 0, at);
    else
      swap(0, slots_.size(), places(0, slots_.size()), first_ / options_.temperatures, at);
  }
}

void DealtSamplers::advance_apart(std::size_t from, std::size_t to, long step) {
  for (long at = step_; at < step && from < to;) {
    at = next_stop(at, step);
    advance_slots(from, to, at);
    if (options_.temperatures > 1 && at % options_.swap_every == 0)
      swap(from, to, places(from, to), slots_[from].group, at);
  }
}

std::vector<std::vector<Place>> DealtSamplers::places(std::size_t from, std::size_t to) const {
  std::vector<std::vector<Place>> all;
  for (std::size_t k = from; k < to; ++k) all.push_back(slots_[k].places());
  return all;
}

std::vector<std::vector<Place>> DealtSamplers::gather_places() const {
  std::vector<double> numbers{0};  // first: do they have gradients?
  for (const SamplerSlot& slot : slots_) {
    if (slot.sampler->wants() == WithGradient::kYes) numbers[0] = 1;
    for (const Place& place : slot.places()) put_place(place, numbers);
  }
  const Eigen::VectorXd all = ranks_.all_gather(
      Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size())));
  const int count = options_.groups * options_.temperatures;
  std::vector<std::vector<Place>> found;
  const double* at = all.data();
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    const WithGradient gradient = *at++ == 1 ? WithGradient::kYes : WithGradient::kNo;
    for (int k = first_of(rank, ranks_.size(), count); k < first_of(rank + 1, ranks_.size(), count);
         ++k) {
      found.emplace_back();
      for (int w = 0; w < options_.walkers; ++w)
        found.back().push_back(take_place(at, target_.size(), gradient));
    }
  }
  return found;
}

void DealtSamplers::swap(std::size_t from, std::size_t to,
                         const std::vector<std::vector<Place>>& places, int first_group,
                         long step) {
  const int T = options_.temperatures;
  const auto round = static_cast<std::uint32_t>(step / options_.swap_every);
  for (std::size_t k = from; k < to; ++k) {
    SamplerSlot& slot = slots_[k];
    const auto* group = &places[static_cast<std::size_t>((slot.group - first_group) * T)];
    Eigen::MatrixXd log_likelihood(options_.walkers, T);
    for (int t = 0; t < T; ++t)
      for (int w = 0; w < options_.walkers; ++w)
        log_likelihood(w, t) = group[t][static_cast<std::size_t>(w)].at.log_likelihood[0];
    const Swaps swaps = decide_swaps(temper_, log_likelihood, options_.sampler.seed,
                                     static_cast<std::uint32_t>(slot.group), round);
    if (slot.rung == 0) slot.tally.add(swaps);
    for (int w = 0; w < options_.walkers; ++w) {
      const int other = partner(swaps, w, slot.rung);
      if (other == slot.rung) continue;
      const Place& place = group[other][static_cast<std::size_t>(w)];
      slot.sampler->move(w, place.x, place.at);
    }
  }
}

std::vector<Eigen::MatrixXd> DealtSamplers::take_draws() {
  std::vector<Eigen::MatrixXd> all;
  for (SamplerSlot& slot : slots_)
    if (slot.rung == 0) all.push_back(slot.take());
  return all;
}

std::vector<std::string> DealtSamplers::save() const {
  std::vector<std::string> states;
  for (const SamplerSlot& slot : slots_) {
    StateWriter writer;
    slot.save(writer);
    states.push_back(writer.bytes());
  }
  return states;
}

void DealtSamplers::restore(long step, const Eigen::VectorXd& temper,
                            const std::vector<std::string>& all) {
  require(temper.size() == temper_.size(), "the checkpoint has {} temperatures", temper.size());
  temper_ = temper;
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    StateReader reader(all.at(static_cast<std::size_t>(first_) + k));
    slots_[k].retemper(temper_[slots_[k].rung]);
    slots_[k].restore(reader);
    require(reader.done() && slots_[k].sampler->steps() == step,
            "the checkpoint does not fit sampler {}", static_cast<std::size_t>(first_) + k);
  }
  step_ = step;
}

long DealtSamplers::divergent() const {
  long sum = 0;
  for (const SamplerSlot& slot : slots_) sum += slot.divergent;
  return sum;
}

Eigen::VectorXd DealtSamplers::swap_rates() const {
  Eigen::VectorXd rates(0);
  for (const SamplerSlot& slot : slots_) {
    if (slot.rung != 0) continue;
    rates.conservativeResize(rates.size() + temper_.size() - 1);
    rates.tail(temper_.size() - 1) = slot.tally.rate();
  }
  return rates;
}

}  // namespace thenar::internal
