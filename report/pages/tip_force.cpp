#include "report/pages/digit_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/units.h"
#include "report/answers/digit_words.h"
#include "report/answers/tip_force.h"

namespace thenar {
namespace {

Json tip_charts(const TipForceResult& answer) {
  const SweepAxes axes = axes_of(answer);
  // Force along the tip's own axes, left over torque of the joints, and moments of a clamped tip.
  std::vector<Curve> force, torque, moment;
  const char* const names[] = {"proximal", "dorsal", "radial"};
  const char* const world[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    force.push_back(curve_over(answer.points, names[k], [k](const TipForcePoint& point) {
      return point.singular ? kNaN : force_along_tip(point)(k);
    }));
    moment.push_back(curve_over(answer.points, world[k], [k](const TipForcePoint& point) {
      return point.moment(k) / kNewtonMillimetre;
    }));
  }
  for (std::size_t j = 0; j < answer.rows.size(); ++j)
    torque.push_back(curve_over(answer.points, answer.rows[j], [j](const TipForcePoint& point) {
      return point.residual(static_cast<Eigen::Index>(j)) / kNewtonMillimetre;
    }));
  Json charts =
      Json::array({curve_chart(axes,
                               "Force of the tip on the world along its own axes; none at singular "
                               "postures",
                               "force [N]", force),
                   curve_chart(axes, "Size of the force", "force [N]",
                               {curve_over(answer.points, "size",
                                           [](const TipForcePoint& point) {
                                             return point.singular ? kNaN : point.force.norm();
                                           })}),
                   curve_chart(axes, "Joint torque left over, that no load of the tip balances",
                               "torque [N mm]", torque)});
  if (answer.request.hold == TipConstraint::kRigid)
    charts.push_back(
        curve_chart(axes, "Moment of the tip on the world, world axes", "moment [N mm]", moment));
  return paired(charts);
}

Json tip_scene(const TipForceResult& answer, MeshTable& meshes) {
  double largest = 0;
  for (const TipForcePoint& point : answer.points)
    if (!point.singular) largest = std::max(largest, point.force.norm());
  const double scale = arrow_scale(largest);
  return digit_scene(
      answer,
      fmt::format("The digit, and the force of its tip on the world: 10 mm represents {:.3g} N.",
                  10 / scale),
      meshes, [&](std::size_t i, const std::string&, Json& layers) {
        const TipForcePoint& point = answer.points[i];
        if (point.message.empty() && !point.singular)
          layers.push_back(arrow_layer("force", "#d55e00", point.tip, scale * point.force));
      });
}

std::string tension_words(const TipForceResult& answer) {
  std::string text;
  for (std::size_t m = 0; m < answer.muscles.size(); ++m)
    if (const double t = answer.tension(static_cast<Eigen::Index>(m)); t > 0)
      text += fmt::format("{}{} {:.4g} N", text.empty() ? "" : ", ", answer.muscles[m], t);
  return text.empty() ? "no muscle pulls" : text;
}

}  // namespace

Json page_of(const TipForceResult& answer) {
  // Say what holds the tip, as it decides about moments.
  const std::string words = fmt::format(
      "Tensions: {}. The tip is {}; the force is what the tip does to the world.",
      tension_words(answer),
      answer.request.hold == TipConstraint::kRigid ? "clamped, so that it also carries a moment"
                                                   : "pinned by a point, which carries no moment");
  Json blocks = Json::array();
  MeshTable meshes;
  if (const Json scene = tip_scene(answer, meshes); !scene.is_null()) blocks.push_back(scene);
  blocks.push_back(table_block("The force at every posture.", table_of(answer)));
  Json sections = Json::array(
      {section("force", "Force of the fingertip", digit_introduction(answer, words), blocks)});
  if (!answer.single() && !answer.points.empty())
    sections.push_back(section("curves", "Over the posture", "", tip_charts(answer)));
  // Sum up by the size of the force.
  std::vector<double> sizes;
  for (const TipForcePoint& point : answer.points)
    if (point.message.empty()) sizes.push_back(point.force.norm());
  return digit_page(answer, "tip forces", sections, meshes,
                    sizes.empty() ? "No force of the tip on the world can be determined."
                                  : fmt::format("The force of the tip on the world is {}.",
                                                range_words(sizes, "N")));
}

}  // namespace thenar
