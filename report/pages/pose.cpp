#include "report/pages/digit_page.h"

#include "base/units.h"
#include "report/answers/pose.h"
#include "report/picture/digit_layers.h"
#include "report/provenance.h"

namespace thenar {
namespace {

Json bones_of(const SubjectPose& pose) {
  Json items = Json::array();
  for (const SegmentPose& segment : pose.segments)
    add_segment(segment.proximal, segment.distal, items);
  return items;
}

/// Lines from each link to the link that carries it, and to its tip.
Json bones_of(const RobotPose& pose) {
  Json items = Json::array();
  for (const RobotLinkPose& link : pose.links)
    if (link.parent >= 0) add_segment(nth(pose.links, link.parent).X_BL.p, link.X_BL.p, items);
  for (const RobotTipPose& tip : pose.tips)
    for (const RobotLinkPose& link : pose.links)
      if (link.name == tip.link) add_segment(link.X_BL.p, tip.p, items);
  return items;
}

template <typename Pose>
Json axes_layer(const Pose& pose) {
  return layer("joint axes", "#0072b2", list_of_each(pose.joints, [](const auto& joint) {
                 return Json{{"kind", "axis"},
                             {"point", in_mm(joint.point)},
                             {"direction", numbers3(joint.axis)},
                             {"length", 15},
                             {"label", joint.name}};
               }));
}

template <typename Pose>
Json tip_layer(const Pose& pose) {
  return layer("tips", "#d55e00", list_of_each(pose.tips, [](const auto& tip) {
                 return Json{{"kind", "points"},
                             {"positions", Json::array({in_mm(tip.p)})},
                             {"radius", 2},
                             {"label", tip.digit}};
               }));
}

/// Bones or links at some of the postures, with the axes and tips of the first.
template <typename Poses>
Json pose_scene(const Poses& poses, const std::string& caption) {
  const SweepAxes axes = axes_of(poses);
  Json layers = Json::array();
  std::size_t tint = 0;
  for (const std::size_t i : drawn_rows(poses.points.size(), kDrawnPostures))
    layers.push_back(layer(axes.single() ? "bones" : title_of(axes, i), kPostureTints[tint++],
                           bones_of(poses.points[i])));
  layers.push_back(axes_layer(poses.points.front()));
  layers.push_back(tip_layer(poses.points.front()));
  return {{"type", "scene"}, {"caption", caption}, {"layers", layers}};
}

/// The place of each tip over what varies.
template <typename Poses>
Json place_charts(const Poses& poses) {
  const SweepAxes axes = axes_of(poses);
  // One chart for each tip or link, with its three coordinates.
  Json charts = Json::array();
  const auto first = places_of(poses.points.front());
  const char* const names[] = {"x", "y", "z"};
  for (std::size_t t = 0; t < first.size(); ++t) {
    std::vector<Curve> curves;
    for (int k = 0; k < 3; ++k) {
      Curve curve{names[k], Eigen::VectorXd(static_cast<Eigen::Index>(poses.points.size()))};
      for (std::size_t i = 0; i < poses.points.size(); ++i)
        curve.y(static_cast<Eigen::Index>(i)) = places_of(poses.points[i])[t].p(k) / kMm;
      curves.push_back(std::move(curve));
    }
    charts.push_back(curve_chart(axes, "Place of " + first[t].name, "place [mm]", curves));
  }
  return paired(charts);
}

template <typename Poses>
Json pose_sections(const Poses& poses, const std::string& text, const std::string& caption) {
  std::string words = text;
  for (const std::string& warning : poses.outcome.warnings)
    words += "\n\nWarning: " + warning + ".";
  Json sections = Json::array({section(
      "pose", "Pose", words,
      Json::array({pose_scene(poses, caption), table_block("Every posture.", table_of(poses))}))});
  if (!axes_of(poses).single())
    sections.push_back(section("curves", "Over the posture", "", place_charts(poses)));
  return sections;
}

/// The coordinate axis nearest to the backs of the straight fingers, of the thumb where there are
/// none, and words for the axes.
void orient(const SubjectPoses& poses, Json& scene) {
  const SourceText& source = poses.sources.front();
  const Skeleton hand = build_skeleton(parse_subject(source.text, source.path));
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const SkeletonTip& tip : hand.tips) sum += tip.digit == "thumb" ? 1e-3 * tip.axes : tip.axes;
  Eigen::Matrix3d directions = sum.colwise().normalized();
  scene["up"] = numbers3(nearest_axis(directions.col(1)));
  scene["axes"] = axis_words(directions);
}

}  // namespace

Json page_of(const SubjectPoses& poses) {
  Json provenance = provenance_json(poses.sources, {});
  provenance.erase("fidelity");
  Json sections = pose_sections(poses, "World frame of the subject, millimetres.",
                                "Bones, and the joint axes and tips of the first posture.");
  orient(poses, sections[0]["blocks"][0]);
  return {{"title", "thenar: pose of " + poses.subject},
          {"provenance", provenance},
          {"sections", std::move(sections)}};
}

Json page_of(const RobotPoses& poses) {
  Json provenance = provenance_json({}, {});
  provenance.erase("fidelity");
  return {{"title", "thenar: pose of " + poses.robot},
          {"provenance", provenance},
          {"sections",
           pose_sections(poses, "Frame of the base link, millimetres.",
                         "Lines from link to link, and the joint axes and tips of the first "
                         "posture; the links' shapes are not drawn.")}};
}

}  // namespace thenar
