#include "sampling/sampler_slot.h"

#include "sampling/draw_rows.h"

namespace thenar::internal {

void SamplerSlot::record(long warm_up, int thin) {
  if (rung != 0 || sampler->steps() <= warm_up) return;
  const bool draw = (sampler->steps() - warm_up) % thin == 0;
  for (int c = 0; c < sampler->chains(); ++c) {
    const StepStats& step = sampler->stats()[static_cast<std::size_t>(c)];
    StepStats& sum = since[static_cast<std::size_t>(c)];
    divergent += step.divergent;
    sum.evaluations += step.evaluations;
    sum.broken += step.broken;
    sum.divergent |= step.divergent;
    if (!draw) continue;
    StepStats stats = step;
    stats.evaluations = sum.evaluations;
    stats.broken = sum.broken;
    stats.divergent = sum.divergent;
    put_draw(stats, sampler->positions().col(c), pending);
    sum = {};
  }
}

Eigen::MatrixXd SamplerSlot::take() {
  const Eigen::Index rows = sampler->chains() * rows_of_draw(sampler->positions().rows());
  const Eigen::MatrixXd draws = Eigen::Map<const Eigen::MatrixXd>(
      pending.data(), rows, static_cast<Eigen::Index>(pending.size()) / rows);
  pending.clear();
  return draws;
}

std::vector<Place> SamplerSlot::places() const {
  std::vector<Place> all;
  for (int c = 0; c < sampler->chains(); ++c)
    all.push_back({sampler->positions().col(c), sampler->density(c)});
  return all;
}

void SamplerSlot::retemper(double temper) {
  sampler->retemper(temper);
  tally = SwapTally(static_cast<int>(tally.tried.size()) + 1);
}

void SamplerSlot::save(StateWriter& to) const {
  sampler->save(to);
  tally.save(to);
  to.put(std::int64_t{divergent});
  for (const StepStats& sum : since)
    for (const int number : {sum.evaluations, sum.broken, int(sum.divergent)})
      to.put(std::int64_t{number});
}

void SamplerSlot::restore(StateReader& from) {
  sampler->restore(from);
  tally.restore(from);
  divergent = from.integer();
  for (StepStats& sum : since) {
    sum.evaluations = static_cast<int>(from.integer());
    sum.broken = static_cast<int>(from.integer());
    sum.divergent = from.integer() != 0;
  }
}

}  // namespace thenar::internal
