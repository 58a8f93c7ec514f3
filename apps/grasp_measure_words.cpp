#include <cmath>

#include <fmt/format.h>

#include "apps/grasp_measures.h"
#include "report/answers/grasp_words.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {
namespace {

template <typename Value, typename ToJson>
void put(OrderedJson& json, OrderedJson& reasons, const char* key, const Measured<Value>& measured,
         const ToJson& to) {
  json[key] = measured.value ? OrderedJson(to(*measured.value)) : OrderedJson(nullptr);
  if (!measured.reason.empty()) reasons[key] = measured.reason;
}

OrderedJson ball_json(const InscribedBall& ball) {
  return {{"lower", ball.lower},
          {"upper", ball.upper},
          {"residual", ball.residual},
          {"worst_load", to_json(ball.worst_load)},
          {"worst_load_words", direction_words(ball.worst_load)}};
}

OrderedJson stiffness_json(const GraspStiffness& stiffness) {
  return {{"least", stiffness.min_eigenvalue},
          {"softest", to_json(stiffness.softest)},
          {"softest_words", direction_words(stiffness.softest)},
          {"pad_force_N", kPadForce},
          {"matrix", to_json(stiffness.K)}};
}

template <typename Value, typename Words>
void add_row(std::vector<MeasureRow>& rows, const std::string& name,
             const Measured<Value>& measured, const Words& words) {
  rows.push_back({name, measured.value ? words(*measured.value) : "no value", measured.reason});
}

std::string short_volume_words(const Volume& v) {
  if (!v.complete) return fmt::format("at least {:.4g}", v.lower);
  return v.lower == v.upper
             ? fmt::format("{:.4g}", v.lower)
             : fmt::format("about {:.4g}, {:.4g} to {:.4g}", v.estimate, v.lower, v.upper);
}

}  // namespace

OrderedJson measures_json(const GraspMeasures& m) {
  const auto same = [](double value) { return value; };
  OrderedJson json, reasons = OrderedJson::object();
  json["volume"] = m.volume.complete ? OrderedJson(m.volume.estimate) : OrderedJson(nullptr);
  json["volume_bounds"] = {{"lower", m.volume.lower},
                           {"upper", std::isfinite(m.volume.upper) ? OrderedJson(m.volume.upper)
                                                                   : OrderedJson(nullptr)}};
  json["volume_complete"] = m.volume.complete;
  put(json, reasons, "actuated_epsilon_N", m.actuated, ball_json);
  put(json, reasons, "weight_N", m.weight, same);
  put(json, reasons, "hold_N", m.hold, same);
  put(json, reasons, "hold_actuated_N", m.hold_actuated, same);
  put(json, reasons, "times_weight", m.times_weight, same);
  put(json, reasons, "pull_N", m.pull, same);
  put(json, reasons, "turn_Nm", m.turn, same);
  put(json, reasons, "stiffness_N_per_m", m.stiffness, stiffness_json);
  put(json, reasons, "manipulability", m.manipulability, object_motion_json);
  if (!m.volume.complete) reasons["volume"] = "too many facets or faces";
  json["friction_edges"] = m.edges;
  json["true_cones"] = m.edges > 0 ? "all but epsilon, volume, robustness, wrench_set" : "all";
  json["reasons"] = reasons;
  return json;
}

std::vector<MeasureRow> measure_rows(const GraspMeasures& m) {
  const auto in = [](const char* unit) {
    return [unit](double value) { return fmt::format("{} {}", shown(value), unit); };
  };
  std::vector<MeasureRow> rows;
  rows.push_back({"volume of wrenches", short_volume_words(m.volume) + " unit forces^6", ""});
  add_row(rows, "epsilon of the driven hand", m.actuated, [](const InscribedBall& ball) {
    const std::string worst = direction_words(ball.worst_load);
    return ball.upper == 0
               ? fmt::format("0 N, nothing withstands {}", worst)
               : fmt::format("{:.4g} to {:.4g} N, least against {}", ball.lower, ball.upper, worst);
  });
  add_row(rows, "weight of the object", m.weight, in("N"));
  add_row(rows, "least squeeze that holds it", m.hold, in("N"));
  add_row(rows, "the same, as driven", m.hold_actuated, in("N"));
  add_row(rows, "holds its weight", m.times_weight, in("times, along each axis both ways"));
  add_row(rows, "withstands a pull along z", m.pull, in("N"));
  add_row(rows, "withstands a turn about z", m.turn, in("N m"));
  add_row(rows, "least stiffness of pads", m.stiffness, [](const GraspStiffness& stiffness) {
    return fmt::format("{:.4g} N/m, {}", stiffness.min_eigenvalue, motion_words(stiffness.softest));
  });
  add_row(rows, "moves the object", m.manipulability, object_motion_words);
  if (m.edges > 0)
    rows.push_back({"friction", fmt::format("pyramids of {} edges", m.edges),
                    "in epsilon, volume and robustness; all other measures have true cones"});
  return rows;
}

}  // namespace thenar
