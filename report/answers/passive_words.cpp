#include "report/answers/passive_words.h"

#include <fmt/format.h>

#include "base/units.h"
#include "hand/passive_moment.h"

namespace thenar {

std::string passive_line(const Skeleton& skeleton, const Eigen::VectorXd& q) {
  if (!has_passive(skeleton)) return "";
  const Eigen::VectorXd tau = passive_torque(skeleton, q);
  std::string line = "passive joint moments, included [N mm]:";
  for (Eigen::Index i = 0; i < tau.size(); ++i)
    line += fmt::format("{} {} {:.3g}", i == 0 ? "" : ",", nth(skeleton.coordinate_names, i),
                        tau[i] / kNewtonMillimetre);
  return line + "\n";
}

std::string passive_line(const DigitResult& about) {
  if (!about.tendons || !has_passive(about.tendons->digit().skeleton)) return "";
  if (about.single())
    return passive_line(about.tendons->digit().skeleton, about.grid.postures.front());
  return "passive moments of joints are counted\n";
}

void add_passive(const Skeleton& skeleton, const Eigen::VectorXd& q, Fields& fields) {
  if (has_passive(skeleton))
    fields.add("passive_moment", units::kNewtonMetre, skeleton.coordinate_names,
               passive_torque(skeleton, q));
}

void add_passive(const DigitResult& about, std::size_t point, Fields& fields) {
  if (about.tendons)
    add_passive(about.tendons->digit().skeleton, about.grid.postures[point], fields);
}

}  // namespace thenar
