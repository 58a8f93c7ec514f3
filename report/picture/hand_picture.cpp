#include "report/picture/hand_picture.h"

#include <algorithm>
#include <cmath>

#include "report/picture/skin_layer.h"

namespace thenar {
namespace {

constexpr const char* kSkin = "#dfab8f";
constexpr const char* kBone = "#e6dcc3";
constexpr const char* kPalm = "#7d8794";
constexpr const char* kCarrier = "#a3abb5";
constexpr const char* kObject = "#e6a83c";
constexpr const char* kObstacle = "#b9c0c9";
constexpr const char* kContact = "#b3261e";
constexpr double kObjectOpacity = 0.6;  // Opacity of the object [1]
// Length of arrows and of sides of cones, over the object's reach [1], and the largest [m]
constexpr double kArrowShare = 0.25;
constexpr double kMaxArrowLength = 12e-3;

/// Colours of digits, paler than those of charts.
const char* digit_color(std::size_t index) {
  static constexpr const char* kColors[] = {"#6fa8cf", "#8dbb95", "#c7a6d1",
                                            "#d3a15f", "#7cc0c4", "#b0a37a"};
  return kColors[index % std::size(kColors)];
}

std::vector<std::string> digits_of(const Hand& hand) {
  std::vector<std::string> digits;
  for (const LinkSurface& surface : hand.surfaces())
    if (!contains(digits, surface.digit)) digits.push_back(surface.digit);
  return digits;
}

bool is_skin(const LinkSurface& surface) {
  return surface.material == "skin" || surface.material == "fingertip";
}

std::string color_of(const Hand& hand, const std::string& digit, std::size_t index) {
  for (const LinkSurface& surface : hand.surfaces()) {
    if (surface.digit != digit) continue;
    if (is_skin(surface)) return kSkin;
    if (surface.material == "bone") return kBone;
  }
  return digit.empty() ? kPalm : digit_color(index);
}

/// The look of a surface: nails on skin.
MeshLook look_of(const LinkSurface& surface, const std::vector<SkinPatch>& patches) {
  if (surface.material == "bone") return {};
  if (!is_skin(surface)) return {kBodyCrease, {}};
  return {-1, nail_colors(surface.solid->visual, patches, surface.digit, surface.link)};
}

Json body_item(const GraspBody& body, MeshTable& meshes) {
  return mesh_item(meshes.add(body.solid.visual, {kBodyCrease, {}}), body.X_WB);
}

}  // namespace

Json hand_layers(const HandPicture& picture, MeshTable& meshes) {
  // Pose the links once; digits become layers, carriers one of their own.
  const Hand& hand = picture.hand;
  const std::vector<Pose<double>> links = hand.pose(picture.q);
  const std::vector<std::string> digits = digits_of(hand);
  Json layers = Json::array(), carriers = Json::array();
  for (std::size_t d = 0; d < digits.size(); ++d) {
    Json items = Json::array();
    for (std::size_t s = 0; s < hand.surfaces().size(); ++s) {
      const LinkSurface& surface = hand.surfaces()[s];
      if (surface.digit != digits[d] || surface.solid->visual.empty()) continue;
      const Pose<double> X =
          surface.link < 0 ? picture.X_WH : picture.X_WH * nth(links, surface.link);
      const MeshLook look = look_of(surface, picture.patches);
      (s < static_cast<std::size_t>(picture.carrier_surfaces) ? carriers : items)
          .push_back(mesh_item(meshes.add(surface.solid->visual, look), X));
    }
    if (items.empty()) continue;
    const std::string name = digits[d].empty() ? "palm" : digits[d];
    layers.push_back(layer(name, color_of(hand, digits[d], d), std::move(items)));
  }
  if (!carriers.empty())
    layers.push_back(with(layer("carrier", kCarrier, carriers), {{"fit", false}}));
  return layers;
}

Json setup_layers(const GraspSetup& setup, MeshTable& meshes) {
  Json item = body_item(setup.object, meshes);
  item["opacity"] = kObjectOpacity;
  Json layers = Json::array({layer(setup.object.name, kObject, Json::array({item}))});
  Json items = Json::array();
  for (const GraspBody& body : setup.obstacles) items.push_back(body_item(body, meshes));
  if (items.empty()) return layers;
  layers.push_back(with(layer("obstacles", kObstacle, std::move(items)), {{"fit", false}}));
  return layers;
}

Json contact_layers(const std::vector<HandContact>& contacts, const Pose<double>& X_WO,
                    double reach) {
  // Arrows along the normals, and cones of friction whose slant height is the arrow's length.
  const double length = std::min(kArrowShare * reach, kMaxArrowLength);
  Json points = Json::array(), normals = Json::array(), cones = Json::array();
  for (const HandContact& found : contacts) {
    const Contact contact = transform_contact(X_WO, found.contact);
    points.push_back(in_mm(contact.p));
    normals.push_back({{"kind", "arrow"},
                       {"from", in_mm(contact.p)},
                       {"vector", in_mm(length * contact.n)},
                       {"radius", 25 * length}});
    const double height = length / std::hypot(1, contact.friction);
    cones.push_back({{"kind", "cone"},
                     {"tip", in_mm(contact.p)},
                     {"axis", in_mm(height * contact.n)},
                     {"radius", 1000 * height * contact.friction}});
  }
  if (contacts.empty()) return Json::array();
  normals.push_back({{"kind", "points"}, {"positions", points}, {"radius", 70 * length}});
  return Json::array({layer("contacts", kContact, std::move(normals)),
                      layer("friction cones", kContact, std::move(cones))});
}

Json picture_block(const std::string& caption, const Eigen::Vector3d& view, Json layers) {
  return {{"type", "scene"},
          {"caption", caption},
          {"view", numbers3(view)},
          {"layers", std::move(layers)}};
}

Json thumbnail_block(const std::string& caption, const Eigen::Vector3d& view, Json layers) {
  return with(picture_block(caption, view, std::move(layers)), {{"compact", true}});
}

}  // namespace thenar
