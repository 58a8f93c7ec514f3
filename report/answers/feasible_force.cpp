#include "report/answers/feasible_force.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.h"
#include "report/answers/digit_words.h"
#include "report/answers/passive_words.h"
#include "report/words.h"
#include "tendons/forces/posture_sensitivity.h"

namespace thenar {
namespace {

using Eigen::Index;

constexpr double kNoPrice = 1e-9;       // rounding [N/N]
constexpr double kPriceDiffers = 1e-4;  // smallest difference over the larger price [1]
constexpr std::size_t kMaxNamed = 3;    // muscles in a sentence

TipModel model_of(const FeasibleForcePoint& point) {
  return point.q.size() == 0 ? TipModel::kMap : TipModel::kJoints;
}

std::string status_line(Status status, const FeasibleForcePoint& point) {
  const std::string words = force_status_words(status, point.load, model_of(point));
  return words.empty() ? "" : fmt::format("{}: {}\n", name_of(status), words);
}

/// Returns the status line of a posture, with the forces that the bones carry alone.
std::string status_line(const FeasibleForcePoint& point) {
  const Status status = point.largest->status;
  if (status != Status::kUnbounded || !point.plane_normal || point.load == TipLoad::kMoment)
    return status_line(status, point);
  return fmt::format(
      "{}: all axes are parallel, and the bones alone carry any force across the plane of "
      "flexion\n",
      name_of(status));
}

/// Returns true if certainly no tensions make a force in this direction.
bool makes_none(const FeasibleForcePoint& point) {
  const Status status = point.largest->status;
  return status == Status::kInfeasible || (status == Status::kSolved && !makes_force(point));
}

/// The status of a solver, or "no force" where it found that there is none.
std::string status_name(const FeasibleForcePoint& point) {
  return makes_none(point) ? "no " + words_of(point.load).one : name_of(point.largest->status);
}

bool priced(const FeasibleForcePoint& point) {
  return makes_force(point) && point.largest->prices.increase.size() > 0;
}

bool differs(const ForceLimitPrices& prices, Index i) {
  return !(prices.decrease(i) - prices.increase(i) <=
           kNoPrice + kPriceDiffers * std::abs(prices.decrease(i)));
}

/// "0.1206", "0 .. 0.2" where the price of an increase and of a decrease differ; "-" if unknown.
std::string price_cell(const FeasibleForcePoint& point, Index i) {
  if (!priced(point)) return "-";
  const ForceLimitPrices& prices = point.largest->prices;
  if (std::isnan(prices.increase(i)) || std::isnan(prices.decrease(i))) return "-";
  if (!differs(prices, i)) return shown(prices.increase(i), 4);
  return shown(prices.increase(i), 4) + " .. " + shown(prices.decrease(i), 4);
}

Table vertex_table(const ForceAxes& axes, const FeasibleForceSet& set, const LoadWords& words) {
  Table table{row({{"vertex"}, with_ending(axes.names, words.suffix)})};
  const Eigen::MatrixX3d vertices = set.vertices * axes.to_world;
  for (Index k = 0; k < vertices.rows(); ++k)
    table.add_parts({{std::to_string(k + 1)}, cells(vertices.row(k), 3 + words.more_decimals)});
  return table;
}

/// The loss, null if unknown.
Fields loss_fields(const ParalysisLoss& loss, TipLoad load) {
  const bool solved = loss.intact.status == Status::kSolved;
  return {{"intact_component", words_of(load).si, solved ? loss.intact.component : std::nan("")},
          {"loss", loss.share}};
}

/// "N_per_N_of_F0"
std::string price_header(TipLoad load) { return words_of(load).suffix.substr(1) + "_per_N_of_F0"; }

std::vector<Fields> limit_fields(const FeasibleForceResult& answer,
                                 const FeasibleForcePoint& point) {
  std::vector<Fields> list;
  const ForceLimitPrices& prices = point.largest->prices;
  const std::string price = price_header(answer.request.load);
  for (const Index i : limiting_muscles(point)) {
    Fields& limit =
        list.emplace_back(Fields{{"muscle", nth(answer.muscles, i)}, {price, prices.increase(i)}});
    if (differs(prices, i)) limit.add(price + "_lost", prices.decrease(i));
  }
  return list;
}

void add_largest(const FeasibleForceResult& answer, const FeasibleForcePoint& point,
                 Fields& fields) {
  // State status and axes even if there is no load.
  const MaxTipForce& largest = *point.largest;
  const LoadWords words = words_of(answer.request.load),
                  other = words_of(other_load(answer.request.load));
  fields.add("status", status_name(point));
  fields.add("axes", point.axes.name);
  if (makes_none(point)) {
    for (const char* const load : {words.one.c_str(), "component"})
      fields.add(load, words.si, nullptr);
    for (const char* const name : {"certificate", "activation"}) fields.add(name, nullptr);
    fields.add("tension", units::kNewton, nullptr);
    return;
  }
  // State loads in the requested axes.
  const auto in_axes = [&](const Eigen::Vector3d& load) {
    return Eigen::Vector3d(point.axes.to_world.transpose() * load);
  };
  fields.add(words.one, words.si, in_axes(largest.force));
  fields.add("component", words.si, largest.component);
  if (answer.request.max_other > 0) fields.add(other.one, other.si, in_axes(point.other));
  // The certificate bounds the error of the optimum: duality gap, cone and balance.
  Fields certificate{{"gap", words.si, largest.check.gap},
                     {"outside_cone", words.si, largest.check.outside},
                     {"imbalance", units::kNewtonMillimetre, largest.check.imbalance}};
  if (priced(point)) certificate.add("price_gap", words.si, largest.prices.gap);
  fields.add("certificate", std::move(certificate));
  fields.add("activation", units::kOne, answer.muscles, largest.activation);
  fields.add("tension", units::kNewton, answer.muscles, largest.tension);
  fields.add_some("stops", fields_of_each(point.stops, [&](const StopTorque& stop) {
                    return Fields{{"joint", stop.joint},
                                  {"torque", units::kNewtonMetre, stop.torque},
                                  {"most", units::kNewtonMetre, stop.max_torque},
                                  {words.suffix.substr(1) + "_per_Nm", stop.price}};
                  }));
  if (priced(point)) {
    fields.add("limited_by", limit_fields(answer, point));
    fields.add("degenerate", largest.prices.degenerate());
  }
  if (point.change.size() > 0)
    fields.add("component_change", words.per_degree, answer.rows, point.change);
}

void add_whole(const FeasibleForcePoint& point, Fields& fields) {
  const FeasibleForceSet& set = point.whole->set;
  const ForceAxes& axes = point.axes;
  const FieldUnit unit = words_of(point.load).si;
  // A direction with 0 may have no force at all: its status says so.
  OrderedJson largest, status;
  for (std::size_t k = 0; k < point.whole->along.size(); ++k) {
    largest[axis_direction(axes, k)] = point.whole->along[k].component;
    status[axis_direction(axes, k)] = name_of(point.whole->along[k].status);
  }
  fields.add("set",
             Fields{{"status", name_of(set.status)},
                    {"axes", axes.name},
                    {"dimension", set.dimension},
                    {"volume", set.volume},
                    {"vertices", unit, set.vertices * axes.to_world},
                    {"triangles", units::kOne, set.triangles},
                    {"excess", set.excess},
                    {"imbalance", units::kNewtonMillimetre, set.imbalance},
                    {"carried_by_bones", units::kOne, set.carried.transpose() * axes.to_world},
                    {"largest", unit, largest},
                    {"largest_status", status}});
}

void add_point(const FeasibleForceResult& answer, const FeasibleForcePoint& point, Fields& fields) {
  if (!point.message.empty()) {
    fields.add("failure", point.message);
    return;
  }
  if (answer.map.empty()) fields.add("condition", point.condition);
  if (answer.request.load == TipLoad::kMoment || answer.request.max_other > 0) {
    const LoadWords other = words_of(other_load(answer.request.load));
    if (answer.request.max_other == 0 || std::isinf(answer.request.max_other))
      fields.add(other.many, answer.request.max_other == 0 ? "zero" : "free");
    else
      fields.add("most_" + other.many, other.si, answer.request.max_other);
  }
  if (point.largest) add_largest(answer, point, fields);
  if (point.loss) fields.add("paralysis", loss_fields(*point.loss, answer.request.load));
  const std::string note = note_of(answer, point);
  if (!note.empty()) fields.add("note", note);
  if (point.whole) add_whole(point, fields);
}

/// Returns a note about the forces that bones carry alone if all axes are parallel and a cone of
/// directions may hold such forces.
std::string plane_note(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  if (!point.plane_normal || !makes_force(point) || answer.request.tolerance <= 0 ||
      answer.request.load == TipLoad::kMoment)
    return "";
  return "all axes are parallel: bones alone carry forces across the plane of flexion, and of "
         "equal answers the one with the least of them is given";
}

/// "the stop of WRIST_FE extends with 0.5 of 0.5 N m, 1 N m more gives 12.3 N more".
std::string stop_note(const FeasibleForcePoint& point) {
  if (!makes_force(point)) return "";
  std::string note;
  for (const StopTorque& stop : point.stops) {
    note += fmt::format("{}the stop of {} {} with {:.4g}", note.empty() ? "" : "; ", stop.joint,
                        stop.max_torque > 0 ? "flexes" : "extends", std::abs(stop.torque));
    note += std::isinf(stop.max_torque) ? " N m"
                                        : fmt::format(" of {:.4g} N m", std::abs(stop.max_torque));
    if (stop.price > kNoPrice)
      note +=
          fmt::format(", 1 N m more gives {:.3g} {} more", stop.price, words_of(point.load).unit);
  }
  return note;
}

/// Muscles that pull and have the same arms: how they share is arbitrary.
std::string shared_note(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  if (!makes_force(point)) return "";
  std::string note;
  for (const std::vector<int>& group : point.alike) {
    double pulled = 0;
    std::vector<std::string> names;
    for (const int i : group) {
      pulled += point.largest->tension[i];
      names.push_back(nth(answer.muscles, i));
    }
    if (pulled > kNoTipForce)
      note += fmt::format(
          "{}{} have the same moment arms: only the sum of their tensions is determined",
          note.empty() ? "" : "; ", fmt::join(names, " and "));
  }
  return note;
}

/// Load with all muscles, and the share of it that is lost.
std::vector<std::string> loss_cells(const FeasibleForceResult& answer, const ParalysisLoss& loss,
                                    int decimals, const std::string& unknown) {
  const bool solved = loss.intact.status == Status::kSolved;
  const int more = words_of(answer.request.load).more_decimals;
  return {solved ? shown(loss.intact.component, decimals + more) : unknown,
          std::isnan(loss.share) ? unknown : shown(loss.share, decimals)};
}

/// "Without EPL, with 44.6 N of FPL: 63.2 % of 53.8 N (all muscles) is lost".
std::string loss_text(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  if (!point.loss) return "";
  const LoadWords words = words_of(point.load);
  const std::string without = weak_words(answer) + ": ";
  if (std::isnan(point.loss->share)) return without + "the loss is not known\n\n";
  return fmt::format("{}{:.1f} % of {} {} (all muscles) is lost\n\n", without,
                     100 * point.loss->share,
                     shown(point.loss->intact.component, 3 + words.more_decimals), words.unit);
}

/// The largest force at one posture.
std::string largest_text(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  // State the load in newtons along the requested axes.
  const MaxTipForce& largest = *point.largest;
  const LoadWords words = words_of(point.load), other = words_of(other_load(point.load));
  const auto in_axes = [&](const Eigen::Vector3d& load, const LoadWords& of) {
    const Eigen::Vector3d seen = point.axes.to_world.transpose() * load;
    return fmt::format("({}) = ({}) {} in {} axes", fmt::join(point.axes.names, ", "),
                       fmt::join(cells(seen, 3 + of.more_decimals), ", "), of.unit,
                       point.axes.name);
  };
  if (largest.status != Status::kSolved) return status_line(point) + "\n";
  if (!makes_force(point))
    return fmt::format("Largest {}: none; {}\n\n", words.one,
                       force_status_words(Status::kInfeasible, point.load, model_of(point)));
  std::string text = fmt::format("Largest {}: {} {} along the direction\nas {}\n", words.one,
                                 shown(largest.component, 3 + words.more_decimals), words.unit,
                                 in_axes(largest.force, words));
  if (answer.request.max_other > 0)
    text += fmt::format("with {}: {}\n", other_words(answer.request.load, answer.request.max_other),
                        in_axes(point.other, other));
  // Limits, change with the posture, and doubts.
  const std::string limits = limit_words(answer, point);
  if (!limits.empty()) text += limits + "\n";
  if (point.change.size() > 0)
    text += fmt::format("change in the largest {} {}\n", words.one,
                        change_line(answer.rows, point.change, words.unit));
  const std::string note = note_of(answer, point);
  if (!note.empty()) text += "note: " + note + "\n";
  return text + "\n" + aligned(limit_table(answer, point)) + "\n";
}

/// ", moments beside it free"; "" if there are none.
std::string beside(const FeasibleForceResult& answer) {
  const std::string words = other_words(answer.request.load, answer.request.max_other);
  return words.empty() ? "" : ", " + words;
}

/// "pure force", or "force" where moments go with it.
std::string pure(const FeasibleForceResult& answer) {
  return (answer.request.max_other > 0 ? "" : "pure ") + words_of(answer.request.load).one;
}

/// "N^3", "(N m)^3"
std::string power_of(const std::string& unit, int dimension) {
  return fmt::format("{}^{}", unit == "N" ? unit : "(" + unit + ")", dimension);
}

/// A warning about all forces at a posture; "" if there is none.
std::string set_note(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  if (!answer.map.empty() || point.condition < kNearlyStraight ||
      answer.request.load == TipLoad::kMoment)
    return "";
  return fmt::format(
      "nearly singular posture (condition {:.3g}): the set changes much within a degree",
      point.condition);
}

/// All forces at one posture.
std::string whole_text(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  // Largest loads along each axis, then the set itself.
  const FeasibleForceSet& set = point.whole->set;
  const ForceAxes& axes = point.axes;
  const LoadWords words = words_of(point.load);
  Table along{{"direction", "largest" + words.suffix, "status"}};
  for (std::size_t k = 0; k < point.whole->along.size(); ++k)
    along.add({axis_direction(axes, k),
               shown(point.whole->along[k].component, 3 + words.more_decimals),
               name_of(point.whole->along[k].status)});
  std::string text =
      fmt::format("All {} the tip can make{}: dimension {}, volume {:.5g} {}, {} vertices\n",
                  words.many, beside(answer), set.dimension, set.volume,
                  set.dimension > 0 ? power_of(words.unit, set.dimension) : "(a point)",
                  set.vertices.rows()) +
      status_line(set.status, point);
  // A singular posture lets the bones carry loads that need no tension.
  for (Index c = 0; c < set.carried.cols(); ++c)
    text += fmt::format(
        "plus any {} along ({}), which the bones carry alone; vertices are across it\n", words.one,
        fmt::join(cells(axes.to_world.transpose() * set.carried.col(c), 3), ", "));
  text += fmt::format("\nLargest {} along each of the {} axes\n{}\n", pure(answer), axes.name,
                      aligned(along));
  if (set.vertices.rows() > 0)
    text += "Vertices\n" + aligned(vertex_table(axes, set, words)) + "\n";
  const std::string note = set_note(answer, point);
  return note.empty() ? text : text + "note: " + note + "\n";
}

/// Cells of the largest force at a posture, for a row. @param none  where there is no force
std::vector<std::string> largest_cells(const FeasibleForceResult& answer,
                                       const FeasibleForcePoint& point, int decimals,
                                       const std::string& none) {
  const MaxTipForce& largest = *point.largest;
  const bool other = answer.request.max_other > 0;
  if (makes_none(point))
    return row({{status_name(point)}, std::vector<std::string>(other ? 7 : 4, none)});
  const auto seen = [&](const Eigen::Vector3d& load, TipLoad of) {
    return cells(Eigen::Vector3d(point.axes.to_world.transpose() * load),
                 decimals + words_of(of).more_decimals);
  };
  std::vector<std::string> line{
      name_of(largest.status),
      shown(largest.component, decimals + words_of(answer.request.load).more_decimals)};
  line = row({line, seen(largest.force, answer.request.load)});
  return other ? row({line, seen(point.other, other_load(answer.request.load))}) : line;
}

std::vector<std::string> whole_cells(const FeasibleForcePoint& point, int decimals) {
  std::vector<std::string> line{std::to_string(point.whole->set.dimension),
                                shown(point.whole->set.volume)};
  for (const MaxTipForce& each : point.whole->along)
    line.push_back(shown(each.component, decimals + words_of(point.load).more_decimals));
  return line;
}

/// Axes of the first posture that has an answer.
ForceAxes axes_of_answer(const FeasibleForceResult& answer) {
  for (const FeasibleForcePoint& point : answer.points)
    if (point.message.empty()) return point.axes;
  return {};
}

/// Columns of largest_cells(): of the load, and of the other one where there may be some.
std::vector<std::string> largest_header(const FeasibleForceResult& answer, const ForceAxes& axes) {
  const LoadWords words = words_of(answer.request.load),
                  other = words_of(other_load(answer.request.load));
  const std::vector<std::string> of_other = with_ending(axes.names, other.suffix);
  return row({{"status", "component" + words.suffix},
              with_ending(axes.names, words.suffix),
              answer.request.max_other > 0 ? of_other : std::vector<std::string>{}});
}

std::vector<std::string> whole_header(const FeasibleForceResult& answer, const ForceAxes& axes) {
  std::vector<std::string> header{"dimension", "volume"};
  for (std::size_t k = 0; k < 6; ++k)
    header.push_back("largest_" + axis_direction(axes, k) + words_of(answer.request.load).suffix);
  return header;
}

/// "FDP 0.12, LU 0.03": prices of a row, the dearest first.
std::string short_limits(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  return or_dash(each_in_words(limiting_muscles(point), [&](Index i) {
    return nth(answer.muscles, i) + " " + price_cell(point, i);
  }));
}

/// "FDP LU": who limits the force, the dearest first.
std::string limiting_names(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  return each_in_words(
      limiting_muscles(point), [&](Index i) { return nth(answer.muscles, i); }, " ");
}

/// Activation and price of a muscle, empty where there is no force.
std::vector<std::string> muscle_cells(const FeasibleForcePoint& point, Index i) {
  if (makes_none(point)) return {"", ""};
  return {shown(point.largest->activation(i), 6), price_cell(point, i)};
}

/// Columns of what paralysis costs; none if no muscle of the digit is paralysed.
std::vector<std::string> loss_header(const FeasibleForceResult& answer) {
  if (answer.without.empty() && answer.weakened.empty()) return {};
  return {"intact" + words_of(answer.request.load).suffix, "loss"};
}

/// Notes of the postures, each once with how many have it.
std::string notes_text(const FeasibleForceResult& answer) {
  std::vector<std::pair<std::string, std::size_t>> notes;
  for (const FeasibleForcePoint& point : answer.points) {
    const std::string note = point.message.empty() ? note_of(answer, point) : "";
    if (note.empty()) continue;
    const auto known = std::find_if(notes.begin(), notes.end(),
                                    [&](const auto& each) { return each.first == note; });
    if (known == notes.end())
      notes.emplace_back(note, 1);
    else
      ++known->second;
  }
  constexpr std::size_t kMaxNotes = 4;  // lines; CSV and JSON have all
  if (notes.size() > kMaxNotes) notes.resize(kMaxNotes);
  std::string text;
  for (const auto& [note, count] : notes)
    text += fmt::format("note ({} of {} postures): {}\n", count, answer.points.size(), note);
  return text;
}

/// A row for each posture.
std::string many_postures(const FeasibleForceResult& answer) {
  const ForceAxes force = axes_of_answer(answer);
  const LoadWords words = words_of(answer.request.load);
  std::string text;
  if (answer.request.direction)
    // The largest load along the direction, then the set.
    text += titled(
        fmt::format("Largest {} along the direction{}, {} axes; limits in {} per N of F0",
                    words.one, beside(answer), force.name, words.unit),
        posture_table(
            answer, row({largest_header(answer, force), {"limited_by"}, loss_header(answer)}),
            [&](const FeasibleForcePoint& point) {
              std::vector<std::string> line =
                  row({largest_cells(answer, point, 3, "-"), {short_limits(answer, point)}});
              if (point.loss) line = row({line, loss_cells(answer, *point.loss, 3, "-")});
              return line;
            }));
  if (with_whole(answer))
    text += titled(fmt::format("All {}: the set, and the largest {} along the {} axes", words.many,
                               pure(answer), force.name),
                   posture_table(answer, whole_header(answer, force),
                                 [](const auto& point) { return whole_cells(point, 3); }));
  if (answer.request.direction) text += notes_text(answer);
  return text;
}

}  // namespace

LoadWords words_of(TipLoad load) {
  if (load == TipLoad::kForce)
    return {"force", "forces", "N", "_N", 0, units::kNewton, units::kNewtonPerDegree};
  return {"moment", "moments", "N m", "_Nm", 2, units::kNewtonMetre, units::kNewtonMetrePerDegree};
}

TipLoad other_load(TipLoad load) {
  return load == TipLoad::kForce ? TipLoad::kMoment : TipLoad::kForce;
}

std::string other_words(TipLoad load, double max_other) {
  const LoadWords other = words_of(other_load(load));
  if (max_other == 0) return "";
  if (std::isinf(max_other)) return other.many + " beside it free";
  return fmt::format("{} of at most {:.4g} {} {} each axis beside it", other.many, max_other,
                     other.unit, load == TipLoad::kForce ? "about" : "along");
}

std::string weak_words(const FeasibleForceResult& answer) {
  std::string words;
  if (!answer.without.empty()) words = fmt::format("without {}", fmt::join(answer.without, ", "));
  for (const auto& [muscle, limit] : answer.weakened)
    words += fmt::format("{}with {:.4g} N of {}", words.empty() ? "" : ", ", limit, muscle);
  if (!words.empty()) words[0] = 'W';
  return words;
}

bool with_whole(const FeasibleForceResult& answer) {
  return any_of(answer.points, [](const auto& point) { return point.whole.has_value(); });
}

bool makes_force(const FeasibleForcePoint& point) {
  return point.largest && point.largest->status == Status::kSolved &&
         point.largest->component >= no_tip_load(point.load);
}

Table limit_table(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  const MaxTipForce& largest = *point.largest;
  Table muscles{{"muscle", "activation", "tension_N", "F0_N", price_header(answer.request.load)}};
  for (Index i = 0; i < largest.tension.size(); ++i)
    muscles.add({nth(answer.muscles, i), shown(largest.activation[i], 4),
                 shown(largest.tension[i], 2), shown(answer.max_tension[i], 2),
                 price_cell(point, i)});
  return muscles;
}

std::string force_status_words(Status status, TipLoad load, TipModel model) {
  // Return each status with its mechanical reason.
  const std::string one = words_of(load).one;
  switch (status) {
    case Status::kSolved:
      return "";
    case Status::kInfeasible:
      return fmt::format(
          "no combination of tensions produces a {} in this direction {}", one,
          model == TipModel::kMap ? "by this map" : "with every joint in equilibrium");
    case Status::kUnbounded:
      if (model == TipModel::kMap)
        return fmt::format("by this map nothing limits the {} this way", one);
      return load == TipLoad::kForce
                 ? "the bones alone carry any force this way (a singular posture, or a hold)"
                 : "no joint feels this moment, so that the bones alone carry any";
    case Status::kLimit:
      return "the numerical method reached its limit of steps";
    case Status::kStopped:
      return "stopped";
    case Status::kStalled:
      return "the numerical method gave up";
  }
  return "";
}

std::string axis_direction(const ForceAxes& axes, std::size_t k) {
  return (k % 2 == 0 ? "+" : "-") + axes.names[k / 2];
}

std::vector<Index> limiting_muscles(const FeasibleForcePoint& point) {
  std::vector<Index> muscles;
  if (!priced(point)) return muscles;
  const ForceLimitPrices& prices = point.largest->prices;
  for (Index i = 0; i < prices.decrease.size(); ++i)
    if (!(prices.decrease(i) <= kNoPrice)) muscles.push_back(i);
  std::sort(muscles.begin(), muscles.end(), [&](Index a, Index b) {
    return std::make_pair(prices.increase(a), prices.decrease(a)) >
           std::make_pair(prices.increase(b), prices.decrease(b));
  });
  return muscles;
}

std::string limit_words(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  const std::vector<Index> muscles = limiting_muscles(point);
  if (muscles.empty()) return "";
  const ForceLimitPrices& prices = point.largest->prices;
  const auto name = [&](Index i) { return nth(answer.muscles, i); };
  const Index first = muscles.front();
  const std::string unit = words_of(answer.request.load).unit;
  std::string text =
      fmt::format("limited by {}: the {} rises by {:.3g} {} per additional newton of its F0",
                  name(first), words_of(answer.request.load).one, prices.increase(first), unit);
  if (differs(prices, first))
    text += fmt::format(", 1 N less takes {:.3g} {}", prices.decrease(first), unit);
  for (std::size_t k = 1; k < std::min(muscles.size(), kMaxNamed); ++k)
    text += fmt::format("{} {} {}", k == 1 ? "; then" : ",", name(muscles[k]),
                        price_cell(point, muscles[k]));
  if (muscles.size() > kMaxNamed) text += fmt::format(" and {} more", muscles.size() - kMaxNamed);
  if (prices.degenerate())
    text += "\nseveral limits meet here: a muscle alone gives the first number of " +
            price_header(answer.request.load) +
            " when its F0 grows, and takes the second when it shrinks";
  return text;
}

std::string note_of(const FeasibleForceResult& answer, const FeasibleForcePoint& point) {
  if (point.largest) {
    std::string note = makes_none(point)
                           ? force_status_words(Status::kInfeasible, point.load, model_of(point))
                           : "";
    for (const std::string& more :
         {plane_note(answer, point), shared_note(answer, point), stop_note(point),
          answer.request.load == TipLoad::kMoment
              ? ""
              : posture_note(answer.rows, point.condition, point.change)})
      if (!more.empty()) note += (note.empty() ? "" : "; ") + more;
    if (!note.empty()) return note;
  }
  return point.whole ? set_note(answer, point) : "";
}

std::string text_of(const FeasibleForceResult& answer) {
  std::string text = text_header(answer) + passive_line(answer) + "\n";
  if (!answer.single()) return text + many_postures(answer);
  const FeasibleForcePoint& point = answer.points.front();
  if (point.largest) text += largest_text(answer, point) + loss_text(answer, point);
  if (point.whole) text += whole_text(answer, point);
  return text + "\n";
}

Fields fields_of(const FeasibleForceResult& answer) {
  Fields fields = digit_fields(answer, [&](std::size_t i, Fields& point) {
    add_passive(answer, i, point);
    add_point(answer, answer.points[i], point);
  });
  if (!answer.without.empty()) fields.add("without", answer.without);
  if (!answer.weakened.empty()) fields.add("weakened", units::kNewton, answer.weakened);
  if (answer.request.wrist != WristLoad::kHeld)
    fields.add("wrist", name_in(kWristLoadNames, answer.request.wrist));
  return fields;
}

Table table_of(const FeasibleForceResult& answer) {
  // Columns depend on the question: direction, loss and set.
  const ForceAxes axes = axes_of_answer(answer);
  const bool whole = with_whole(answer), direction = answer.request.direction.has_value();
  Table table{joint_header(answer)};
  const auto add = [&](const std::vector<std::string>& names) {
    table.header.insert(table.header.end(), names.begin(), names.end());
  };
  if (direction) {
    add(largest_header(answer, axes));
    add({"limited_by"});
    add(loss_header(answer));
    for (const std::string& muscle : answer.muscles)
      add({muscle + "_activation", muscle + "_" + price_header(answer.request.load)});
  }
  if (whole) add(whole_header(answer, axes));
  add({"note"});
  // Failed postures keep their angles and the reason.
  for (const FeasibleForcePoint& point : answer.points) {
    std::vector<std::string> line = joint_cells(point.q);
    if (point.message.empty()) {
      if (direction)
        line = row({line, largest_cells(answer, point, 6, ""), {limiting_names(answer, point)}});
      if (point.loss) line = row({line, loss_cells(answer, *point.loss, 6, "")});
      for (Index i = 0; direction && i < point.largest->activation.size(); ++i)
        line = row({line, muscle_cells(point, i)});
      if (whole) line = row({line, whole_cells(point, 6)});
    }
    line.resize(table.header.size() - 1);
    line.push_back(point.message.empty() ? note_of(answer, point) : point.message);
    table.add(std::move(line));
  }
  return table;
}

}  // namespace thenar
