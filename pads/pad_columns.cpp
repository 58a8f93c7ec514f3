#include "pads/pad_columns.h"

#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/units.h"

namespace thenar {

FoundationColumns pad_columns(const PadShape& shape, int rings) {
  require(rings > 0, "a bed of springs needs at least one ring, got {}", rings);
  const PadChart chart(shape);
  const auto at = [&](double r, double angle, double level) {
    return chart.place({r * std::cos(angle), r * std::sin(angle), level});
  };
  std::vector<Eigen::Vector3d> skin, normal;
  std::vector<double> thickness, area;
  const double width = 1.0 / rings;
  for (int ring = 0; ring < rings; ++ring) {
    // Cells about as long as wide.
    const double r = (ring + 0.5) * width;
    const int count = static_cast<int>(std::lround(2 * kPi * (ring + 0.5)));
    const double turn = 2 * kPi / count;
    for (int k = 0; k < count; ++k) {
      const double angle = (k + 0.5) * turn;
      const Eigen::Vector3d middle = at(r, angle, 1);
      // Area by the two middle lines of the cell, chords of arcs.
      const Eigen::Vector3d side =
          (at(r + width / 2, angle, 1) - at(r - width / 2, angle, 1))
              .cross(at(r, angle + turn / 2, 1) - at(r, angle - turn / 2, 1));
      skin.push_back(middle);
      area.push_back(side.norm() * turn / 2 / std::sin(turn / 2));
      const Eigen::Vector3d up = middle - at(r, angle, 0);
      thickness.push_back(up.norm());
      normal.push_back(side.normalized());
      if (normal.back().dot(up) < 0) normal.back() *= -1;
    }
  }
  FoundationColumns out;
  const auto count = static_cast<Eigen::Index>(skin.size());
  out.skin.resize(3, count);
  out.normal.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    out.skin.col(i) = skin[static_cast<std::size_t>(i)];
    out.normal.col(i) = normal[static_cast<std::size_t>(i)];
  }
  out.thickness = Eigen::Map<const Eigen::VectorXd>(thickness.data(), count);
  out.area = Eigen::Map<const Eigen::VectorXd>(area.data(), count);
  return out;
}

}  // namespace thenar
