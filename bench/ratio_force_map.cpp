// Thumb force maps at two postures for new axes, against rebuilding a Simbody system.

#include "bench/ratios.h"
#include "tests/hand/thumb_axes.h"

namespace thenar::bench {

Row ratio_force_map() {
  sample::Draw draw(3);
  const sample::ThumbTask task = sample::thumb_task(draw);
  const sample::PairedThumb thumb = sample::paired(task);
  std::vector<sample::AxisParameters> parameters;
  for (int i = 0; i < 64; ++i) parameters.push_back(sample::axis_parameters(draw));

  Duel duel{"thumb force maps, new axes, 2 postures", {}, {}, 200, 0, 1e-11};
  for (const sample::AxisParameters& by : parameters)
    duel.error =
        std::max(duel.error, sample::difference(sample::apart(sample::thumb_maps(task, thumb, by)),
                                                sample::thumb_maps_by_simbody(task, by)));
  duel.ours = [&, i = 0U]() mutable {
    keep(sample::thumb_maps(task, thumb, parameters[i++ % 64]));
  };
  duel.rival = [&, i = 0U]() mutable {
    keep(sample::thumb_maps_by_simbody(task, parameters[i++ % 64]));
  };
  return measure(duel);
}

}  // namespace thenar::bench
