#include "report/answers/pose.h"

#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "base/words.h"
#include "report/answers/digit_words.h"

namespace thenar {
namespace {

std::string direction(const Eigen::Vector3d& d) {
  // A direction has no sense here: the largest component is shown positive.
  Eigen::Index largest = 0;
  d.cwiseAbs().maxCoeff(&largest);
  const Eigen::Vector3d shown = (d[largest] < 0 ? Eigen::Vector3d(-d) : d).array() + 0.0;
  const auto round = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", round(shown.x()), round(shown.y()),
                     round(shown.z()));
}

std::string joint_text(const SubjectPose& pose) {
  Table table{{"joint", "angle_deg", "axis_x", "axis_y", "axis_z", "point_x_mm", "point_y_mm",
               "point_z_mm"}};
  for (const JointPose& joint : pose.joints) {
    const std::string name =
        joint.led_by.empty() ? joint.name : fmt::format("{} (led by {})", joint.name, joint.led_by);
    table.add_parts({{name, shown(joint.angle / kDegree, 2)},
                     cells(joint.axis, 4),
                     cells(joint.point / kMm, 2)});
  }
  return titled("Joints, axes in world directions", table);
}

std::string segment_text(const SubjectPose& pose) {
  Table table{{"segment", "turned_deg", "proximal_x_mm", "proximal_y_mm", "proximal_z_mm",
               "distal_x_mm", "distal_y_mm", "distal_z_mm"}};
  for (const SegmentPose& segment : pose.segments)
    table.add_parts({{segment.name, shown(Eigen::AngleAxisd(segment.X.R).angle() / kDegree, 2)},
                     cells(segment.proximal / kMm, 2),
                     cells(segment.distal / kMm, 2)});
  return titled("Segments, turned from the reference posture", table);
}

std::string jacobian_text(const TipPose& tip) {
  Table table{{"joint", "x_mm_per_rad", "y_mm_per_rad", "z_mm_per_rad"}};
  for (std::size_t j = 0; j < tip.joints.size(); ++j)
    table.add_parts({{tip.joints[j]}, cells(tip.J.col(static_cast<Eigen::Index>(j)) / kMm, 2)});
  return titled(fmt::format("How the {} tip moves: {}", tip.digit, mobility_in_words(tip)), table);
}

Fields tip_fields(const TipPose& tip) {
  Fields fields{{"digit", tip.digit},
                {"position", units::kMillimetre, tip.p},
                {"proximal", units::kOne, tip.axes.col(0)},
                {"dorsal", units::kOne, tip.axes.col(1)},
                {"radial", units::kOne, tip.axes.col(2)},
                {"joints", tip.joints},
                {"jacobian", units::kMillimetrePerRadian, tip.J},
                {"mobility", mobility_in_words(tip)}};
  if (tip.joints.empty()) return fields;
  fields.add("condition", tip.mobility.condition);
  fields.add("rank", tip.mobility.rank);
  return fields;
}

Fields pose_fields(const SubjectPose& pose) {
  const auto segment_fields = [](const SegmentPose& segment) {
    return Fields{{"name", segment.name},
                  {"rotation", units::kOne, segment.X.R},
                  {"translation", units::kMillimetre, segment.X.p},
                  {"proximal", units::kMillimetre, segment.proximal},
                  {"distal", units::kMillimetre, segment.distal}};
  };
  const auto joint_fields = [](const JointPose& joint) {
    return Fields{{"name", joint.name},
                  {"angle", units::kDegree, joint.angle},
                  {"axis", units::kOne, joint.axis},
                  {"point", units::kMillimetre, joint.point},
                  {"led_by", joint.led_by}};
  };
  return {{"tips", fields_of_each(pose.tips, tip_fields)},
          {"segments", fields_of_each(pose.segments, segment_fields)},
          {"joints", fields_of_each(pose.joints, joint_fields)}};
}

std::string subject_text(const SubjectPose& pose) {
  std::string text = joint_text(pose) + segment_text(pose);
  Table tips{{"digit", "tip_x_mm", "tip_y_mm", "tip_z_mm"}};
  for (const TipPose& tip : pose.tips) tips.add_parts({{tip.digit}, cells(tip.p / kMm, 2)});
  text += titled("Tips", tips);
  for (const TipPose& tip : pose.tips) text += jacobian_text(tip);
  return text;
}

/// [rad] or [m] in what people read.
double display_unit(bool sliding) { return sliding ? kMm : kDegree; }

std::string value_text(const RobotJointPose& joint) {
  return fmt::format("{} {}", shown(joint.value / display_unit(joint.slides), 2),
                     joint.slides ? "mm" : "deg");
}

std::string robot_text(const RobotPose& pose) {
  // Joints with their axes in the base frame; lengths in mm.
  Table joints{
      {"joint", "value", "axis_x", "axis_y", "axis_z", "point_x_mm", "point_y_mm", "point_z_mm"}};
  for (const RobotJointPose& joint : pose.joints) {
    const std::string name = joint.dof.empty() || joint.dof == joint.name
                                 ? joint.name
                                 : fmt::format("{} (driven by {})", joint.name, joint.dof);
    joints.add_parts(
        {{name, value_text(joint)}, cells(joint.axis, 4), cells(joint.point / kMm, 2)});
  }
  std::string text = titled("Joints, axes in directions of the base link", joints);
  Table links{{"link", "x_mm", "y_mm", "z_mm", "qw", "qx", "qy", "qz"}};
  for (const RobotLinkPose& link : pose.links) {
    const Eigen::Quaterniond q(link.X_BL.R);
    links.add_parts({{link.name},
                     cells(link.X_BL.p / kMm, 2),
                     {shown(q.w(), 5)},
                     cells(Eigen::Vector3d(q.vec()), 5)});
  }
  text += titled("Links, frames in the base link", links);
  Table tips{{"digit", "link", "tip_x_mm", "tip_y_mm", "tip_z_mm"}};
  for (const RobotTipPose& tip : pose.tips)
    tips.add_parts({{tip.digit, tip.link}, cells(tip.p / kMm, 2)});
  return text + titled("Tips", tips);
}

Fields pose_fields(const RobotPose& pose) {
  std::vector<Fields> tips, links, joints;
  for (const RobotTipPose& tip : pose.tips)
    tips.push_back(
        {{"digit", tip.digit}, {"link", tip.link}, {"position", units::kMillimetre, tip.p}});
  for (const RobotLinkPose& link : pose.links)
    links.push_back({{"name", link.name},
                     {"rotation", units::kOne, link.X_BL.R},
                     {"position", units::kMillimetre, link.X_BL.p}});
  for (const RobotJointPose& joint : pose.joints)
    joints.push_back({{"name", joint.name},
                      {"dof", joint.dof},
                      {"value", joint.slides ? units::kMillimetre : units::kDegree, joint.value},
                      {"axis", units::kOne, joint.axis},
                      {"point", units::kMillimetre, joint.point}});
  return {{"tips", std::move(tips)}, {"links", std::move(links)}, {"joints", std::move(joints)}};
}

/// "index_x_mm", "index_y_mm", "index_z_mm" of every place.
std::vector<std::string> place_header(const std::vector<NamedPlace>& places) {
  std::vector<std::string> header;
  for (const NamedPlace& place : places)
    for (const char* axis : {"_x_mm", "_y_mm", "_z_mm"}) header.push_back(place.name + axis);
  return header;
}

std::vector<std::string> place_cells(const std::vector<NamedPlace>& places, int decimals) {
  std::vector<std::string> line;
  for (const NamedPlace& place : places)
    line = row({line, cells(Eigen::Vector3d(place.p / kMm), decimals)});
  return line;
}

/// A row of places for each posture, under what varies.
template <typename Poses>
std::string place_text(const Poses& poses, const std::string& whose) {
  const SweepAxes axes = axes_of(poses);
  Table table{row({header_of(axes), place_header(places_of(poses.points.front()))})};
  for (std::size_t i = 0; i < poses.points.size(); ++i)
    table.add_parts({cells_of(axes, i), place_cells(places_of(poses.points[i]), 2)});
  return titled(fmt::format("{}, {}", whose, counted(poses.points.size(), "posture")), table);
}

/// Adds the fields of one posture, or a list "postures".
template <typename Poses>
void add_poses(const Poses& poses, Fields& fields) {
  const SweepAxes axes = axes_of(poses);
  if (axes.single()) {
    fields.append(pose_fields(poses.points.front()));
    return;
  }
  fields.add("varied", axes.names);
  fields.add("postures",
             fields_of_each(poses.points, [](const auto& pose) { return pose_fields(pose); }));
  if (poses.outcome.stopped()) fields.add("stopped_before", poses.outcome.asked);
}

}  // namespace

std::string mobility_in_words(const TipPose& tip) {
  constexpr double kNearlySingular = 100;  // smallest condition number of a nearly singular tip [1]
  // State rank and condition of the Jacobian.
  if (tip.joints.empty()) return "fixed: every joint between wrist and tip is frozen";
  const TipManipulability& can = tip.mobility;
  if (can.rank == 3 && can.condition < kNearlySingular)
    return fmt::format("regular: condition {:.3g}; moves least along {}", can.condition,
                       direction(can.directions.col(2)));
  if (can.rank == 3)
    return fmt::format("nearly singular: condition {:.3g}; hardly moves along {}", can.condition,
                       direction(can.directions.col(2)));
  if (can.possible == 2 && can.rank == 2)
    return fmt::format(
        "{} in the plane of flexion: condition {:.3g}; {} along {}; all axes are parallel, so it "
        "cannot move along {}, across the plane, and carries any force there without tendons",
        can.condition < kNearlySingular ? "regular" : "nearly singular", can.condition,
        can.condition < kNearlySingular ? "moves least" : "hardly moves",
        direction(can.directions.col(1)), direction(can.directions.col(2)));
  std::string blocked;
  for (int k = can.rank; k < 3; ++k)
    blocked += (blocked.empty() ? "" : " nor ") + direction(can.directions.col(k));
  return fmt::format("singular: cannot move along {}, and carries any force there without tendons",
                     blocked);
}

SweepAxes axes_of(const SubjectPoses& poses) {
  return axes_of(poses.grid, poses.coordinates, poses.points.size());
}

SweepAxes axes_of(const RobotPoses& poses) {
  SweepAxes axes;
  axes.row_length = poses.row;
  axes.values.resize(static_cast<Eigen::Index>(poses.points.size()),
                     static_cast<Eigen::Index>(poses.varied.size()));
  for (std::size_t k = 0; k < poses.varied.size(); ++k) {
    const bool slides = poses.varied[k].slides;
    axes.names.push_back(poses.varied[k].name);
    axes.units.emplace_back(slides ? "mm" : "deg");
    for (std::size_t i = 0; i < poses.points.size(); ++i)
      axes.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          poses.points[i].varied[k] / display_unit(slides);
  }
  return axes;
}

std::vector<NamedPlace> places_of(const SubjectPose& pose) {
  return transformed(pose.tips, [](const TipPose& tip) { return NamedPlace{tip.digit, tip.p}; });
}

std::vector<NamedPlace> places_of(const RobotPose& pose) {
  std::vector<NamedPlace> places;
  for (const RobotTipPose& tip : pose.tips) places.push_back({tip.digit, tip.p});
  if (!places.empty()) return places;
  for (const RobotLinkPose& link : pose.links) places.push_back({link.name, link.X_BL.p});
  return places;
}

std::string text_of(const SubjectPoses& poses) {
  if (poses.grid.varied.empty()) return subject_text(poses.points.front());
  return place_text(poses, "Tips of " + poses.subject);
}

Fields fields_of(const SubjectPoses& poses) {
  Fields fields{{"subject", poses.subject}};
  add_poses(poses, fields);
  return fields;
}

Table table_of(const SubjectPoses& poses) {
  const SubjectPose& first = poses.points.front();
  Table table{row({with_ending(poses.coordinates, "_deg"), place_header(places_of(first)),
                   with_ending(transformed(first.tips, &TipPose::digit), "_condition")})};
  for (const SubjectPose& pose : poses.points) {
    std::vector<std::string> line = row({joint_cells(pose.q), place_cells(places_of(pose), 6)});
    for (const TipPose& tip : pose.tips)
      line.push_back(tip.joints.empty() ? "" : shown(tip.mobility.condition));
    table.add(std::move(line));
  }
  return table;
}

std::string text_of(const RobotPoses& poses) {
  if (poses.varied.empty()) return robot_text(poses.points.front());
  return place_text(poses, (poses.points.front().tips.empty() ? "Links of " : "Tips of ") +
                               poses.robot + ", in the base link");
}

Fields fields_of(const RobotPoses& poses) {
  Fields fields{{"robot", poses.robot}};
  add_poses(poses, fields);
  fields.add("warnings", poses.outcome.warnings);
  return fields;
}

Table table_of(const RobotPoses& poses) {
  Table table;
  for (const RobotJointPose& joint : poses.points.front().joints)
    table.header.push_back(joint.name + (joint.slides ? "_mm" : "_deg"));
  table.header = row({table.header, place_header(places_of(poses.points.front()))});
  for (const RobotPose& pose : poses.points) {
    std::vector<std::string> line;
    for (const RobotJointPose& joint : pose.joints)
      line.push_back(shown(joint.value / display_unit(joint.slides)));
    table.add_parts({line, place_cells(places_of(pose), 6)});
  }
  return table;
}

}  // namespace thenar
