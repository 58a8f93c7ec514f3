#include "api/scenes/write_scene_run.h"

#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "api/named/result_origin.h"
#include "api/scenes/scene_account.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/rung_names.h"
#include "data/io/result_file.h"
#include "dynamics/stepping/limit_excess.h"

namespace thenar {
namespace {

/// An array of three dimensions, filled by at(i, j, k).
template <typename At>
ResultArray cube(std::size_t a, std::size_t b, std::size_t c, const std::string& unit,
                 const std::vector<std::string>& labels, const At& at) {
  ResultArray array{{}, {a, b, c}, unit, labels};
  array.values.reserve(a * b * c);
  for (std::size_t i = 0; i < a; ++i)
    for (std::size_t j = 0; j < b; ++j)
      for (std::size_t k = 0; k < c; ++k) array.values.push_back(at(i, j, k));
  return array;
}

/// Names of the entries of positions or of speeds.
std::vector<std::string> entry_names(const Mechanism& mechanism, bool positions) {
  // Coordinates of joints have their own names.
  const MechanismLayout layout = layout_of(mechanism);
  std::vector<std::string> names(static_cast<std::size_t>(positions ? layout.q : layout.v));
  for (std::size_t c = 0; c < mechanism.coordinates.size(); ++c)
    names[static_cast<std::size_t>(positions ? layout.coordinate_q[c] : layout.coordinate_v[c])] =
        mechanism.coordinates[c].name;
  // Poses are a quaternion and a place, speeds a spin and a velocity.
  static const std::vector<std::string> kPose{"qw", "qx", "qy", "qz", "x", "y", "z"};
  static const std::vector<std::string> kTwist{"wx", "wy", "wz", "vx", "vy", "vz"};
  for (const int i : layout.quaternion_joints) {
    const auto first = static_cast<std::size_t>(positions ? layout.first_q[i] : layout.first_v[i]);
    const std::vector<std::string>& parts = positions ? kPose : kTwist;
    const std::size_t count = parts.size() - (mechanism.joints[i].kind == JointKind::kBall ? 3 : 0);
    for (std::size_t k = 0; k < count; ++k)
      names[first + k] = mechanism.bodies[i].name + "/" + parts[k];
  }
  return names;
}

/// Positions, speeds, poses and energies of every instant.
void add_instants(const SceneResult& scene, const std::string& group, ResultFile& file) {
  const std::vector<SceneSample>& samples = scene.run.samples;
  const std::vector<std::vector<Pose<double>>>& X = scene.measures.X_WB;
  // Fill the tables row by row.
  const auto count = static_cast<Eigen::Index>(samples.size());
  const std::size_t bodies = scene.built->scene.mechanism.bodies.size();
  Eigen::VectorXd time(count);
  Eigen::MatrixXd q(count, scene.built->scene.q.size()), v(count, scene.built->scene.v.size());
  Eigen::MatrixXd energy(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const SceneSample& sample = samples[static_cast<std::size_t>(i)];
    time[i] = sample.t;
    q.row(i) = sample.q;
    v.row(i) = sample.v;
    energy.row(i) << sample.energy.kinetic, sample.energy.weight, sample.energy.springs;
  }
  // Name the axes of each table, as netCDF does.
  file.add(group + "time", time, "s", {"instant"});
  file.add(group + "position", q, "SI", {"instant", "position_entry"});
  file.add(group + "speed", v, "SI", {"instant", "speed_entry"});
  file.add(group + "energy", energy, "J", {"instant", "energy_part"});
  file.arrays[group + "body_position"] =
      cube(samples.size(), bodies, 3, "m", {"instant", "body", "axis"},
           [&](std::size_t i, std::size_t b, std::size_t k) {
             return X[i][b].p[static_cast<Eigen::Index>(k)];
           });
  file.arrays[group + "body_rotation"] =
      cube(samples.size(), bodies, 4, "1", {"instant", "body", "quaternion"},
           [&](std::size_t i, std::size_t b, std::size_t k) {
             const Eigen::Quaterniond turn(X[i][b].R);
             const double wxyz[] = {turn.w(), turn.x(), turn.y(), turn.z()};
             return wxyz[k];
           });
}

/// States of elements, and what muscles do at every instant.
void add_elements(const SceneResult& scene, const std::string& group, ResultFile& file) {
  const std::vector<SceneSample>& samples = scene.run.samples;
  // Elements such as muscles and pads may have states of their own.
  if (samples.front().z.size() == 0) return;
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd z(count, samples.front().z.size());
  for (Eigen::Index i = 0; i < count; ++i) z.row(i) = samples[static_cast<std::size_t>(i)].z;
  file.add(group + "element_state", z, "SI", {"instant", "element_state_entry"});
  const std::vector<PullMeasure>& muscles = scene.measures.pulls.muscles;
  if (muscles.empty()) return;
  const auto add = [&](const char* key, const char* unit, Eigen::VectorXd PullMeasure::*of) {
    Eigen::MatrixXd table(count, static_cast<Eigen::Index>(muscles.size()));
    for (std::size_t m = 0; m < muscles.size(); ++m)
      table.col(static_cast<Eigen::Index>(m)) = muscles[m].*of;
    file.add(group + key, table, unit, {"instant", "muscle"});
  };
  add("tension", "N", &PullMeasure::tension);
  add("excitation", "1", &PullMeasure::excitation);
  add("activation", "1", &PullMeasure::activation);
  add("excursion", "m", &PullMeasure::excursion);
}

/// Contacts of all instants, one below the other.
void add_contacts(const SceneResult& scene, const std::string& group, ResultFile& file) {
  // List all contacts and their instants; a run without contacts has no such tables.
  std::vector<double> instants;
  std::vector<const ContactSample*> contacts;
  for (std::size_t i = 0; i < scene.run.samples.size(); ++i)
    for (const ContactSample& contact : scene.run.samples[i].contacts) {
      instants.push_back(static_cast<double>(i));
      contacts.push_back(&contact);
    }
  if (contacts.empty()) return;
  // Write one column for each number, and a table for each vector.
  const auto count = static_cast<Eigen::Index>(contacts.size());
  const auto add = [&](const char* key, const char* unit, auto ContactSample::*number) {
    Eigen::VectorXd column(count);
    for (Eigen::Index k = 0; k < count; ++k)
      column[k] = static_cast<double>(contacts[static_cast<std::size_t>(k)]->*number);
    file.add(group + key, column, unit, {"contact"});
  };
  const auto add_vectors = [&](const char* key, const char* unit,
                               Eigen::Vector3d ContactSample::*vector) {
    Eigen::MatrixXd table(count, 3);
    for (Eigen::Index k = 0; k < count; ++k)
      table.row(k) = contacts[static_cast<std::size_t>(k)]->*vector;
    file.add(group + key, table, unit, {"contact", "axis"});
  };
  const Eigen::VectorXd instant = Eigen::Map<const Eigen::VectorXd>(instants.data(), count);
  file.add(group + "contact_instant", instant, "1", {"contact"});
  add("contact_body_a", "1", &ContactSample::a);
  add("contact_body_b", "1", &ContactSample::b);
  add("contact_id", "1", &ContactSample::id);
  add("contact_mode", "1", &ContactSample::mode);
  add("contact_gap", "m", &ContactSample::gap);
  add("contact_torsion", "N m", &ContactSample::torsion);
  add_vectors("contact_point", "m", &ContactSample::point);
  add_vectors("contact_normal", "1", &ContactSample::normal);
  add_vectors("contact_force", "N", &ContactSample::force);
  add("contact_area", "m^2", &ContactSample::area);
  add("contact_stick", "1", &ContactSample::stick);
}

/// Energy that does not balance, and joints that went beyond their limits.
void add_account(const SceneResult& scene, const std::string& group, ResultFile& file) {
  // Keep the worst balance of energy, beside the energy that was turned over.
  if (const std::optional<FlowBalance>& worst = scene.measures.worst;
      worst && std::isfinite(worst->relative_error())) {
    file.add(group + "energy_error", worst->error, "J");
    file.add(group + "energy_turned_over", worst->turned_over, "J");
  }
  // List the joints that exceeded their limits.
  const std::vector<PassedLimit> limits = limits_passed(scene);
  if (limits.empty()) return;
  Eigen::MatrixXd table(static_cast<Eigen::Index>(limits.size()), 2);
  for (std::size_t i = 0; i < limits.size(); ++i)
    table.row(static_cast<Eigen::Index>(i)) << limits[i].excess, limits[i].slides ? 1 : 0;
  file.add(group + "name/limit", transformed(limits, &PassedLimit::joint));
  file.add(group + "limit_beyond", table.col(0), "SI", {"limit"});
  file.add(group + "limit_slides", table.col(1), "1", {"limit"});
}

/// Adds the outcome of a run: status, cost, energies and slip of pairs.
void add_outcome(const SceneResult& scene, const std::string& group, ResultFile& file) {
  // Write the status and the cost of the run.
  const SceneCost& cost = scene.run.cost;
  file.add(group + "status", name_of(scene.run.status));
  if (!scene.run.message.empty()) file.add(group + "reason", scene.run.message);
  file.add(group + "steps", static_cast<double>(cost.steps), "1");
  file.add(group + "unsolved", static_cast<double>(cost.unsolved), "1");
  if (has_contact_problems(scene)) file.add(group + "worst_residual", cost.worst_residual, "1");
  file.add(group + "deepest", cost.max_penetration, "m");
  file.add(group + "work", scene.measures.work, "J");
  file.add(group + "dissipated", scene.measures.dissipated, "J");
  add_account(scene, group, file);
  // Slip of each pair of bodies that touched.
  std::vector<std::string> names;
  Eigen::VectorXd slip(static_cast<Eigen::Index>(scene.measures.pairs.size()));
  const std::vector<MechanismBody>& bodies = scene.built->scene.mechanism.bodies;
  for (std::size_t k = 0; k < scene.measures.pairs.size(); ++k) {
    const PairMeasure& pair = scene.measures.pairs[k];
    names.push_back(bodies[static_cast<std::size_t>(pair.a)].name + " - " +
                    bodies[static_cast<std::size_t>(pair.b)].name);
    slip[static_cast<Eigen::Index>(k)] = pair.slip;
  }
  if (names.empty()) return;
  file.add(group + "name/pair", names);
  file.add(group + "slip", slip, "m", {"pair"});
}

/// Adds the names and settings that all runs of a scene share.
void add_names(const SceneResult& scene, ResultFile& file) {
  // Write names of bodies, coordinates and states beside the tables that they label.
  const Mechanism& mechanism = scene.built->scene.mechanism;
  file.add("format", kSceneRunFormat);
  file.add("scene", scene.name);
  file.add("name/body", names_of(mechanism.bodies));
  const auto add_some = [&](const char* key, const std::vector<std::string>& names) {
    if (!names.empty()) file.add(key, names);
  };
  add_some("name/position_entry", entry_names(mechanism, true));
  add_some("name/speed_entry", entry_names(mechanism, false));
  add_some("name/element_state_entry", element_state_names(scene.built->scene.elements));
  add_some("name/muscle", names_of(scene.measures.pulls.muscles));
  file.add("name/energy_part", std::vector<std::string>{"kinetic", "weight", "springs"});
  file.add("name/contact_mode", names_in(kContactModeNames));
  // The method and paths are needed to build the scene again.
  file.add("method", name_in(kSteppingMethodNames, scene.built->options.method));
  file.add("rungs/path", asked_paths(scene.request.path));
}

/// Adds the tables of one run. @param group  before their names
void add_run(const SceneResult& scene, const std::string& group, ResultFile& file) {
  add_instants(scene, group, file);
  add_elements(scene, group, file);
  add_contacts(scene, group, file);
  add_outcome(scene, group, file);
}

}  // namespace

void write_scene_run(const SceneResult& scene, const std::string& path, const RunRecord& run) {
  require(!scene.sources.empty(), "scene '{}' has no file, by which its run could be read again",
          scene.name);
  ResultFile file;
  add_names(scene, file);
  add_run(scene, "", file);
  add_origin(scene.sources, run, file);
  write_result(file, path);
}

void write_scene_sweep(const SceneSweepResult& sweep, const std::string& path,
                       const RunRecord& run) {
  // All runs share the names of the first, as only numbers vary.
  require(!sweep.runs.empty(), "no run was made: nothing to write");
  ResultFile file;
  add_names(sweep.runs.front(), file);
  const std::vector<std::string> varied = names_of(sweep.request.vary);
  file.add("varied", varied);
  Eigen::MatrixXd values(static_cast<Eigen::Index>(sweep.runs.size()),
                         static_cast<Eigen::Index>(varied.size()));
  // Each run has a group of its own, with the numbers that it was made with.
  for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
    const SceneResult& scene = sweep.runs[i];
    for (std::size_t k = 0; k < varied.size(); ++k)
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = scene.varied[k].second;
    add_run(scene, fmt::format("runs/{}/", i + 1), file);
  }
  file.add("value", values, "SI", {"run", "number"});
  add_origin(sweep.runs.front().sources, run, file);
  write_result(file, path);
}

}  // namespace thenar
