#include "report/answers/moment_arms.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"
#include "base/units.h"
#include "report/answers/digit_words.h"
#include "report/words.h"

namespace thenar {
namespace {

using Eigen::Index;

std::vector<std::string> arm_header(const DigitSweep& about) {
  std::vector<std::string> header;
  for (const std::string& joint : about.rows) header.push_back(joint + "_mm");
  return header;
}

/// Arms of a muscle [mm]; "-" at joints that it does not cross.
std::vector<std::string> arm_cells(const MomentArmAnswer& answer, const MomentArmPoint& point,
                                   Index muscle, int decimals) {
  std::vector<std::string> cells;
  for (Index j = 0; j < point.arms.cols(); ++j)
    cells.push_back(answer.crosses(muscle, j) ? shown(point.arms(muscle, j) / kMm, decimals) : "-");
  return cells;
}

void add_point(const MomentArmAnswer& answer, const MomentArmPoint& point, OrderedJson& json) {
  if (!point.failure.empty()) {
    json["failure"] = point.failure;
    return;
  }
  const DigitSweep& about = answer.about;
  OrderedJson arms = OrderedJson::object();
  for (std::size_t m = 0; m < about.muscles.size(); ++m) {
    OrderedJson& of = arms[about.muscles[m]] = OrderedJson::object();
    for (std::size_t j = 0; j < about.rows.size(); ++j)
      if (answer.crosses(static_cast<Index>(m), static_cast<Index>(j)))
        of[about.rows[j]] = point.arms(static_cast<Index>(m), static_cast<Index>(j)) / kMm;
  }
  json["arms_mm"] = arms;
  json["length_change_mm"] = to_json(about.muscles, point.length_change / kMm);
}

/// Arms of all muscles at one posture.
Table arm_table(const MomentArmAnswer& answer, const MomentArmPoint& point) {
  const DigitSweep& about = answer.about;
  Table table{row({{"muscle"}, arm_header(about), {"length_change_mm"}}), {}};
  for (std::size_t m = 0; m < about.muscles.size(); ++m)
    table.rows.push_back(row({{about.muscles[m]},
                              arm_cells(answer, point, static_cast<Index>(m), 3),
                              {shown(point.length_change(static_cast<Index>(m)) / kMm, 3)}}));
  return table;
}

/// A muscle over the postures.
Table muscle_table(const MomentArmAnswer& answer, std::size_t m) {
  const SweepAxes axes = axes_of(answer.about);
  Table table{row({header_of(axes), arm_header(answer.about), {"length_change_mm"}}), {}};
  for (std::size_t i = 0; i < answer.points.size(); ++i) {
    const MomentArmPoint& point = answer.points[i];
    if (!point.failure.empty()) {
      table.rows.push_back(
          row({cells_of(axes, i), std::vector<std::string>(answer.about.rows.size() + 1, "-")}));
      continue;
    }
    table.rows.push_back(row({cells_of(axes, i),
                              arm_cells(answer, point, static_cast<Index>(m), 3),
                              {shown(point.length_change(static_cast<Index>(m)) / kMm, 3)}}));
  }
  return table;
}

}  // namespace

std::string sign_words(const std::vector<std::string>& joints) {
  std::string text;
  for (const char* sense : {"flexion", "abduction", "pronation"}) {
    std::vector<std::string> named;
    for (const std::string& joint : joints)
      if (positive_motion(joint) == sense) named.push_back(joint);
    if (!named.empty())
      text += fmt::format("{}{} positive at {}", text.empty() ? "" : "; ", sense, listed(named));
  }
  return text;
}

std::string reference_words(const MomentArmAnswer& answer) {
  if (answer.reference.isZero(0)) return "with all joints at 0";
  return "at " + angles_in_words(answer.about.rows, answer.reference);
}

std::string text_of(const MomentArmAnswer& answer) {
  const DigitSweep& about = answer.about;
  std::string text = text_header(about) + "\n" +
                     fmt::format(
                         "Moment arms [mm], {}; - where a muscle has no arm.\nLength change "
                         "[mm] since {}; longer is positive.\n\n",
                         sign_words(about.rows), reference_words(answer));
  if (about.single()) return text + aligned(arm_table(answer, answer.points.front()));
  for (std::size_t m = 0; m < about.muscles.size(); ++m)
    text += titled(about.muscles[m], muscle_table(answer, m));
  return text;
}

OrderedJson json_of(const MomentArmAnswer& answer) {
  return digit_json(answer.about, [&](std::size_t i, OrderedJson& json) {
    add_point(answer, answer.points[i], json);
  });
}

Table table_of(const MomentArmAnswer& answer) {
  const DigitSweep& about = answer.about;
  std::vector<std::string> arms;
  for (const std::string& joint : about.rows) arms.push_back("arm_" + joint + "_mm");
  Table table{row({joint_header(about), {"muscle"}, arms, {"length_change_mm"}}), {}};
  for (const MomentArmPoint& point : answer.points)
    for (std::size_t m = 0; m < about.muscles.size() && point.failure.empty(); ++m)
      table.rows.push_back(
          row({joint_cells(point.q),
               {about.muscles[m]},
               cells(Eigen::VectorXd(point.arms.row(static_cast<Index>(m)).transpose() / kMm), 6),
               {shown(point.length_change(static_cast<Index>(m)) / kMm, 6)}}));
  return table;
}

}  // namespace thenar
