#include "report/pages/comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.h"
#include "base/words.h"
#include "grasp/closing/closing_drives.h"
#include "report/pages/comparison_tables.h"
#include "report/pages/grasp.h"
#include "report/picture/grasp_view.h"

namespace thenar {
namespace {

const ComparePicture* picture_of(const std::vector<ComparePicture>& pictures,
                                 const std::string& hand) {
  return find_where(pictures, [&](const ComparePicture& each) { return each.hand == hand; });
}

/// Computes the mean offset of the tips from the palm's point, across the way of approach; zero
/// where the tips stand round it. [m] (3)
Eigen::Vector3d tips_ahead(const Hand& hand, const Eigen::VectorXd& q) {
  constexpr double kMinOffset = 0.02;  // Offset below which tips stand round the palm [m]
  const HandLayout& layout = hand.layout();
  const std::vector<Pose<double>> links = hand.pose(q);
  Eigen::Vector3d ahead = Eigen::Vector3d::Zero();
  for (const HandTip& tip : layout.tip_points)
    ahead += (tip.link < 0 ? tip.p : links[tip.link] * tip.p) - layout.approach.point;
  ahead /= static_cast<double>(std::max<std::size_t>(layout.tip_points.size(), 1));
  ahead -= layout.approach.direction.dot(ahead) * layout.approach.direction;
  return ahead.norm() < kMinOffset ? Eigen::Vector3d::Zero() : ahead;
}

/// A hand whose palm looks along x and whose fingers point along z.
Pose<double> upright(const Hand& hand, const Eigen::VectorXd& q) {
  const Eigen::Vector3d palm = hand.layout().approach.direction, ahead = tips_ahead(hand, q);
  const Eigen::Vector3d up = ahead.isZero(0) ? tangents(palm).e1 : ahead.normalized();
  Pose<double> X_WH;
  X_WH.R.row(0) = palm.transpose();
  X_WH.R.row(1) = up.cross(palm).transpose();
  X_WH.R.row(2) = up.transpose();
  return X_WH;
}

/// Computes a direction to look from: the side, a little from the back of the palm and from where
/// fingers point, so that no forearm stands in the way.
Eigen::Vector3d eye_for(const Hand& hand, const BestGrasp& best) {
  const Eigen::Vector3d back = -hand.layout().approach.direction;
  const Eigen::Vector3d ahead = tips_ahead(hand, best.q);
  if (ahead.isZero(0)) {
    const Tangents side = tangents(back);
    return best.X_WH.R * (side.e1 + 0.6 * back + 0.4 * side.e2);
  }
  const Eigen::Vector3d along = ahead.normalized();
  return best.X_WH.R * (back.cross(along) + 0.5 * back + 0.5 * along);
}

Json best_picture(const HandOnObject& cell, const GraspSetup& setup, const ComparePicture& picture,
                  MeshTable& meshes) {
  // Tell epsilon by contacts alone and within the hand's limits.
  const BestGrasp& best = cell.best.front();
  const HandPicture hand{*picture.drawn, best.q, best.X_WH, picture.patches};
  const std::string caption =
      fmt::format("{}: epsilon {:.3f}{}, {} contact{}, {}", cell.hand, best.epsilon,
                  std::isfinite(best.hand_epsilon)
                      ? fmt::format(", {:.1f} N within hand limits", best.hand_epsilon)
                      : "",
                  best.contacts.size(), best.contacts.size() == 1 ? "" : "s",
                  best.type.empty() ? "no type" : best.type);
  Json layers = grasp_layers(hand, setup, best.contacts, meshes);
  for (Json& layer : layers)
    if (layer["name"] == "palm") layer["fit"] = false;  // it may be a forearm
  // Look from where most contacts and most of the object are seen.
  const Eigen::Vector3d eye =
      view_of_contacts(hand, setup, best.contacts,
                       {eye_for(*picture.drawn, best), Eigen::Vector3d::UnitZ(), -kPi / 2});
  return thumbnail_block(caption, eye, std::move(layers));
}

/// The object at the origin, as the comparison had it.
GraspSetup setup_of(const BodySpec& object, double scale) {
  GraspSetup setup;
  setup.object = build_body({scaled(object, scale), "", {}, true});
  return setup;
}

/// A row of thumbnails: the best grasp of every hand.
Json best_row(const Comparison& comparison, const BodySpec& object,
              const std::vector<ComparePicture>& pictures, MeshTable& meshes,
              const Progress& progress) {
  Json blocks = Json::array();
  for (const HandOnObject& cell : comparison.cells) {
    if (progress.stop()) break;
    const ComparePicture* picture = picture_of(pictures, cell.hand);
    if (cell.object != object.name || cell.best.empty() || picture == nullptr) continue;
    blocks.push_back(best_picture(cell, setup_of(object, cell.scale), *picture, meshes));
  }
  return with(row_block(std::move(blocks)), {{"narrow", true}});
}

/// Hands without a grasp of an object, said in words.
std::string without(const Comparison& comparison, const std::string& object) {
  std::vector<std::string> hands;
  for (const HandOnObject& cell : comparison.cells)
    if (cell.object == object && cell.best.empty()) hands.push_back(cell.hand);
  return hands.empty() ? "" : fmt::format(" None by {}.", fmt::join(hands, ", "));
}

Json best_section(const Comparison& comparison, const std::vector<BodySpec>& objects,
                  const std::vector<ComparePicture>& pictures, MeshTable& meshes,
                  const Progress& progress) {
  // One row for each object, with all hands.
  Json blocks = Json::array();
  for (const BodySpec& object : objects) {
    progress(static_cast<double>(blocks.size()) / (2.0 * static_cast<double>(objects.size())),
             "pictures on " + object.name);
    blocks.push_back(
        text_block(fmt::format("On {}.{}", object.name, without(comparison, object.name))));
    blocks.push_back(best_row(comparison, object, pictures, meshes, progress));
  }
  return section("best", "The best grasps",
                 "Of every hand the grasp with the largest epsilon; the numbers are of that grasp, "
                 "the eye is where most of its contacts and of the object is seen. Red points are "
                 "contacts, cones the forces that do not slip. Objects stand upright: z is up. "
                 "Drag a picture to turn it.",
                 blocks);
}

}  // namespace

Json hands_section(const std::vector<ComparePicture>& pictures, MeshTable& meshes) {
  Json blocks = Json::array();
  // Draw hands upright; show those with nails from the back, too.
  for (const ComparePicture& picture : pictures) {
    const Hand& hand = *picture.drawn;
    const Eigen::VectorXd q = open_posture(hand.layout());
    const HandPicture shown{hand, q, upright(hand, q), picture.patches};
    blocks.push_back(
        thumbnail_block(fmt::format("{}: {}, {}", picture.hand,
                                    counted(hand.layout().coordinates.size(), "coordinate"),
                                    counted(hand.layout().actuators.size(), "actuator")),
                        Eigen::Vector3d(1, -0.25, 0.35), hand_layers(shown, meshes)));
    if (picture.patches.empty()) continue;
    blocks.push_back(thumbnail_block(picture.hand + " from the back, with its nails",
                                     Eigen::Vector3d(-1, 0.25, 0.35), hand_layers(shown, meshes)));
  }
  return section("hands", "The hands",
                 "Open as they begin to close, seen at the palm, human hands from the back, too; "
                 "fingers point up, z.",
                 Json::array({with(row_block(std::move(blocks)), {{"narrow", true}})}));
}

Json compare_page(const Comparison& comparison, const std::vector<BodySpec>& objects,
                  const std::vector<ComparePicture>& pictures, MeshTable& meshes,
                  const Progress& progress) {
  Json sections = Json::array({glance_section(comparison)});
  if (!pictures.empty()) sections.push_back(hands_section(pictures, meshes));
  sections.push_back(cells_section(comparison));
  sections.push_back(distribution_section(comparison));
  if (!pictures.empty())
    sections.push_back(best_section(comparison, objects, pictures, meshes, progress));
  sections.push_back(abilities_section(comparison));
  sections.push_back(reading_section(comparison));
  return sections;
}

Json page_of(const CompareResult& result, const Progress& progress) {
  const std::vector<ComparePicture> pictures = transformed(result.hands, [](const NamedHand& hand) {
    return ComparePicture{hand.name, hand.hand, hand.patches};
  });
  MeshTable meshes;
  const Json sections = compare_page(result.comparison, result.objects, pictures, meshes, progress);
  return {{"title", "Hands compared"},
          {"subtitle", fmt::format("{}", fmt::join(result.comparison.hands, ", "))},
          {"provenance", result.inputs},
          {"meshes", meshes.json()},
          {"sections", sections}};
}

}  // namespace thenar
