#include "report/answers/quality.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/answers/grasp_measures.h"

namespace thenar {
namespace {

/// Returns force and torque without minus zeros; of a planar grasp f_x, f_y and the torque.
OrderedJson loads_json(const Eigen::Vector3d& force, const Eigen::Vector3d& torque, bool planar) {
  if (planar) return {force.x() + 0.0, force.y() + 0.0, torque.z() + 0.0};
  Eigen::Matrix<double, 6, 1> both;
  both << force, torque;
  return to_json((both.array() + 0.0).matrix());
}

OrderedJson wrench_json(const ScaledWrench& w, bool planar) {
  return loads_json(w.force, w.moment_over_length, planar);
}

OrderedJson wrench_json(const Wrench& w, bool planar) {
  return loads_json(w.force, w.moment, planar);
}

Fields task_fields(const TaskQuality& task, bool planar) {
  OrderedJson forces = OrderedJson::array();
  for (const std::optional<double>& force : task.grasp_forces)
    forces.push_back(force ? OrderedJson(*force) : OrderedJson());
  return {
      {"margin", Fields{{"lower", units::kOne, task.lower}, {"upper", units::kOne, task.upper}}},
      {"squeeze", units::kNewton, task.lower ? std::optional(1 / *task.lower) : std::nullopt},
      {"squeezes", units::kNewton, forces},
      {"worst_load", wrench_json(task.worst_load, planar)},
      {"solved", task.lower.has_value()},
      {"residual", task.residual}};
}

std::string matrix_words(const GraspMatrixMeasures& m) {
  return fmt::format(
      "least singular value {:.4g}, isotropy {:.4g}, volume {:.4g}, {} internal force{}",
      m.min_singular_value, m.isotropy, m.volume, m.internal_forces,
      m.internal_forces == 1 ? "" : "s");
}

std::string task_words(const TaskQuality& task, bool planar) {
  const std::string load = json_text(wrench_json(task.worst_load, planar), -1);
  if (!task.lower) return fmt::format("not known: its program ended {}", name_of(task.status));
  if (task.upper == 0) return fmt::format("not withstood: nothing holds {}", load);
  if (std::isinf(*task.lower)) return "no load";
  return fmt::format("needs normal forces of {:.6g} N, most for {}", 1 / *task.lower, load);
}

std::string wrench_words(const ScaledWrench& w, bool planar) {
  if (planar)
    return fmt::format("force ({}), torque / scale {}",
                       fmt::join(cells(w.force.head<2>(), 4), ", "),
                       fmt::join(cells(w.moment_over_length.tail<1>(), 4), ", "));
  return fmt::format("force ({}), torque / scale ({})", fmt::join(cells(w.force, 4), ", "),
                     fmt::join(cells(w.moment_over_length, 4), ", "));
}

std::string enclosed(double lower, double upper) {
  return fmt::format("between {:.6g} and {:.6g}", lower, upper);
}

std::string volume_words(const Volume& v) {
  if (!v.complete) return fmt::format("at least {:.6g}: too many facets or faces", v.lower);
  if (v.lower == v.upper) return fmt::format("{:.6g}", v.estimate);
  return fmt::format("about {:.6g}, {}", v.estimate, enclosed(v.lower, v.upper));
}

/// "-" where there is none.
std::string cell(std::optional<double> value) {
  return value && std::isfinite(*value) ? fmt::format("{:.9g}", *value + 0.0) : "-";
}

std::optional<double> volume_estimate(const ContactQualityResult& result) {
  if (!result.volume || !result.volume->complete) return {};
  return result.volume->estimate;
}

std::vector<std::string> quality_row(const ContactQualityResult& result) {
  const Epsilon& e = result.epsilon;
  std::vector<std::string> row{
      result.contacts, std::to_string(result.count),  e.force_closure ? "yes" : "no", cell(e.lower),
      cell(e.upper),   cell(volume_estimate(result)), std::to_string(e.rank)};
  const auto& matrix = result.grasp_matrix;
  row.push_back(matrix ? cell(matrix->min_singular_value) : "-");
  row.push_back(matrix ? cell(matrix->isotropy) : "-");
  row.push_back(matrix ? std::to_string(matrix->internal_forces) : "-");
  const bool task = result.task && result.task->lower;
  row.push_back(task ? cell(1 / *result.task->lower) : "-");
  return row;
}

}  // namespace

std::string text_of(const ContactQualityResult& result) {
  const Epsilon& e = result.epsilon;
  std::string text = fmt::format("{}: {} contacts, torques divided by {} m\n", result.contacts,
                                 result.count, shown(result.torque_scale));
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<18}{}\n", name, value);
  };
  line("force closure", e.force_closure ? "yes" : "no");
  line("epsilon", enclosed(e.lower, e.upper) + (e.converged ? "" : " (gave up early)"));
  if (result.volume) line("volume", volume_words(*result.volume));
  line("rank", fmt::format("{} of {}", e.rank, result.planar ? 3 : 6));
  if (e.has_missing_direction)
    line("cannot make", wrench_words(e.missing_direction, result.planar));
  line(e.has_missing_direction ? "not withstood" : "weakest direction",
       wrench_words(e.worst_wrench, result.planar));
  if (result.grasp_matrix) line("grasp matrix", matrix_words(*result.grasp_matrix));
  if (result.task) line("task", task_words(*result.task, result.planar));
  for (const std::string& warning : result.outcome.warnings) line("warning", warning);
  return text;
}

Fields fields_of(const ContactQualityResult& result) {
  // Volume and missing directions exist in some cases only.
  const Epsilon& e = result.epsilon;
  OrderedJson missing, bounds, complete;
  if (e.has_missing_direction) missing = wrench_json(e.missing_direction, result.planar);
  if (result.volume) {
    bounds = {{"lower", result.volume->lower}, {"upper", result.volume->upper}};
    complete = result.volume->complete;
  }
  const auto& matrix = result.grasp_matrix;
  return {{"epsilon", Fields{{"lower", e.lower + 0.0}, {"upper", e.upper + 0.0}}},
          {"volume", units::kOne, volume_estimate(result)},
          {"force_closure", e.force_closure},
          {"rank", e.rank},
          {"missing_direction", missing},
          {"worst_wrench", wrench_json(e.worst_wrench, result.planar)},
          {"cpu", units::kCpuSecond, result.epsilon_cpu + result.volume_cpu},
          {"epsilon_cpu", units::kCpuSecond, result.epsilon_cpu},
          {"volume_bounds", bounds},
          {"volume_complete", complete},
          {"converged", e.converged},
          matrix ? Field("grasp_matrix", fields_of(*matrix)) : Field("grasp_matrix", nullptr),
          result.task ? Field("task", task_fields(*result.task, result.planar))
                      : Field("task", nullptr),
          {"planar", result.planar},
          {"file", result.contacts},
          {"warnings", result.outcome.warnings}};
}

Table table_of(const std::vector<ContactQualityResult>& results) {
  Table table{{"contacts", "count", "force_closure", "epsilon_lower", "epsilon_upper", "volume",
               "rank", "least_singular_value", "isotropy", "internal_forces", "squeeze_N"}};
  for (const ContactQualityResult& result : results) table.add(quality_row(result));
  return table;
}

Fields fields_of(const std::vector<ContactQualityResult>& results) {
  if (results.size() == 1) return fields_of(results.front());
  return {{"answers", fields_of_each(results, [](const ContactQualityResult& result) {
             return fields_of(result);
           })}};
}

}  // namespace thenar
