#include "report/pages/thumbs.h"

#include <cmath>

#include <fmt/format.h>

#include "report/scene/digit_layers.h"
#include "tendons/forces/feasible_force_set.h"
#include "tendons/forces/max_tip_force.h"
#include "tendons/tendon_model.h"

namespace thenar {
namespace {

constexpr double kMmPerNewton = 0.4;
constexpr const char* kDirectionNames[] = {"proximal", "distal", "dorsal",
                                           "palmar",   "radial", "ulnar"};

/// A thumb with all that is shown of it.
struct Shown {
  const ThumbCase& of;
  TendonDigit digit;
  Eigen::VectorXd q;
  TipStatics statics;
  FeasibleForceSet set;
};

Shown prepare(const ThumbCase& of) {
  TendonDigit digit = build_tendon_digit(of.subject, "thumb");
  const Eigen::VectorXd q = posture(digit.skeleton, of.posture);
  TipStatics statics = tip_statics(digit, q);
  FeasibleForceSet set = feasible_force_set(statics);
  return {of, std::move(digit), q, std::move(statics), std::move(set)};
}

Json scene(const Shown& thumb) {
  return {
      {"type", "scene"},
      {"caption", fmt::format("{}: joint axes and feasible thumbtip forces, {} mm per newton",
                              thumb.of.title, kMmPerNewton)},
      {"link", "thumbs"},
      {"layers",
       Json::array({bone_layer(thumb.digit, thumb.q, "#b8a48a"),
                    axis_layer(thumb.digit, thumb.q, "joint axes", "#0072b2", 0.03, true),
                    tendon_layer(thumb.digit, thumb.q, "tendons", "#cc79a7", false),
                    force_set_layer(thumb.digit, thumb.q, thumb.set, kMmPerNewton, "#e69f00")})}};
}

/// Largest force along the six directions of the tip [N].
Json row(const Shown& thumb) {
  const TreeState<double> state = pose_tree(thumb.digit.model.tree, thumb.q);
  const Eigen::Matrix3d axes = state[thumb.digit.model.tip_link].X.R * thumb.digit.model.tip_axes;
  Json cells = Json::array(
      {thumb.of.title, thumb.set.dimension, thumb.set.vertices.rows(), thumb.set.volume});
  for (int k = 0; k < 6; ++k) {
    const MaxTipForce most =
        max_tip_force(thumb.statics, (k % 2 == 0 ? 1.0 : -1.0) * axes.col(k / 2));
    cells.push_back(most.status == Status::kSolved ? Json(std::round(1e6 * most.magnitude) / 1e6)
                                                   : Json(nullptr));
  }
  return cells;
}

}  // namespace

Json thumb_page(const std::vector<ThumbCase>& cases) {
  Json scenes = Json::array(), rows = Json::array();
  for (const ThumbCase& of : cases) {
    const Shown thumb = prepare(of);
    scenes.push_back(scene(thumb));
    rows.push_back(row(thumb));
  }
  std::vector<BlockColumn> columns{
      {"thumb", "", -1}, {"dimension", "", 0}, {"corners", "", 0}, {"volume", "N\u00b3", 0}};
  for (const char* direction : kDirectionNames) columns.push_back({direction, "N", 1});
  return section(
      "thumbs", "The thumb: orthogonal and skewed axes",
      "Every force that the pinned thumbtip can make with tendon tensions between zero and their "
      "largest, every joint torque balanced. The first two thumbs bend 30 degrees at MCP and IP "
      "and "
      "have the same seven tendons, constant moment arms [Nakajima2022] and largest forces "
      "[McFarland2023]; their axes differ: four that cross or run parallel, and five that do "
      "neither [GraspIt]. The arms are borrowed from yet another thumb, so compare shapes, not "
      "newtons. The third has measured axes and straight tendon runs [Mirakhorlo2016], in the "
      "posture in which it was digitised.\n\nThe more axes must be balanced at once by the same "
      "tendons, the smaller the set: a fifth axis costs force. The scenes turn together.",
      Json::array(
          {row_block(scenes),
           table_block("Feasible thumbtip forces: the set, and the largest pure force along "
                       "the thumb's own directions; 0 where no tensions make a pure "
                       "force that way with every joint in balance",
                       columns, rows)}));
}

}  // namespace thenar
