#include "report/answers/fitted_value.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace thenar {
namespace {

/// The coordinate that an entry of z moves, of the population or as a deviation from it.
struct MovedCoordinate {
  int coordinate = 0;
  bool deviation = false;
};

MovedCoordinate moved_by(const Fit& fit, int entry) {
  const FitCoordinates& all = fit.problem.coordinates();
  for (int c = 0; c < all.parameters().coordinates(); ++c) {
    const CoordinateEntries& of = all.entries(c);
    if (of.population == entry) return {c, false};
    if (of.deviation >= 0 && entry >= of.deviation &&
        (entry - of.deviation) % std::max(1, all.deviations()) == 0)
      return {c, true};
  }
  return {};
}

}  // namespace

std::optional<CoordinateInUnit> value_in_unit(const Fit& fit, int entry) {
  const MovedCoordinate moved = moved_by(fit, entry);
  // One specimen has no deviations: its prior is that of the population and of people together.
  const bool alone = fit.problem.specimens().size() == 1;
  if (moved.deviation && !alone) return std::nullopt;
  const FitParameters& parameters = fit.problem.parameters();
  const Parameter& p =
      parameters.all[static_cast<std::size_t>(parameters.leader[moved.coordinate])];
  const double prior_sd = (alone ? std::hypot(p.sd, p.between_sd) : p.sd) * display_scale(p);
  const CoordinateEstimate& learnt = fit.covariance.learnt[static_cast<std::size_t>(entry)];
  return CoordinateInUnit{p.mean * display_scale(p) + prior_sd * learnt.z, prior_sd * learnt.sd,
                          prior_sd, display_unit(p)};
}

std::string words_of(const CoordinateInUnit& value) {
  return fmt::format("{:+.2f} \u00b1 {:.2f}{}", value.value, value.sd,
                     value.unit == "1" ? "" : " " + value.unit);
}

}  // namespace thenar
