#pragma once

/// Pages about one digit: poses, moment arms, forces of its tip; and their common parts.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "api/feasible_force.h"
#include "api/moment_arms.h"
#include "api/named/digit_result.h"
#include "api/pose.h"
#include "api/tip_force.h"
#include "base/numbers.h"
#include "report/picture/mesh_table.h"
#include "report/sweep_axes.h"

namespace thenar {

/// Returns a page with joints, bones or links, and tips in space and in rows.
[[nodiscard]] Json page_of(const SubjectPoses& poses);
[[nodiscard]] Json page_of(const RobotPoses& poses);
/// Returns a page with the tendons in space, arms and lengths over the joints that vary.
[[nodiscard]] Json page_of(const MomentArmResult& answer);
/// Returns a page with the force of the tip in space, in rows, over the joints that vary.
[[nodiscard]] Json page_of(const TipForceResult& answer);
/// Returns a page with the largest forces in space, their limits, and charts over the joints that
/// vary.
[[nodiscard]] Json page_of(const FeasibleForceResult& answer);

/// Largest number of drawn postures, and their colours, from the first to the last.
inline constexpr std::size_t kDrawnPostures = 5;
inline constexpr std::array<const char*, kDrawnPostures> kPostureTints{
    "#b8a48a", "#7fa8c9", "#5fa38c", "#c98f5f", "#9a7fb8"};

/// Returns a page with its header and provenance. @param what  "tip forces";  @param meshes  meshes
/// that its scenes refer to
/// @param learnt  sentences on the result, for the first paragraph
[[nodiscard]] Json digit_page(const DigitResult& about, const std::string& what, Json sections,
                              const MeshTable& meshes, const std::string& learnt);

/// Returns the range of values in words: "0.31 N", "0.21 to 0.42 N"; "" without values.
[[nodiscard]] std::string range_words(const std::vector<double>& values, const std::string& unit);

/// Returns the text of a first section: the question, its postures, and every warning.
[[nodiscard]] std::string digit_introduction(const DigitResult& about, const std::string& words);

/// Adds further layers to the picture of a posture. @param tint  colour of the posture
using AddLayers = std::function<void(std::size_t point, const std::string& tint, Json& layers)>;

/// Returns a scene with the bones at up to kDrawnPostures postures, each a layer, and tendons where
/// they are straight; null for a map. The first posture is drawn within the subject's skin.
/// @param meshes  receives the meshes of the skin
/// @param add     adds layers to each posture
[[nodiscard]] Json digit_scene(const DigitResult& about, const std::string& caption,
                               MeshTable& meshes, const AddLayers& add);

/// Returns the length of arrows per force [mm/N], so that the largest force is 40 mm long.
[[nodiscard]] double arrow_scale(double largest);

/// Returns a layer with one arrow. @param from  origin [m] (3);  @param vector  drawn vector [mm]
/// (3)
[[nodiscard]] Json arrow_layer(const std::string& name, const std::string& color,
                               const Eigen::Vector3d& from, const Eigen::Vector3d& vector);

/// Returns a quantity at every posture; NaN where there is no result. @param value  returns it for
/// one point
template <typename Point, typename Value>
[[nodiscard]] Curve curve_over(const std::vector<Point>& points, const std::string& name,
                               const Value& value) {
  Curve curve{name, Eigen::VectorXd(static_cast<Eigen::Index>(points.size()))};
  for (std::size_t i = 0; i < points.size(); ++i)
    curve.y(static_cast<Eigen::Index>(i)) = points[i].message.empty() ? value(points[i]) : kNaN;
  return curve;
}

/// Returns charts in rows of two.
[[nodiscard]] Json paired(const Json& charts);

}  // namespace thenar
