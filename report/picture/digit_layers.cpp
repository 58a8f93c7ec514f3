#include "report/picture/digit_layers.h"

#include <cmath>

#include "base/units.h"
#include "report/words.h"
#include "tendons/neighbouring_axes.h"

namespace thenar {
namespace {

Eigen::Vector3d tip_of(const TendonModel<double>& model, const TreeState<double>& state) {
  return moved(state, model.tip_link, model.tip);
}

}  // namespace

Json axis_words(const Eigen::Matrix3d& directions) {
  const double near = std::cos(30 * kDegree);
  Json words = Json::array({"", "", ""});
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (Eigen::Index k = 0; k < 3; ++k)
      if (std::abs(directions(axis, k)) > near)
        words[axis] = kDirectionWords[k][directions(axis, k) < 0];
  return words;
}

Eigen::Vector3d nearest_axis(const Eigen::Vector3d& direction) {
  Eigen::Index most = 0;
  direction.cwiseAbs().maxCoeff(&most);
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  axis[most] = direction[most] < 0 ? -1 : 1;
  return axis;
}

void add_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, Json& items) {
  if ((b - a).norm() > 1e-6)
    items.push_back({{"kind", "segment"}, {"a", in_mm(a)}, {"b", in_mm(b)}, {"radius", 2.5}});
}

Json digit_scene_block(const std::string& caption, const Eigen::Matrix3d& tip, Json layers) {
  return {{"type", "scene"},
          {"caption", caption},
          {"up", numbers3(tip.col(1))},
          {"axes", axis_words(tip)},
          {"layers", std::move(layers)}};
}

Json bone_layer(const TendonDigit& digit, const Eigen::VectorXd& q, const std::string& color) {
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  const std::vector<Eigen::Vector3d> points = axis_points(digit.model, state);
  Json items = Json::array();
  for (std::size_t i = 1; i < points.size(); ++i) add_segment(points[i - 1], points[i], items);
  if (!points.empty()) add_segment(points.back(), tip_of(digit.model, state), items);
  return layer("bones", color, items);
}

Json axis_layer(const TendonDigit& digit, const Eigen::VectorXd& q, const std::string& name,
                const std::string& color, double length, bool labelled) {
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  const std::vector<Eigen::Vector3d> points = axis_points(digit.model, state);
  Json items = Json::array();
  for (std::size_t i = 0; i < state.size(); ++i) {
    Json item{{"kind", "axis"},
              {"point", in_mm(points[i])},
              {"direction", numbers3(state[i].axis)},
              {"length", 1000 * length}};
    if (labelled) item["label"] = digit.names.hinges[i];
    items.push_back(std::move(item));
  }
  return layer(name, color, items);
}

Json tendon_layer(const TendonDigit& digit, const Eigen::VectorXd& q, const std::string& name,
                  const std::string& color, bool labelled) {
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  Json items = Json::array();
  for (std::size_t s = 0; s < digit.model.paths.size(); ++s) {
    Json positions = Json::array();
    for (const PathNode<double>& node : digit.model.paths[s]) {
      positions.push_back(in_mm(moved(state, node.link, node.p)));
      if (node.link < 0) break;  // the muscle's way up the forearm turns no joint of the digit
    }
    if (positions.size() < 2) continue;
    Json item{{"kind", "line"}, {"positions", positions}};
    if (labelled) item["label"] = digit.names.strands[s];
    items.push_back(std::move(item));
  }
  return layer(name, color, items);
}

Json force_set_layer(const TendonDigit& digit, const Eigen::VectorXd& q,
                     const FeasibleForceSet& set, double mm_per_N, const std::string& color) {
  const Eigen::Vector3d tip = tip_of(digit.model, pose_tree(digit.model.tree, q));
  Json vertices = Json::array(), faces = Json::array();
  for (Eigen::Index i = 0; i < set.vertices.rows(); ++i)
    vertices.push_back(numbers3(1000 * tip + mm_per_N * set.vertices.row(i).transpose()));
  for (Eigen::Index i = 0; i < set.triangles.rows(); ++i)
    faces.push_back({set.triangles(i, 0), set.triangles(i, 1), set.triangles(i, 2)});
  return layer("feasible forces", color,
               Json::array({{{"kind", "hull"}, {"vertices", vertices}, {"faces", faces}}}));
}

}  // namespace thenar
