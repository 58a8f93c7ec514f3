// Text and JSON of a PoseReport.

#include <fmt/format.h>

#include "api/posture.h"
#include "apps/pose_report.h"
#include "base/units.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {
namespace {

void print_joints(const PoseReport& report) {
  Table table{{"joint", "angle_deg", "axis_x", "axis_y", "axis_z", "point_x_mm", "point_y_mm",
               "point_z_mm"},
              {}};
  for (const JointNow& joint : report.joints) {
    const std::string name =
        joint.led_by.empty() ? joint.name : fmt::format("{} (led by {})", joint.name, joint.led_by);
    table.rows.push_back(row({{name, shown(joint.angle / kDegree, 2)},
                              cells(joint.axis, 4),
                              cells(joint.point / kMm, 2)}));
  }
  fmt::print("{}", titled("Joints, axes in world directions", table));
}

void print_segments(const PoseReport& report) {
  Table table{{"segment", "turned_deg", "proximal_x_mm", "proximal_y_mm", "proximal_z_mm",
               "distal_x_mm", "distal_y_mm", "distal_z_mm"},
              {}};
  for (const SegmentNow& segment : report.segments)
    table.rows.push_back(
        row({{segment.name, shown(Eigen::AngleAxisd(segment.X.R).angle() / kDegree, 2)},
             cells(segment.proximal / kMm, 2),
             cells(segment.distal / kMm, 2)}));
  fmt::print("{}", titled("Segments, turned from the reference posture", table));
}

void print_jacobian(const TipNow& tip) {
  Table table{{"joint", "x_mm_per_rad", "y_mm_per_rad", "z_mm_per_rad"}, {}};
  for (std::size_t j = 0; j < tip.joints.size(); ++j)
    table.rows.push_back(
        row({{tip.joints[j]}, cells(tip.J.col(static_cast<Eigen::Index>(j)) / kMm, 2)}));
  fmt::print(
      "{}",
      titled(fmt::format("How the {} tip moves: {}", tip.digit, mobility_in_words(tip)), table));
}

nlohmann::ordered_json json_of(const TipNow& tip) {
  nlohmann::ordered_json json{{"digit", tip.digit},
                              {"position_mm", to_json(tip.p / kMm)},
                              {"proximal", to_json(tip.axes.col(0))},
                              {"dorsal", to_json(tip.axes.col(1))},
                              {"radial", to_json(tip.axes.col(2))},
                              {"joints", tip.joints},
                              {"jacobian_mm_per_rad", to_json(tip.J / kMm)},
                              {"mobility", mobility_in_words(tip)}};
  if (tip.joints.empty()) return json;
  json["condition"] = tip.mobility.condition;
  json["rank"] = tip.mobility.rank;
  return json;
}

}  // namespace

void print_text(const PoseReport& report) {
  print_joints(report);
  print_segments(report);
  Table tips{{"digit", "tip_x_mm", "tip_y_mm", "tip_z_mm"}, {}};
  for (const TipNow& tip : report.tips)
    tips.rows.push_back(row({{tip.digit}, cells(tip.p / kMm, 2)}));
  fmt::print("{}", titled("Tips", tips));
  for (const TipNow& tip : report.tips) print_jacobian(tip);
}

void print_json(const PoseReport& report) {
  nlohmann::ordered_json json{{"subject", report.subject}};
  json["joints"] = json["segments"] = json["tips"] = nlohmann::ordered_json::array();
  for (const JointNow& joint : report.joints)
    json["joints"].push_back({{"name", joint.name},
                              {"angle_deg", joint.angle / kDegree},
                              {"axis", to_json(joint.axis)},
                              {"point_mm", to_json(joint.point / kMm)},
                              {"led_by", joint.led_by}});
  for (const SegmentNow& segment : report.segments)
    json["segments"].push_back({{"name", segment.name},
                                {"rotation", to_json(segment.X.R)},
                                {"translation_mm", to_json(segment.X.p / kMm)},
                                {"proximal_mm", to_json(segment.proximal / kMm)},
                                {"distal_mm", to_json(segment.distal / kMm)}});
  for (const TipNow& tip : report.tips) json["tips"].push_back(json_of(tip));
  fmt::print("{}\n", json_text(json));
}

}  // namespace thenar
