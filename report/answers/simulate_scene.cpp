#include "report/answers/simulate_scene.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "base/numbers.h"
#include "base/rung_names.h"
#include "base/units.h"
#include "dynamics/human/joint_stops.h"
#include "hand/passive_moment.h"
#include "report/answers/motion_account.h"
#include "report/words.h"

namespace thenar {
namespace {

std::string body_name(const SceneResult& scene, int body) {
  return nth(scene.built->scene.mechanism.bodies, body).name;
}

/// Centre of mass of a body at an instant [m].
Eigen::Vector3d centre(const SceneResult& scene, std::size_t instant, std::size_t body) {
  return scene.measures.X_WB[instant][body] * scene.built->scene.mechanism.bodies[body].mass.com;
}

/// Angle by which a body has turned since the start [rad].
double turn(const SceneResult& scene, std::size_t body) {
  const auto& X = scene.measures.X_WB;
  return Eigen::AngleAxisd(X.back()[body].R * X.front()[body].R.transpose()).angle();
}

double largest_slip(const SceneResult& scene) {
  double slip = 0;
  for (const PairMeasure& pair : scene.measures.pairs) slip = std::max(slip, pair.slip);
  return slip;
}

double simulated_seconds(const SceneResult& scene) { return scene.run.samples.back().t; }

double cpu_per_second(const SceneResult& scene) {
  return scene.run.cost.cpu_seconds / simulated_seconds(scene);
}

Table body_table(const SceneResult& scene) {
  Table table{
      {"body", "x_mm", "y_mm", "z_mm", "moved_mm", "turned_deg", "speed_m_s", "spin_rad_s"}};
  const std::size_t last = scene.run.samples.size() - 1;
  for (const std::size_t body : scene.measures.moving) {
    const Eigen::Vector3d end = centre(scene, last, body);
    const Eigen::Vector3d way = end - centre(scene, 0, body);
    table.add_parts({{scene.built->scene.mechanism.bodies[body].name},
                     cells(Eigen::Vector3d(end / kMm), 4),
                     {shown(way.norm() / kMm), shown(turn(scene, body) / kDegree, 3),
                      shown(scene.measures.velocity[body].linear.norm()),
                      shown(scene.measures.velocity[body].angular.norm())}});
  }
  return table;
}

const char* mode_word(const PairMeasure& pair) {
  return pair.mode == ContactMode::kOpen    ? "apart"
         : pair.mode == ContactMode::kStick ? "sticks"
                                            : "slides";
}

Table pair_table(const SceneResult& scene) {
  Table table{{"pair", "slip_mm", "first_s", "last_s", "largest_force_N", "end_force_N", "end"}};
  for (const PairMeasure& pair : scene.measures.pairs)
    table.add({body_name(scene, pair.a) + " - " + body_name(scene, pair.b), shown(pair.slip / kMm),
               shown(pair.first), shown(pair.last), shown(pair.largest_force),
               shown(pair.force.norm()), mode_word(pair)});
  return table;
}

bool is_pad(const PairMeasure& pair) { return pair.area > 0; }

/// Patches of pads at the end.
Table patch_table(const SceneResult& scene) {
  Table table{{"pad", "area_mm2", "force_N", "sticks_%", "torsion_Nmm"}};
  for (const PairMeasure& pair : scene.measures.pairs)
    if (is_pad(pair))
      table.add({body_name(scene, pair.a) + " - " + body_name(scene, pair.b),
                 shown(pair.area / (kMm * kMm)), shown(pair.force.norm()), shown(100 * pair.stick),
                 shown(std::abs(pair.torsion) / kMm)});
  return table;
}

std::vector<Fields> body_fields(const SceneResult& scene) {
  std::vector<Fields> list;
  const std::size_t last = scene.run.samples.size() - 1;
  for (const std::size_t body : scene.measures.moving) {
    const Pose<double>& X = scene.measures.X_WB.back()[body];
    const SceneVelocity& velocity = scene.measures.velocity[body];
    const Eigen::Vector3d end = centre(scene, last, body);
    list.push_back({{"body", scene.built->scene.mechanism.bodies[body].name},
                    {"position", units::kMetre, X.p},
                    {"rotation", units::kOne, X.R},
                    {"centre", units::kMetre, end},
                    {"moved", units::kMetre, end - centre(scene, 0, body)},
                    {"turned", units::kRadian, turn(scene, body)},
                    {"velocity", units::kMetrePerSecondShort, velocity.linear},
                    {"angular_velocity", units::kRadianPerSecondShort, velocity.angular}});
  }
  return list;
}

/// Returns true if the first joint of a coordinate slides.
bool slides_along(const Mechanism& mechanism, int coordinate) {
  for (const MechanismJoint& joint : mechanism.joints)
    if (is_scalar(joint.kind) && joint.coordinate == coordinate)
      return joint.kind == JointKind::kSlide;
  return false;
}

std::vector<Fields> coordinate_fields(const SceneResult& scene) {
  std::vector<Fields> list;
  const Mechanism& mechanism = scene.built->scene.mechanism;
  const MechanismLayout layout = layout_of(mechanism);
  const SceneSample &start = scene.run.samples.front(), &end = scene.run.samples.back();
  for (std::size_t c = 0; c < mechanism.coordinates.size(); ++c) {
    const bool slides = slides_along(mechanism, static_cast<int>(c));
    const FieldUnit& unit = slides ? units::kMetreBare : units::kRadianBare;
    list.push_back({{"coordinate", mechanism.coordinates[c].name},
                    {"start", unit, start.q[layout.coordinate_q[c]]},
                    {"end", unit, end.q[layout.coordinate_q[c]]},
                    {"speed", slides ? units::kMetrePerSecondBare : units::kRadianPerSecondBare,
                     end.v[layout.coordinate_v[c]]}});
  }
  return list;
}

/// Passive moments of the joints of human hands at the end, by coordinate [N m]; null: none has
/// any. Their lines are springs of the mechanism, their ends are in the elements that stop joints.
OrderedJson passive_moments(const SceneResult& scene) {
  OrderedJson json;
  // Find the coordinate of each stop by its place in the positions.
  const Mechanism& mechanism = scene.built->scene.mechanism;
  const MechanismLayout layout = layout_of(mechanism);
  const Eigen::VectorXd& q = scene.run.samples.back().q;
  for (const auto& element : scene.built->scene.elements) {
    const auto* stops = dynamic_cast<const JointStops*>(element.get());
    if (stops == nullptr) continue;
    for (std::size_t i = 0; i < stops->ranges().size(); ++i) {
      const int place = stops->indices().q[i];
      const int c = place_in(layout.coordinate_q, place);
      // Add the linear part, which the mechanism has as springs.
      double moment = passive_moment(stops->ranges()[i], q[place]);
      bool some = !stops->ranges()[i].ends.empty();
      for (const MechanismJoint& joint : mechanism.joints) {
        if (!is_scalar(joint.kind) || joint.coordinate != c || joint.stiffness == 0) continue;
        moment -= joint.stiffness * (q[place] - joint.rest);
        some = true;
      }
      if (some) json[nth(mechanism.coordinates, c).name] = moment;
    }
  }
  return json;
}

std::vector<Fields> pair_fields(const SceneResult& scene) {
  return fields_of_each(scene.measures.pairs, [&](const PairMeasure& pair) {
    Fields fields{
        {"bodies", std::vector<std::string>{body_name(scene, pair.a), body_name(scene, pair.b)}},
        {"slip", units::kMetre, pair.slip},
        {"first", units::kSecond, pair.first},
        {"last", units::kSecond, pair.last},
        {"largest_force", units::kNewton, pair.largest_force},
        {"end_force", units::kNewton, pair.force},
        {"end_points", pair.points},
        {"end", mode_word(pair)}};
    if (is_pad(pair))
      fields.add("patch", Fields{{"area", units::kSquareMetre, pair.area},
                                 {"stick", pair.stick},
                                 {"torsion", units::kNewtonMetre, pair.torsion}});
    return fields;
  });
}

/// Muscles of human hands that pull at some instant.
Table muscle_table(const SceneResult& scene) {
  Table table{{"muscle", "tension_N", "largest_N", "activation"}};
  for (const PullMeasure& muscle : scene.measures.pulls.muscles) {
    if (!muscle.contracts && muscle.tension.isZero(0)) continue;
    table.add({muscle.name, shown(muscle.tension.tail<1>()[0]), shown(muscle.tension.maxCoeff()),
               muscle.contracts ? shown(muscle.activation.tail<1>()[0]) : ""});
  }
  return table;
}

std::vector<Fields> muscle_fields(const SceneResult& scene) {
  return fields_of_each(scene.measures.pulls.muscles, [&](const PullMeasure& muscle) {
    Fields fields{{"muscle", muscle.name},
                  {"tension", units::kNewton, muscle.tension.tail<1>()[0]},
                  {"largest_tension", units::kNewton, muscle.tension.maxCoeff()}};
    if (!muscle.contracts) return fields;
    fields.add("excitation", muscle.excitation.tail<1>()[0]);
    fields.add("activation", muscle.activation.tail<1>()[0]);
    return fields;
  });
}

/// [J]
OrderedJson energy_json(const SceneEnergy& energy) {
  return {{"kinetic", energy.kinetic},
          {"weight", energy.weight},
          {"springs", energy.springs},
          {"total", energy.total()}};
}

/// The worst residual of its contact problems.
std::string residual_words(const SceneResult& scene) {
  return has_contact_problems(scene) ? fmt::format("{:.2g}", scene.run.cost.worst_residual) : "n/a";
}

/// Energy losses [J]; null if they are unknown.
OrderedJson losses_json(const SceneResult& scene) {
  if (!scene.measures.balance) return nullptr;
  const FlowBalance& balance = *scene.measures.balance;
  return {
      {"friction", balance.friction}, {"impacts", balance.impacts}, {"dampers", balance.yielding}};
}

/// Status, energy and cost of a run.
Fields outcome_fields(const SceneResult& scene) {
  // Energy balances only where the method keeps account of it.
  const SceneCost& cost = scene.run.cost;
  const std::string& reason = scene.run.message;
  const std::optional<FlowBalance>& worst = scene.measures.worst;
  return {{"status", name_of(scene.run.status)},
          {"reason", reason.empty() ? OrderedJson() : OrderedJson(reason)},
          {"simulated", units::kSecond, simulated_seconds(scene)},
          {"largest_slip", units::kMetre, largest_slip(scene)},
          {"largest_penetration", units::kMetre, cost.max_penetration},
          {"energy_start", units::kJoule, energy_json(scene.run.samples.front().energy)},
          {"energy_end", units::kJoule, energy_json(scene.run.samples.back().energy)},
          {"work", units::kJoule, scene.measures.work},
          {"dissipated", units::kJoule, scene.measures.dissipated},
          {"dissipated_by", units::kJoule, losses_json(scene)},
          {"energy_error", units::kJoule, worst ? worst->error : kNaN},
          {"energy_turned_over", units::kJoule, worst ? worst->turned_over : kNaN},
          {"energy_error_share", worst ? worst->relative_error() : kNaN},
          {"energy_error_at", units::kSecond, worst ? worst->t : kNaN},
          {"limits_passed", limit_fields(limits_passed(scene))},
          {"restitution_ignored", restitution_ignored(scene)},
          {"steps", cost.steps},
          {"rejected_steps", cost.rejected},
          {"substeps", cost.substeps},
          {"impacts", cost.impacts},
          {"unsolved", cost.unsolved},
          {"leaps", cost.tunnelling_steps},
          {"coarse_steps", cost.inaccurate_steps},
          {"worst_residual", has_contact_problems(scene) ? cost.worst_residual : kNaN},
          {"asleep", units::kSecond, cost.rest_time},
          {"cpu_s_per_simulated_s", units::kMeasuredSeconds, cpu_per_second(scene)}};
}

/// "friction 0.5, step 0.001": the numbers of a run that are not as in the file.
std::string varied_words(const SceneResult& scene) {
  return each_in_words(scene.varied, [](const auto& each) {
    return fmt::format("{} {:g}", each.first, each.second);
  });
}

}  // namespace

std::string method_of(const SceneResult& scene) {
  return name_in(kSteppingMethodNames, scene.built->options.method);
}

std::string text_of(const SceneResult& scene) {
  // Bodies and contacts first, then the account of energy and the cost.
  const SceneCost& cost = scene.run.cost;
  const SceneEnergy &start = scene.run.samples.front().energy,
                    &end = scene.run.samples.back().energy;
  std::string text = fmt::format("{}: {} after {:.6g} s\nmethod: {}, {} steps, {} impacts\n\n",
                                 scene.name, name_of(scene.run.status), simulated_seconds(scene),
                                 method_of(scene), cost.steps, cost.impacts);
  text += titled("Bodies at the end (centres of mass)", body_table(scene));
  text += titled("Pairs that touched (slip: distance slid)", pair_table(scene));
  if (const Table patches = patch_table(scene); !patches.rows.empty())
    text += titled("Patches of pads at the end", patches);
  if (!scene.measures.pulls.muscles.empty())
    text += titled("Tendons at the end (under a net with the 20 mN that keep it taut)",
                   muscle_table(scene));
  // The account closes if start + work = end + dissipated.
  text += fmt::format(
      "energy {:.6g} mJ at the start, {:.6g} mJ at the end, work of forces and "
      "drives {:.6g} mJ, dissipated {:.3g} mJ\n",
      1e3 * start.total(), 1e3 * end.total(), 1e3 * scene.measures.work,
      1e3 * scene.measures.dissipated);
  for (const std::vector<std::string>& row : account_table(scene).rows)
    text += fmt::format("{}: {}\n", row[0], row[1]);
  if (!passive_moments(scene).is_null()) text += "passive moments of human joints are counted\n";
  text += fmt::format("worst residual of a contact problem {}\n", residual_words(scene));
  return text + fmt::format("CPU {:.3g} ms per simulated second\n", 1e3 * cpu_per_second(scene));
}

Fields fields_of(const SceneResult& scene) {
  Fields fields{{"scene", scene.name},
                {"description", scene.description},
                {"method", method_of(scene)},
                {"instants", scene.run.samples.size()}};
  fields.append(outcome_fields(scene));
  fields.add("bodies", body_fields(scene));
  fields.add("coordinates", coordinate_fields(scene));
  if (OrderedJson passive = passive_moments(scene); !passive.is_null())
    fields.add("passive_moment", units::kNewtonMetre, std::move(passive));
  fields.add("pairs", pair_fields(scene));
  if (!scene.measures.pulls.muscles.empty()) {
    fields.add("tendon_paths", asked_paths(scene.request.path));
    fields.add("muscles", muscle_fields(scene));
  }
  fields.add("warnings", scene.outcome.warnings);
  return fields;
}

Table table_of(const SceneResult& scene) {
  const std::vector<std::size_t> moving = scene.measures.moving;
  Table table{{"time_s", "kinetic_J", "weight_J", "springs_J", "contacts"}};
  for (const std::size_t body : moving)
    for (const char* axis : {"x", "y", "z"})
      table.header.push_back(
          fmt::format("{}_{}_m", scene.built->scene.mechanism.bodies[body].name, axis));
  for (std::size_t i = 0; i < scene.run.samples.size(); ++i) {
    const SceneSample& sample = scene.run.samples[i];
    std::vector<std::string> cells;
    for (const double value :
         {sample.t, sample.energy.kinetic, sample.energy.weight, sample.energy.springs})
      cells.push_back(fmt::format("{:.12g}", value + 0.0));
    cells.push_back(std::to_string(sample.contacts.size()));
    for (const std::size_t body : moving)
      for (const double value : centre(scene, i, body))
        cells.push_back(fmt::format("{:.12g}", value + 0.0));
    table.add(std::move(cells));
  }
  return table;
}

std::string text_of(const SceneSweepResult& sweep) {
  return fmt::format("{}: {} of {} runs\n\n", sweep.name, sweep.outcome.done, sweep.outcome.asked) +
         aligned(table_of(sweep));
}

Fields fields_of(const SceneSweepResult& sweep) {
  std::vector<Fields> runs;
  for (const SceneResult& scene : sweep.runs) {
    Fields varied;
    for (const auto& [name, value] : scene.varied) varied.add(name, value);
    Fields& run = runs.emplace_back(Fields{{"varied", std::move(varied)}});
    run.append(outcome_fields(scene));
    run.add("bodies", body_fields(scene));
    run.add("pairs", pair_fields(scene));
  }
  return {{"scene", sweep.name},
          {"asked", sweep.outcome.asked},
          {"runs", std::move(runs)},
          {"warnings", sweep.outcome.warnings}};
}

Table table_of(const SceneSweepResult& sweep) {
  Table table{row(
      {names_of(sweep.request.vary),
       {"status", "simulated_s", "largest_slip_mm", "penetration_mm", "end_energy_mJ",
        "dissipated_mJ", "energy_error_%", "limits_passed", "worst_residual", "cpu_ms_per_s"}})};
  for (const SceneResult& scene : sweep.runs) {
    const auto value = [](const auto& each) { return fmt::format("{:.6g}", each.second); };
    const SceneRun& run = scene.run;
    const RunMeasures& measures = scene.measures;
    table.add_parts(
        {transformed(scene.varied, value),
         {name_of(run.status), shown(simulated_seconds(scene)), shown(largest_slip(scene) / kMm),
          shown(run.cost.max_penetration / kMm), shown(1e3 * run.samples.back().energy.total()),
          shown(1e3 * measures.dissipated),
          measures.worst ? shown(100 * measures.worst->relative_error()) : "n/a",
          std::to_string(limits_passed(scene).size()), residual_words(scene),
          shown(1e3 * cpu_per_second(scene))}});
  }
  return table;
}

std::string refusal_of(const SceneSweepResult& sweep) {
  for (const SceneResult& scene : sweep.runs)
    if (const std::string refusal = refusal_of(scene); !refusal.empty())
      return fmt::format("at {}: {}", varied_words(scene), refusal);
  return "";
}

}  // namespace thenar
