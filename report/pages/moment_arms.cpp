#include "report/pages/digit_page.h"

#include "base/units.h"
#include "report/answers/digit_words.h"
#include "report/answers/moment_arms.h"
#include "report/words.h"

namespace thenar {
namespace {

using Eigen::Index;

/// A chart for each joint, and one of lengths.
Json arm_charts_of(const MomentArmResult& answer) {
  // A curve for each muscle that crosses the joint.
  const SweepAxes axes = axes_of(answer);
  Json charts = Json::array();
  for (Index j = 0; j < answer.crosses.cols(); ++j) {
    const std::string& joint = nth(answer.rows, j);
    std::vector<Curve> curves;
    for (Index m = 0; m < answer.crosses.rows(); ++m)
      if (answer.crosses(m, j))
        curves.push_back(
            curve_over(answer.points, nth(answer.muscles, m),
                       [m, j](const MomentArmPoint& p) { return p.arms(m, j) / kMm; }));
    charts.push_back(curve_chart(axes, "Moment arms about " + joint,
                                 "arm, " + positive_motion(joint) + " positive [mm]", curves));
  }
  // Lengths change with all joints, so they have one chart.
  std::vector<Curve> lengths;
  for (Index m = 0; m < answer.crosses.rows(); ++m)
    lengths.push_back(
        curve_over(answer.points, nth(answer.muscles, m),
                   [m](const MomentArmPoint& p) { return p.length_change(m) / kMm; }));
  charts.push_back(curve_chart(axes, "Length change since the posture " + reference_words(answer),
                               "change, longer positive [mm]", lengths));
  return paired(charts);
}

}  // namespace

Json page_of(const MomentArmResult& answer) {
  // The digit, then numbers, and curves if the posture varies.
  Json blocks = Json::array();
  MeshTable meshes;
  const Json scene = digit_scene(answer, "The digit and its tendons.", meshes,
                                 [](std::size_t, const std::string&, Json&) {});
  if (!scene.is_null()) blocks.push_back(scene);
  blocks.push_back(table_block("Arms and length changes.", table_of(answer)));
  const std::string words = "A moment arm is the tendon shortening per radian of joint rotation: " +
                            sign_words(answer.rows) + ". Lengths are counted from the posture " +
                            reference_words(answer) + ".";
  Json sections =
      Json::array({section("arms", "Moment arms", digit_introduction(answer, words), blocks)});
  if (!answer.single() && !answer.points.empty())
    sections.push_back(
        section("curves", "Moment arms over the posture", "", arm_charts_of(answer)));
  // Sum up by the range of all arms.
  std::vector<double> arms;
  for (const MomentArmPoint& point : answer.points)
    if (point.message.empty())
      for (const double arm : point.arms.reshaped()) arms.push_back(arm / kMm);
  return digit_page(answer, "moment arms", sections, meshes,
                    arms.empty() ? "No moment arm can be determined."
                                 : fmt::format("The moment arms are {}.", range_words(arms, "mm")));
}

}  // namespace thenar
