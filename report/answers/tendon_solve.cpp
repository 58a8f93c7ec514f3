#include "report/answers/tendon_solve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "base/enum_names.h"
#include "base/units.h"
#include "base/words.h"
#include "hand/passive_moment.h"
#include "report/answers/passive_words.h"
#include "report/words.h"
#include "tendons/net/band_course.h"

namespace thenar {
namespace {

const std::vector<std::string> kTipDirections{"proximal", "dorsal", "radial"};

constexpr std::array kTendonStatusNames{EnumName{TendonStatus::kValid, "sound"},
                                        EnumName{TendonStatus::kApproximate, "rough"},
                                        EnumName{TendonStatus::kBandInsideBone, "buried"},
                                        EnumName{TendonStatus::kNodeCollapsed, "drawn in"},
                                        EnumName{TendonStatus::kOutOfRange, "out of range"},
                                        EnumName{TendonStatus::kInvalidPath, "astray"},
                                        EnumName{TendonStatus::kUnstable, "unstable"},
                                        EnumName{TendonStatus::kOverstrained, "overstrained"},
                                        EnumName{TendonStatus::kUnbalanced, "unbalanced"}};
constexpr std::array kNetStatusNames{EnumName{NetStatus::kBalanced, "balanced"},
                                     EnumName{NetStatus::kUnstable, "unstable"},
                                     EnumName{NetStatus::kNodeCollapsed, "drawn in"},
                                     EnumName{NetStatus::kStalled, "stalled"},
                                     EnumName{NetStatus::kFarSideWrap, "wound round"},
                                     EnumName{NetStatus::kOverstrained, "overstrained"}};

/// A band of the answer.
struct BandRow {
  std::string name, from, to, state;
  double length, slack;  // [m]; slack length NaN of a muscle
  double tension;        // [N]
};

std::vector<BandRow> band_rows(const LoadedDigit& loaded, const DigitPoint& point) {
  const Net& net = loaded.net()->net().net;
  const TreeState<double> state = pose_tree(loaded.bones().model.tree, point.q);
  std::vector<BandRow> rows;
  for (std::size_t k = 0; k < net.bands.size(); ++k) {
    const NetBand& band = net.bands[k];
    const double tension = point.rest.tension[static_cast<Eigen::Index>(k)];
    const bool bent = band_course(net, state, point.rest, static_cast<int>(k)).bent;
    rows.push_back(
        {band.name, nth(net.nodes, band.a).name, nth(net.nodes, band.b).name,
         std::string(tension > kTautTension ? "taut" : "slack") + (bent ? ", on bone" : ""),
         point.rest.length[static_cast<Eigen::Index>(k)],
         band.muscle < 0 ? band.slack : std::nan(""), tension});
  }
  return rows;
}

/// Terminal per central slip; NaN if the central one is slack.
double slip_ratio(const SlipTension& slips) {
  return slips.central > kTautTension ? slips.terminal / slips.central : std::nan("");
}

/// A tension with four decimals; "0" for a slack tendon.
std::string shown_tension(double tension) {
  return std::abs(tension) > kTautTension ? shown(tension, 4) : "0";
}

/// Subject, digit, fidelity, net and tensions: the first fields of every answer.
Fields tendon_header(const LoadedDigit& loaded) {
  Fields fields{{"subject", loaded.subject},
                {"digit", loaded.digit},
                {"fidelity", describe(loaded.bones().fidelity)}};
  if (loaded.net() != nullptr) fields.add("net", loaded.net()->net().net.name);
  fields.add("tension", units::kNewton, loaded.bones().names.muscles, loaded.t);
  return fields;
}

/// Returns the header of an answer as two lines of text.
std::string tendon_title(const LoadedDigit& loaded) {
  const std::string pulled = tensions_in_words(loaded);
  return fmt::format("{} of {} {} N\nmodel: {}{}\n", loaded.digit, loaded.subject,
                     pulled.empty() ? "at 0" : "under " + pulled, describe(loaded.bones().fidelity),
                     loaded.net() == nullptr ? "" : ", net " + loaded.net()->net().net.name);
}

void add_net(const LoadedDigit& loaded, const DigitPoint& point, Fields& fields) {
  // State how the net came to rest, and how well.
  const Net& net = loaded.net()->net().net;
  fields.add("status", name_of(point.rest.status));
  fields.add("snapped", point.snapped);
  fields.add("residual", units::kNewton, point.rest.residual);
  fields.add("iterations", point.rest.iterations);
  std::vector<Fields> bands, nodes, contacts;
  for (const BandRow& row : band_rows(loaded, point))
    bands.push_back({{"name", row.name},
                     {"from", row.from},
                     {"to", row.to},
                     {"length", units::kMillimetre, row.length},
                     {"slack", units::kMillimetre, row.slack},
                     {"tension", units::kNewton, row.tension},
                     {"state", row.state}});
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    nodes.push_back(
        {{"name", net.nodes[i].name},
         {"floating", net.nodes[i].free},
         {"place", units::kMillimetre, point.rest.x.col(static_cast<Eigen::Index>(i))}});
  // Of nodes with bone.
  for (const NetContact& contact : point.rest.contacts)
    contacts.push_back({{"node", nth(net.nodes, contact.node).name},
                        {"surface", nth(net.surfaces, contact.surface).name},
                        {"force", units::kNewton, contact.force}});
  fields.add("bands", std::move(bands));
  fields.add("nodes", std::move(nodes));
  fields.add("contacts", std::move(contacts));
}

std::string net_text(const LoadedDigit& loaded, const DigitPoint& point) {
  const Net& net = loaded.net()->net().net;
  Table bands{{"band", "from", "to", "length_mm", "slack_length_mm", "tension_N", "state"}};
  for (const BandRow& row : band_rows(loaded, point))
    bands.add({row.name, row.from, row.to, shown(row.length / kMm, 3),
               std::isfinite(row.slack) ? shown(row.slack / kMm, 3) : "-",
               shown_tension(row.tension), row.state});

  Table nodes{{"node", "x_mm", "y_mm", "z_mm"}};
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    if (net.nodes[i].free)
      nodes.add_parts({{net.nodes[i].name},
                       cells((point.rest.x.col(static_cast<Eigen::Index>(i)) / kMm).eval(), 3)});

  Table contacts{{"node", "surface", "force_N"}};
  for (const NetContact& contact : point.rest.contacts)
    contacts.add({nth(net.nodes, contact.node).name, nth(net.surfaces, contact.surface).name,
                  shown(contact.force, 4)});
  return titled("Bands of the extensor hood", bands) +
         titled("Floating nodes of the hood, in the subject's frame", nodes) +
         titled("Nodes pressed on bone", contacts);
}

std::string slip_text(const SlipTension& slips) {
  const double ratio = slip_ratio(slips);
  return titled(
      "Slips of the extensor hood (radial and ulnar: the lateral bands)",
      {{"central_N", "radial_N", "ulnar_N", "terminal_N", "terminal/central"},
       {{shown_tension(slips.central), shown_tension(slips.radial), shown_tension(slips.ulnar),
         shown_tension(slips.terminal), std::isfinite(ratio) ? shown(ratio, 4) : "-"}}});
}

std::string tip_text(const LoadedDigit& loaded, const DigitPoint& point) {
  Table force{{"direction", "force_N"}};
  const Eigen::Vector3d along = force_in_tip_axes(loaded, point);
  for (int k = 0; k < 3; ++k) force.add({nth(kTipDirections, k), shown(along[k], 4)});
  for (int k = 0; k < 3; ++k)
    force.add({fmt::format("{} of the subject", "xyz"[k]), shown(point.tip.f_W[k], 4)});
  force.add({"magnitude", shown(point.tip.f_W.norm(), 4)});
  std::string text = titled("Force of the pinned fingertip on the world", force);
  text += fmt::format("condition number of the tip's Jacobian: {:.4g}\n", point.tip.condition);
  const std::string note = tip_note(point.tip);
  return note.empty() ? text : text + fmt::format("note: {}\n", note);
}

/// A column of numbers: its key, and its value at a posture in SI.
struct SweepColumn {
  std::string key;
  FieldUnit unit;
  std::function<double(const DigitPoint&)> value;

  [[nodiscard]] std::string name() const { return key_with(key, unit, UnitSystem::kPrinted); }
  /// In the unit of name().
  [[nodiscard]] double printed(const DigitPoint& point) const {
    return value(point) * unit.numerator / unit.denominator;
  }
};

/// A column for each of the names. @param value  at a posture, by the place of the name
std::vector<SweepColumn> columns_of(
    const std::string& before, const std::vector<std::string>& names, const FieldUnit& unit,
    const std::function<double(const DigitPoint&, Eigen::Index)>& value) {
  std::vector<SweepColumn> columns;
  for (std::size_t i = 0; i < names.size(); ++i)
    columns.push_back({before + names[i], unit, [value, i](const DigitPoint& point) {
                         return value(point, static_cast<Eigen::Index>(i));
                       }});
  return columns;
}

std::vector<SweepColumn> angle_columns(const TendonNames& names) {
  return columns_of("", names.coordinates, units::kDegree,
                    [](const DigitPoint& p, Eigen::Index i) { return p.q[i]; });
}

std::vector<SweepColumn> slip_columns(const LoadedDigit& loaded) {
  if (loaded.net() == nullptr && !loaded.bones().model.hood) return {};
  return {{"central", units::kNewton, [](const DigitPoint& p) { return p.pull.slips.central; }},
          {"radial", units::kNewton, [](const DigitPoint& p) { return p.pull.slips.radial; }},
          {"ulnar", units::kNewton, [](const DigitPoint& p) { return p.pull.slips.ulnar; }},
          {"terminal", units::kNewton, [](const DigitPoint& p) { return p.pull.slips.terminal; }}};
}

std::vector<SweepColumn> band_columns(const LoadedDigit& loaded) {
  if (loaded.net() == nullptr) return {};
  std::vector<SweepColumn> columns =
      columns_of("tension_", names_of(loaded.net()->net().net.bands), units::kNewton,
                 [](const DigitPoint& p, Eigen::Index k) { return p.rest.tension[k]; });
  columns.insert(columns.begin(),
                 {"residual", units::kNewton, [](const DigitPoint& p) { return p.rest.residual; }});
  return columns;
}

std::vector<SweepColumn> force_columns(const LoadedDigit& loaded) {
  return columns_of(
      "force_", kTipDirections, units::kNewton,
      [&loaded](const DigitPoint& p, Eigen::Index k) { return force_in_tip_axes(loaded, p)[k]; });
}

std::vector<SweepColumn> torque_columns(const TendonNames& names) {
  return columns_of("torque_", names.coordinates, units::kNewtonMillimetre,
                    [](const DigitPoint& p, Eigen::Index j) { return p.pull.tau[j]; });
}

std::vector<SweepColumn> joined_columns(std::vector<std::vector<SweepColumn>> parts) {
  std::vector<SweepColumn> all;
  for (std::vector<SweepColumn>& part : parts)
    for (SweepColumn& column : part) all.push_back(std::move(column));
  return all;
}

/// Columns of numbers behind angles and status.
std::vector<SweepColumn> number_columns(const LoadedDigit& loaded) {
  const TendonNames& names = loaded.bones().names;
  std::vector<std::vector<SweepColumn>> parts{
      slip_columns(loaded),
      band_columns(loaded),
      force_columns(loaded),
      {{"condition", units::kOne, [](const DigitPoint& p) { return p.tip.condition; }}},
      torque_columns(names)};
  for (std::size_t i = 0; i < names.muscles.size(); ++i)
    parts.push_back(columns_of("arm_" + names.muscles[i] + "_", names.coordinates,
                               units::kMillimetre, [i](const DigitPoint& p, Eigen::Index j) {
                                 return p.pull.R(static_cast<Eigen::Index>(i), j);
                               }));
  return joined_columns(std::move(parts));
}

/// Returns the status of the net's search; if the net is in balance, or there is no net, the status
/// of the tendons.
std::string status_of(const LoadedDigit& loaded, const DigitPoint& point) {
  const bool net = loaded.net() != nullptr && (point.rest.status != NetStatus::kBalanced ||
                                               point.pull.status == TendonStatus::kValid);
  return net ? name_of(point.rest.status) : name_of(point.pull.status);
}

Table rows_of(const LoadedDigit& loaded, const std::vector<DigitPoint>& points) {
  const std::vector<SweepColumn> angles = angle_columns(loaded.bones().names),
                                 numbers = number_columns(loaded);
  const bool net = loaded.net() != nullptr;
  // Header.
  Table table;
  for (const SweepColumn& column : angles) table.header.push_back(column.name());
  table.header.emplace_back("status");
  if (net) table.header.emplace_back("snapped");
  table.header.emplace_back("trouble");
  for (const SweepColumn& column : numbers) table.header.push_back(column.name());
  // Rows.
  for (const DigitPoint& point : points) {
    std::vector<std::string> cells;
    cells.reserve(table.header.size());
    for (const SweepColumn& column : angles)
      cells.push_back(fmt::format("{:.10g}", column.printed(point)));
    cells.push_back(status_of(loaded, point));
    if (net) cells.emplace_back(point.snapped ? "1" : "0");
    cells.push_back(point.pull.warning);
    for (const SweepColumn& column : numbers)
      cells.push_back(fmt::format("{:.10g}", column.printed(point)));
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace

std::string tensions_in_words(const LoadedDigit& loaded) {
  std::string pulled;
  for (Eigen::Index i = 0; i < loaded.t.size(); ++i)
    if (loaded.t[i] > 0)
      pulled += fmt::format("{}{}={:.4g}", pulled.empty() ? "" : " ",
                            nth(loaded.bones().names.muscles, i), loaded.t[i]);
  return pulled;
}

std::string text_of(const TendonSolveResult& solution) {
  // Posture and passive torques first, as they do not depend on tensions.
  const LoadedDigit& loaded = solution.loaded;
  const DigitPoint& point = solution.point;
  const TendonNames& names = loaded.bones().names;
  std::string text = tendon_title(loaded) + "\n";
  text += titled("Posture [deg]", {names.coordinates, {cells((point.q / kDegree).eval(), 2)}});
  text += passive_line(loaded.bones().skeleton, point.q);
  if (loaded.net() != nullptr) text += net_text(loaded, point);
  if (loaded.net() != nullptr || loaded.bones().model.hood) text += slip_text(point.pull.slips);
  // Torques.
  Table torque{{"joint", "torque_N_mm", "unbalanced_N_mm"}};
  for (std::size_t i = 0; i < names.coordinates.size(); ++i)
    torque.add(
        {names.coordinates[i],
         shown(point.pull.tau[static_cast<Eigen::Index>(i)] / kNewtonMillimetre, 4),
         shown(point.tip.tau_residual[static_cast<Eigen::Index>(i)] / kNewtonMillimetre, 4)});
  text += titled(
      "Joint torque of all tendons, flexion positive, and the part that no tip force can balance",
      torque);
  text += tip_text(loaded, point);
  if (loaded.net() != nullptr)
    text += fmt::format(
        "equilibrium of the hood: {}, largest force out of balance {:.2g} N, {} steps\n",
        name_of(point.rest.status), point.rest.residual, point.rest.iterations);
  return text;
}

Fields fields_of(const TendonSolveResult& solution) {
  const LoadedDigit& loaded = solution.loaded;
  const DigitPoint& point = solution.point;
  const TendonNames& names = loaded.bones().names;
  Fields fields = tendon_header(loaded);
  fields.add("posture", units::kDegree, names.coordinates, point.q);
  add_passive(loaded.bones().skeleton, point.q, fields);
  if (loaded.net() != nullptr) add_net(loaded, point, fields);
  if (!point.pull.warning.empty())
    for (const char* member : {"trouble", "warning"}) fields.add(member, point.pull.warning);
  // Slips.
  const SlipTension& slips = point.pull.slips;
  fields.add("slips", units::kNewton,
             OrderedJson{{"central", slips.central},
                         {"radial", slips.radial},
                         {"ulnar", slips.ulnar},
                         {"terminal", slips.terminal}});
  fields.add("terminal_to_central", slip_ratio(slips));
  // Torques and moment arms.
  fields.add("torque", units::kNewtonMillimetre, names.coordinates, point.pull.tau);
  OrderedJson arms;
  for (std::size_t m = 0; m < names.muscles.size(); ++m)
    arms[names.muscles[m]] =
        to_json(names.coordinates, point.pull.R.row(static_cast<Eigen::Index>(m)));
  fields.add("moment_arm", units::kMillimetre, std::move(arms));
  // Force of the tip.
  fields.add("force", units::kNewton, point.tip.f_W);
  fields.add("force_tip_axes", units::kNewton, kTipDirections, force_in_tip_axes(loaded, point));
  fields.add("leftover_torque", units::kNewtonMillimetre, names.coordinates,
             point.tip.tau_residual);
  fields.add("condition", point.tip.condition);
  if (const std::string note = tip_note(point.tip); !note.empty()) fields.add("note", note);
  fields.add("warnings", solution.outcome.warnings);
  return fields;
}

Table table_of(const TendonSolveResult& solution) {
  return rows_of(solution.loaded, {solution.point});
}

std::string text_of(const TendonSweepResult& sweep) {
  const LoadedDigit& loaded = sweep.loaded;
  const std::vector<SweepColumn> columns = joined_columns(
      {slip_columns(loaded), force_columns(loaded), torque_columns(loaded.bones().names)});
  Table table{{"quantity", "first", "last", "min", "max"}};
  for (const SweepColumn& column : columns) {
    const std::vector<double> values =
        transformed(sweep.points, [&](const DigitPoint& point) { return column.printed(point); });
    if (values.empty()) continue;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    table.add({column.name(), shown(values.front(), 4), shown(values.back(), 4), shown(*low, 4),
               shown(*high, 4)});
  }
  std::string text = tendon_title(loaded);
  if (has_passive(loaded.bones().skeleton)) text += "passive moments of joints are counted\n";
  if (!sweep.points.empty())
    text +=
        fmt::format("{}, from {} to {}\n", counted(sweep.points.size(), "posture"),
                    place_of(loaded, sweep.points.front()), place_of(loaded, sweep.points.back()));
  return text + "\n" + titled("Over the sweep", table);
}

Fields fields_of(const TendonSweepResult& sweep) {
  const LoadedDigit& loaded = sweep.loaded;
  Fields fields = tendon_header(loaded);
  const auto add_each = [&](const std::string& key, const FieldUnit& unit, const auto& value) {
    fields.add(key, unit, list_of_each<OrderedJson>(sweep.points, value));
  };
  add_each("status", units::kOne, [&](const DigitPoint& p) { return status_of(loaded, p); });
  if (loaded.net() != nullptr)
    add_each("snapped", units::kOne, [](const DigitPoint& p) { return p.snapped; });
  add_each("trouble", units::kOne, [](const DigitPoint& p) { return p.pull.warning; });
  for (const SweepColumn& column :
       joined_columns({angle_columns(loaded.bones().names), number_columns(loaded)}))
    add_each(column.key, column.unit, column.value);
  fields.add("warnings", sweep.outcome.warnings);
  return fields;
}

Table table_of(const TendonSweepResult& sweep) { return rows_of(sweep.loaded, sweep.points); }

std::string refusal_of(const TendonSolveResult& solution) {
  const TendonTorque& pull = solution.point.pull;
  if (is_trusted(pull.status)) return "";
  return fmt::format("the tendons are not to be trusted here ({}): {}", name_of(pull.status),
                     pull.warning);
}

std::string refusal_of(const TendonSweepResult& sweep) {
  const auto refused = [](const DigitPoint& p) { return !is_trusted(p.pull.status); };
  const auto first = std::find_if(sweep.points.begin(), sweep.points.end(), refused);
  if (first == sweep.points.end()) return "";
  return fmt::format("the tendons are not to be trusted at {} of {} postures, first at {} ({}): {}",
                     std::count_if(first, sweep.points.end(), refused), sweep.points.size(),
                     place_of(sweep.loaded, *first), name_of(first->pull.status),
                     first->pull.warning);
}

std::string name_of(TendonStatus status) { return name_in(kTendonStatusNames, status); }
std::string name_of(NetStatus status) { return name_in(kNetStatusNames, status); }

}  // namespace thenar
