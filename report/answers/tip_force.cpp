#include "report/answers/tip_force.h"

#include <fmt/format.h>

#include "base/units.h"
#include "report/answers/digit_words.h"
#include "report/answers/passive_words.h"

namespace thenar {
namespace {

std::string hold_name(TipConstraint hold) { return name_in(kTipConstraintNames, hold); }

void add_point(const TipForceResult& answer, const TipForcePoint& point, Fields& fields) {
  if (!point.message.empty()) {
    fields.add("failure", point.message);
    return;
  }
  fields.add("hold", hold_name(answer.request.hold));
  fields.add("tension", units::kNewton, answer.muscles, answer.tension);
  fields.add("force", units::kNewton, point.force);
  if (point.tip_axes)
    fields.add("force_tip_axes", units::kNewton,
               std::vector<std::string>{"proximal", "dorsal", "radial"}, force_along_tip(point));
  fields.add("magnitude", units::kNewton, point.force.norm());
  if (answer.request.hold == TipConstraint::kRigid)
    fields.add("moment", units::kNewtonMillimetre, point.moment);
  if (answer.map.empty()) {
    fields.add("leftover_torque", units::kNewtonMillimetre, answer.rows, point.residual);
    fields.add("condition", point.condition);
    fields.add("force_change", units::kNewtonPerDegree, answer.rows, point.change);
  } else {
    const std::vector<std::string> moments(answer.rows.begin() + 3, answer.rows.end());
    fields.add("tip_moment", units::kNewtonMillimetre, moments,
               point.residual.tail(point.residual.size() - 3));
  }
  const std::string note = note_of(answer, point);
  if (!note.empty()) fields.add("note", note);
}

/// Force, moment and what is left over, of one posture or a map.
std::string one_posture(const TipForceResult& answer, const TipForcePoint& point) {
  const bool bones = answer.map.empty();
  Table force{{"axes", "1_N", "2_N", "3_N", "magnitude_N"}};
  const auto add = [&](const std::string& axes, const Eigen::Vector3d& f) {
    force.add_parts({{axes}, cells(f, 4), {shown(f.norm(), 4)}});
  };
  add(bones ? "world x y z" : "map x y z", point.force);
  if (point.tip_axes) add("proximal dorsal radial", force_along_tip(point));
  std::string text = titled(
      bones ? fmt::format("Force of the tip on the world, hold {}", hold_name(answer.request.hold))
            : "Force of the tip on the world",
      force);
  if (answer.request.hold == TipConstraint::kRigid)
    text += titled("Moment of the tip on the world, about the tip, world axes",
                   {{"x_N_mm", "y_N_mm", "z_N_mm"}, {cells(point.moment / kNewtonMillimetre, 3)}});
  // A map's first rows are forces, balanced exactly; the rest are moments the tip must pass on.
  Table left{{bones ? "joint" : "moment", "N_mm"}};
  for (std::size_t i = bones ? 0 : 3; i < answer.rows.size(); ++i)
    left.add({answer.rows[i],
              shown(point.residual[static_cast<Eigen::Index>(i)] / kNewtonMillimetre, 4)});
  text += titled(bones ? "Residual joint torque, which no tip load can balance"
                       : "Moment at the tip, that the hold must carry",
                 left);
  if (bones)
    text += fmt::format("condition: {:.4g}\nmagnitude of the change in the force {}\n",
                        point.condition, change_line(answer.rows, point.change));
  const std::string note = note_of(answer, point);
  return note.empty() ? text : text + "note: " + note + "\n";
}

/// A row for each posture: what varies, the force along the tip's axes, its size.
std::string many_postures(const TipForceResult& answer) {
  const Table table = posture_table(
      answer, {"proximal_N", "dorsal_N", "radial_N", "magnitude_N", "left_over_N_mm", "condition"},
      [](const TipForcePoint& point) {
        return row({cells(force_along_tip(point), 4),
                    {shown(point.force.norm(), 4),
                     shown(point.residual.cwiseAbs().maxCoeff() / kNewtonMillimetre, 4),
                     shown(point.condition)}});
      });
  return titled(fmt::format("Force of the tip on the world, hold {}, and the largest joint torque "
                            "that it leaves over",
                            hold_name(answer.request.hold)),
                table);
}

}  // namespace

Eigen::Vector3d force_along_tip(const TipForcePoint& point) {
  return point.tip_axes ? Eigen::Vector3d(point.tip_axes->transpose() * point.force) : point.force;
}

std::string note_of(const TipForceResult& answer, const TipForcePoint& point) {
  std::string note;
  if (point.singular)
    note =
        "singular posture: several tip forces minimise the unbalanced torque equally well; the "
        "smallest is shown";
  if (point.minimum_norm)
    note = fmt::format(
        "minimum norm: {} joints leave the wrench of a held tip open, and of those that balance "
        "this one has the least |force|^2 + |moment / {:.4g} mm|^2 (hold length)",
        point.q.size(), answer.request.hold_length / kMm);
  const auto add = [&](const std::string& more) {
    note += (note.empty() || more.empty() ? "" : "; ") + more;
  };
  if (point.planar)
    add(answer.request.hold == TipConstraint::kRigid
            ? "all axes are parallel: forces across the plane of flexion, and moments but the one "
              "about its normal, meet no joint and are given as 0"
            : "all axes are parallel: forces across the plane of flexion meet no joint and are "
              "given as 0");
  if (!answer.map.empty() || point.singular) return note;
  add(posture_note(answer.rows, point.condition, point.change));
  return note;
}

std::string text_of(const TipForceResult& answer) {
  return text_header(answer) + passive_line(answer) + "\n" +
         (answer.single() ? one_posture(answer, answer.points.front()) : many_postures(answer));
}

Fields fields_of(const TipForceResult& answer) {
  return digit_fields(answer, [&](std::size_t i, Fields& fields) {
    add_passive(answer, i, fields);
    add_point(answer, answer.points[i], fields);
  });
}

Table table_of(const TipForceResult& answer) {
  const bool bones = answer.map.empty(), rigid = answer.request.hold == TipConstraint::kRigid;
  Table table{joint_header(answer)};
  const auto add = [&](const std::vector<std::string>& names) {
    table.header.insert(table.header.end(), names.begin(), names.end());
  };
  add({"fx_N", "fy_N", "fz_N", "magnitude_N"});
  if (bones) add({"proximal_N", "dorsal_N", "radial_N"});
  if (rigid) add({"mx_N_mm", "my_N_mm", "mz_N_mm"});
  for (std::size_t i = bones ? 0 : 3; i < answer.rows.size(); ++i)
    add({(bones ? "left_over_" : "moment_") + answer.rows[i] + "_N_mm"});
  if (bones) add({"condition"});
  add({"note"});
  // A failed posture keeps its angles and the reason.
  for (const TipForcePoint& point : answer.points) {
    std::vector<std::string> line = joint_cells(point.q);
    if (!point.message.empty()) {
      line.resize(table.header.size() - 1);
      line.push_back(point.message);
      table.add(line);
      continue;
    }
    const Eigen::Index left = bones ? point.residual.size() : point.residual.size() - 3;
    table.add_parts(
        {line,
         cells(point.force, 6),
         {shown(point.force.norm(), 6)},
         bones ? cells(force_along_tip(point), 6) : std::vector<std::string>{},
         rigid ? cells(Eigen::Vector3d(point.moment / kNewtonMillimetre), 4)
               : std::vector<std::string>{},
         cells(Eigen::VectorXd(point.residual.tail(left) / kNewtonMillimetre), 4),
         bones ? std::vector<std::string>{shown(point.condition)} : std::vector<std::string>{},
         {note_of(answer, point)}});
  }
  return table;
}

}  // namespace thenar
