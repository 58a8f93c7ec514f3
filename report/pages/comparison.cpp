#include "report/pages/comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.h"
#include "grasp/closing/closing_drives.h"
#include "report/pages/comparison_tables.h"
#include "report/pages/grasp.h"
#include "report/scene/grasp_view.h"

namespace thenar {
namespace {

const ComparePicture* picture_of(const std::vector<ComparePicture>& pictures,
                                 const std::string& hand) {
  for (const ComparePicture& each : pictures)
    if (each.hand == hand) return &each;
  return nullptr;
}

/// Where the tips are from the palm's point, across the way of approach; zero where they stand
/// round it. [m] (3)
Eigen::Vector3d tips_ahead(const Hand& hand, const Eigen::VectorXd& q) {
  constexpr double kRound = 0.02;  // [m]
  const HandLayout& layout = hand.layout();
  const std::vector<Pose<double>> links = hand.pose(q);
  Eigen::Vector3d ahead = Eigen::Vector3d::Zero();
  for (const HandTip& tip : layout.tip_points)
    ahead += (tip.link < 0 ? tip.p : links[tip.link] * tip.p) - layout.approach.point;
  ahead /= static_cast<double>(std::max<std::size_t>(layout.tip_points.size(), 1));
  ahead -= layout.approach.direction.dot(ahead) * layout.approach.direction;
  return ahead.norm() < kRound ? Eigen::Vector3d::Zero() : ahead;
}

/// From the side, a little from the back of the palm and from where fingers point, so that no
/// forearm stands in the way.
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

Json best_picture(const HandOnObject& cell, const Scene& scene, const ComparePicture& picture,
                  MeshTable& meshes) {
  const BestGrasp& best = cell.best.front();
  const HandPicture hand{*picture.drawn, best.q, best.X_WH, picture.patches};
  const std::string caption = fmt::format(
      "{}: epsilon {:.3f}{}, {} contact{}, {}", cell.hand, best.epsilon,
      std::isfinite(best.hand_epsilon) ? fmt::format(", of the hand {:.1f} N", best.hand_epsilon)
                                       : "",
      best.contacts.size(), best.contacts.size() == 1 ? "" : "s",
      best.type.empty() ? "no type" : best.type);
  Json layers = grasp_layers(hand, scene, best.contacts, meshes);
  for (Json& layer : layers)
    if (layer["name"] == "palm") layer["fit"] = false;  // it may be a forearm
  const Eigen::Vector3d up = -(best.X_WH.R * picture.drawn->layout().approach.direction);
  const Eigen::Vector3d eye =
      view_of_contacts(hand, scene, best.contacts, {eye_for(*picture.drawn, best), up, -kPi / 2});
  Json block = thumbnail_block(caption, eye, std::move(layers));
  block["up"] = numbers3(up);
  return block;
}

/// The object at the origin, as the comparison had it.
Scene scene_of(const BodySpec& object, double scale) {
  Scene scene;
  scene.object = build_body({scaled(object, scale), "", {}, true});
  return scene;
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
    blocks.push_back(best_picture(cell, scene_of(object, cell.scale), *picture, meshes));
  }
  Json row = row_block(std::move(blocks));
  row["narrow"] = true;
  return row;
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
                 "contacts, cones the forces that do not slip. Drag a picture to turn it.",
                 blocks);
}

}  // namespace

Json hands_section(const std::vector<ComparePicture>& pictures, MeshTable& meshes) {
  Json blocks = Json::array();
  for (const ComparePicture& picture : pictures) {
    const Hand& hand = *picture.drawn;
    const HandPicture shown{hand, open_posture(hand.layout()), {}, picture.patches};
    const Eigen::Vector3d palm = hand.layout().approach.direction;
    const Eigen::Vector3d ahead = tips_ahead(hand, shown.q);
    const Eigen::Vector3d up = ahead.isZero(0) ? tangents(palm).e1 : ahead.normalized();
    Json block = thumbnail_block(
        fmt::format("{}: {} coordinates, {} actuators", picture.hand,
                    hand.layout().coordinates.size(), hand.layout().actuators.size()),
        palm + 0.35 * up + 0.25 * palm.cross(up), hand_layers(shown, meshes));
    block["up"] = numbers3(up);  // the side of the light: else palms that look down are dark
    blocks.push_back(std::move(block));
  }
  Json row = row_block(std::move(blocks));
  row["narrow"] = true;
  return section("hands", "The hands", "Seen at the palm, open as they begin to close.",
                 Json::array({row}));
}

Json compare_page(const Comparison& comparison, const std::vector<BodySpec>& objects,
                  const std::vector<ComparePicture>& pictures, MeshTable& meshes,
                  const Progress& progress) {
  Json sections = Json::array();
  sections.push_back(glance_section(comparison));
  if (!pictures.empty()) sections.push_back(hands_section(pictures, meshes));
  sections.push_back(cells_section(comparison));
  sections.push_back(distribution_section(comparison));
  if (!pictures.empty())
    sections.push_back(best_section(comparison, objects, pictures, meshes, progress));
  sections.push_back(abilities_section(comparison));
  sections.push_back(reading_section(comparison));
  return sections;
}

}  // namespace thenar
