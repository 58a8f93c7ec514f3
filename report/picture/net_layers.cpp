#include "report/picture/net_layers.h"

#include "tendons/net/band_course.h"

namespace thenar {
namespace {

constexpr const char* kSlackGrey = "#8a8f99";

Json line(const std::vector<Eigen::Vector3d>& points) {
  return {{"kind", "line"}, {"positions", list_of_each(points, in_mm)}};
}

}  // namespace

Json finger_layer(const NetTendons& tendons, const TreeState<double>& state) {
  const FingerFrame& frame = tendons.net().frame;
  Json items = Json::array();
  constexpr double kShownOfPalm = 0.4;  // drawn distal share of the metacarpal [1]
  for (std::size_t i = 0; i < frame.bones.size(); ++i) {
    FingerBone bone = frame.bones[i];
    if (i == 0) bone.proximal = bone.distal + kShownOfPalm * (bone.proximal - bone.distal);
    // Heads are as thick as the extensor runs high over them, less the tendon itself.
    const double height = frame.height[std::min<std::size_t>(i, 2)];
    items.push_back({{"kind", "segment"},
                     {"a", in_mm(moved(state, bone.link, bone.proximal))},
                     {"b", in_mm(moved(state, bone.link, bone.distal))},
                     {"radius", 1e3 * 0.6 * height}});
  }
  return layer("bones", "#d8cbb3", items);
}

Json surface_layer(const NetTendons& tendons, const TreeState<double>& state) {
  Json items = Json::array();
  for (const BoneSurface& surface : tendons.net().net.surfaces) {
    const Pose<double> X = surface_pose(surface, state);
    items.push_back({{"kind", "surface"},
                     {"shape", name_in(kSurfaceShapeNames, surface.shape)},
                     {"size", numbers3(1e3 * surface.size)},
                     {"center", in_mm(X.p)},
                     {"axes", {numbers3(X.R.col(0)), numbers3(X.R.col(1)), numbers3(X.R.col(2))}}});
  }
  return layer("surfaces of bones", "#a08f70", items);
}

Json band_layers(const NetTendons& tendons, const TreeState<double>& state,
                 const NetEquilibrium& rest) {
  const Net& net = tendons.net().net;
  // Taut bands are coloured by tension, slack ones dashed.
  Json taut = Json::array(), slack = Json::array();
  for (std::size_t k = 0; k < net.bands.size(); ++k) {
    const auto band = static_cast<Eigen::Index>(k);
    Json item = line(band_course(net, state, rest, static_cast<int>(k)).points);
    if (rest.tension[band] > kTautTension) {
      item["value"] = rest.tension[band];
      item["width"] = net.bands[k].muscle < 0 ? 6 : 4;
      taut.push_back(item);
    } else {
      item["dashed"] = true;
      item["width"] = 2.5;
      slack.push_back(item);
    }
  }
  // Knots that float, and their names in a layer that is hidden at first.
  Json knots = Json::array(), ties = Json::array();
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    if (!net.nodes[i].free) continue;
    knots.push_back(in_mm(rest.x.col(static_cast<Eigen::Index>(i))));
    ties.push_back({{"kind", "points"},
                    {"positions", Json::array({knots.back()})},
                    {"radius", 0.6},
                    {"label", net.nodes[i].name}});
  }
  Json names = layer("knots by name", "#1b1f24", ties);
  names["visible"] = false;
  return Json::array(
      {layer("taut bands", "#a82296", taut), layer("slack bands", kSlackGrey, slack),
       layer("knots", "#1b1f24",
             Json::array({{{"kind", "points"}, {"positions", knots}, {"radius", 0.55}}})),
       names});
}

Json muscle_layer(const NetTendons& tendons, const TreeState<double>& state,
                  const Eigen::VectorXd& t) {
  // Draw the muscle from the net to where it turns no joint any more.
  Json items = Json::array();
  const std::vector<std::string>& names = tendons.digit().names.muscles;
  for (const NetMuscle& muscle : tendons.net().muscles) {
    std::vector<Eigen::Vector3d> points;
    for (const PathNode<double>& node : muscle.own_path) {
      points.push_back(moved(state, node.link, node.p));
      if (node.link < 0 && points.size() > 1) break;  // further up it turns no joint
    }
    if (points.size() < 2) continue;
    Json item = line(points);
    const double pull = muscle.to_net * t[muscle.muscle];
    item["label"] = nth(names, muscle.muscle);
    item["width"] = 4;
    item[pull > 0 ? "value" : "dashed"] = pull > 0 ? Json(pull) : Json(true);
    items.push_back(item);
  }
  return layer("muscles beyond the net", kSlackGrey, items);
}

}  // namespace thenar
