#include "report/answers/moment_arms.h"

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "base/units.h"
#include "report/answers/digit_words.h"
#include "report/words.h"

namespace thenar {
namespace {

using Eigen::Index;

/// Arms of a muscle [mm], "-" at joints that it does not cross, and its change of length [mm].
std::vector<std::string> arm_cells(const MomentArmResult& answer, const MomentArmPoint& point,
                                   Index muscle) {
  std::vector<std::string> cells;
  for (Index j = 0; j < point.arms.cols(); ++j)
    cells.push_back(answer.crosses(muscle, j) ? shown(point.arms(muscle, j) / kMm, 3) : "-");
  cells.push_back(shown(point.length_change(muscle) / kMm, 3));
  return cells;
}

void add_point(const MomentArmResult& answer, const MomentArmPoint& point, Fields& fields) {
  if (!point.message.empty()) {
    fields.add("failure", point.message);
    return;
  }
  OrderedJson arms = OrderedJson::object();
  for (std::size_t m = 0; m < answer.muscles.size(); ++m) {
    OrderedJson& of = arms[answer.muscles[m]] = OrderedJson::object();
    for (std::size_t j = 0; j < answer.rows.size(); ++j)
      if (answer.crosses(static_cast<Index>(m), static_cast<Index>(j)))
        of[answer.rows[j]] = point.arms(static_cast<Index>(m), static_cast<Index>(j));
  }
  fields.add("arms", units::kMillimetre, std::move(arms));
  fields.add("length_change", units::kMillimetre, answer.muscles, point.length_change);
}

/// Arms of all muscles at one posture.
Table arm_table(const MomentArmResult& answer, const MomentArmPoint& point) {
  Table table{row({{"muscle"}, with_ending(answer.rows, "_mm"), {"length_change_mm"}})};
  for (std::size_t m = 0; m < answer.muscles.size(); ++m)
    table.add_parts({{answer.muscles[m]}, arm_cells(answer, point, static_cast<Index>(m))});
  return table;
}

/// A muscle over the postures.
Table muscle_table(const MomentArmResult& answer, Index muscle) {
  return posture_table(
      answer, row({with_ending(answer.rows, "_mm"), {"length_change_mm"}}),
      [&](const MomentArmPoint& point) { return arm_cells(answer, point, muscle); });
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

std::string reference_words(const MomentArmResult& answer) {
  if (answer.reference.isZero(0)) return "with all joints at 0";
  return "at " + angles_in_words(answer.rows, answer.reference);
}

std::string text_of(const MomentArmResult& answer) {
  std::string text = text_header(answer) + "\n" +
                     fmt::format(
                         "Moment arms [mm], {}; - where a muscle has no arm.\nLength change [mm] "
                         "from the posture {}; lengthening is positive.\n\n",
                         sign_words(answer.rows), reference_words(answer));
  if (answer.single()) return text + aligned(arm_table(answer, answer.points.front()));
  for (std::size_t m = 0; m < answer.muscles.size(); ++m)
    text += titled(answer.muscles[m], muscle_table(answer, static_cast<Index>(m)));
  return text;
}

Fields fields_of(const MomentArmResult& answer) {
  return digit_fields(
      answer, [&](std::size_t i, Fields& fields) { add_point(answer, answer.points[i], fields); });
}

Table table_of(const MomentArmResult& answer) {
  const auto arm = [](const std::string& joint) { return "arm_" + joint + "_mm"; };
  Table table{
      row({joint_header(answer), {"muscle"}, transformed(answer.rows, arm), {"length_change_mm"}})};
  for (const MomentArmPoint& point : answer.points)
    for (std::size_t m = 0; m < answer.muscles.size() && point.message.empty(); ++m)
      table.add_parts(
          {joint_cells(point.q),
           {answer.muscles[m]},
           cells(Eigen::VectorXd(point.arms.row(static_cast<Index>(m)).transpose() / kMm), 6),
           {shown(point.length_change(static_cast<Index>(m)) / kMm, 6)}});
  return table;
}

}  // namespace thenar
