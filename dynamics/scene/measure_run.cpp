#include "dynamics/scene/measure_run.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/scene/pair_slip.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/scene_state.h"

namespace thenar {
namespace {

using Poses = std::vector<Pose<double>>;
using Pair = std::pair<int, int>;

/// Adds the contacts of a sample to the measures of their pairs.
/// @param last  true for the last sample, whose forces and modes are kept
void add_contacts(const SceneSample& sample, bool last, std::map<Pair, PairMeasure>& pairs) {
  std::map<Pair, double> normal;
  // First and last contact of each pair, and its normal force.
  for (const ContactSample& contact : sample.contacts) {
    const auto [at, is_new] = pairs.try_emplace({contact.a, contact.b});
    PairMeasure& pair = at->second;
    if (is_new) {
      pair.a = contact.a;
      pair.b = contact.b;
      pair.first = sample.t;
    }
    pair.last = sample.t;
    normal[at->first] += contact.force.dot(contact.normal);
    // Sum forces and patches of the last sample; a pair slides if any point does.
    if (!last) continue;
    pair.force += contact.force;
    pair.area += contact.area;
    if (contact.area > 0) {
      pair.stick = contact.stick;
      pair.torsion = contact.torsion;
    }
    ++pair.points;
    if (contact.mode == ContactMode::kSlide || pair.mode == ContactMode::kOpen)
      pair.mode = contact.mode;
  }
  // Update the largest normal force.
  for (const auto& [pair, force] : normal)
    pairs[pair].largest_force = std::max(pairs[pair].largest_force, force);
}

/// Returns the work of a drive from `begin` to `end`, within the interval between two samples [J],
/// by three-point Gauss quadrature on the cubic Hermite interpolation of its coordinate.
double drive_work_within(const SceneDrive& drive, const MechanismLayout& layout,
                         const SceneSample& from, const SceneSample& to, double begin, double end) {
  // Coefficients of the cubic.
  const int q = layout.coordinate_q[drive.coordinate], v = layout.coordinate_v[drive.coordinate];
  const double span = to.t - from.t, mean_rate = (to.q[q] - from.q[q]) / span;
  const double cubic = from.v[v] + to.v[v] - 2 * mean_rate;
  const double quadratic = 3 * mean_rate - 2 * from.v[v] - to.v[v];
  const double nodes[] = {-std::sqrt(0.6), 0, std::sqrt(0.6)}, weights[] = {5.0, 8.0, 5.0};
  // Integrate the power.
  double work = 0;
  for (int k = 0; k < 3; ++k) {
    const double t = 0.5 * (begin + end + nodes[k] * (end - begin)), s = (t - from.t) / span;
    const double u = from.q[q] + span * s * (from.v[v] + s * (quadratic + s * cubic));
    const double rate = from.v[v] + s * (2 * quadratic + 3 * s * cubic);
    work += weights[k] / 18 * (end - begin) * rate * drive_effort(drive, u, rate, t, begin);
  }
  return work;
}

/// Returns the work of a drive between two samples [J], while it acts.
double drive_work(const SceneDrive& drive, const MechanismLayout& layout, const SceneSample& from,
                  const SceneSample& to) {
  double begin = std::max(from.t, drive.when.from), work = 0;
  const double end = std::min(to.t, drive.when.to);
  // Split the interval at the knots of the target table.
  while (begin < end) {
    double part_end = end;
    if (drive.table) {
      const double* const first = drive.table->time.data();
      const double* const last = first + drive.table->time.size();
      const double* const knot = std::upper_bound(first, last, begin);
      if (knot != last) part_end = std::min(end, *knot);
    }
    work += drive_work_within(drive, layout, from, to, begin, part_end);
    begin = part_end;
  }
  return work;
}

/// Returns the work of forces and drives between two samples [J].
double work_between(const MovingScene& scene, const MechanismLayout& layout,
                    const SceneSample& from, const SceneSample& to, const Poses& X_from,
                    const Poses& X_to) {
  const double middle = 0.5 * (from.t + to.t);
  double work = 0;
  // Work of forces by the displacement of their points, of moments by the rotation.
  for (const SceneForce& force : scene.forces) {
    if (!force.when.contains(middle)) continue;
    const int i = force.body;
    const Eigen::AngleAxisd turn(X_to[i].R * X_from[i].R.transpose());
    work += force.force.dot(X_to[i] * force.point - X_from[i] * force.point) +
            force.moment.dot(turn.angle() * turn.axis());
  }
  for (const SceneDrive& drive : scene.drives) work += drive_work(drive, layout, from, to);
  return work;
}

/// Returns the sample with its contacts, without forces: the initial sample comes before any step
/// and has none.
SceneSample with_contacts(const SceneSample& sample, ContactStep& step) {
  std::vector<ActiveContact> found;
  step.find_contacts({sample.t, sample.q, sample.v, sample.z}, SceneOptions().touch, found);
  SceneSample out = sample;
  for (const ActiveContact& contact : found) {
    if (contact.kind == ActiveContact::Kind::kContact)
      out.contacts.push_back({contact.a, contact.b, contact.id, contact.point, contact.normal});
  }
  return out;
}

/// Collects the inputs of slips_between() at an instant.
SlipInstant slip_instant(const MovingScene& scene, const TreeModel& model, const SceneSample& at,
                         const Poses& X_WB) {
  SlipInstant out{at.t, at.contacts, X_WB, {}, body_velocities(scene.mechanism, model, at.q, at.v)};
  for (std::size_t i = 0; i < X_WB.size(); ++i)
    out.centre.push_back(X_WB[i] * scene.mechanism.bodies[i].mass.com);
  return out;
}

/// Sets the mode of frictionless pairs that slide at the end: their contacts have no tangential
/// rows from which the stepper could tell. Pads report their own mode.
void set_frictionless_modes(const MovingScene& scene, const SlipInstant& last,
                            std::map<Pair, PairMeasure>& pairs) {
  constexpr double kRestSpeed = 1e-9;  // largest sliding speed at rest [m/s]
  for (const ContactSample& contact : last.contacts)
    if (contact.mode == ContactMode::kStick && contact.area == 0 &&
        pair_friction(scene, contact.a, contact.b).coefficient == 0 &&
        sliding_speed(last, contact) > kRestSpeed)
      pairs[{contact.a, contact.b}].mode = ContactMode::kSlide;
}

}  // namespace

std::vector<SceneVelocity> body_velocities(const Mechanism& mechanism, const TreeModel& model,
                                           const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  // Compute the motion of the links.
  TreeMotion<double> motion(model);
  motion.set_position(q);
  motion.set_speed(v);
  std::vector<SceneVelocity> out(mechanism.bodies.size());
  // Take the velocity of each centre of mass.
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int link = model.bodies[i].link;
    if (link < 0) continue;
    const Eigen::Vector3d centre = motion.pose(static_cast<int>(i)) * mechanism.bodies[i].mass.com;
    out[i] = {motion.velocity(link, centre), motion.links()[link].w};
  }
  return out;
}

std::vector<std::size_t> moving_bodies(const Mechanism& mechanism, const TreeModel& model) {
  std::vector<std::size_t> moving;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const MechanismBody& body = mechanism.bodies[i];
    if (model.bodies[i].link >= 0 && (body.mass.mass > 0 || body.solid)) moving.push_back(i);
  }
  return moving;
}

RunMeasures measure_run(const MovingScene& scene, const SceneRun& run) {
  RunMeasures out;
  if (run.samples.empty()) return out;
  // Poses of the bodies in all samples.
  ContactStep step(scene);
  out.X_WB.resize(run.samples.size());
  for (std::size_t k = 0; k < run.samples.size(); ++k)
    step.compute_poses({run.samples[k].t, run.samples[k].q, run.samples[k].v}, out.X_WB[k]);
  const MechanismLayout& layout = step.model().layout;
  out.moving = moving_bodies(scene.mechanism, step.model());
  const bool has_flows = run.samples.back().w.size() > 0;
  // Contacts and slip of the pairs, and work if the run has no energy flows.
  std::map<Pair, PairMeasure> pairs;
  SlipInstant before = slip_instant(scene, step.model(), run.samples.front(), out.X_WB.front());
  for (std::size_t k = 0; k < run.samples.size(); ++k) {
    add_contacts(run.samples[k], k + 1 == run.samples.size(), pairs);
    if (k == 0) continue;
    const SceneSample &from = run.samples[k - 1], &to = run.samples[k];
    if (k == 1 && from.contacts.empty()) before.contacts = with_contacts(from, step).contacts;
    SlipInstant now = slip_instant(scene, step.model(), to, out.X_WB[k]);
    for (const auto& [pair, slip] : slips_between(before, now)) pairs[pair].slip += slip;
    before = std::move(now);
    if (!has_flows) out.work += work_between(scene, layout, from, to, out.X_WB[k - 1], out.X_WB[k]);
  }
  // Modes, velocities and muscles.
  set_frictionless_modes(scene, before, pairs);
  for (const auto& [bodies, pair] : pairs) out.pairs.push_back(pair);
  out.velocity = std::move(before.velocity);  // velocities in the last sample
  out.pulls = measure_pulls(scene, run);
  // Work and dissipation from the energy flows, or dissipation from the balance.
  if (has_flows) {
    out.balance = flow_balance(run.samples.front(), run.samples.back());
    out.worst = worst_balance(run.samples);
    out.work = out.balance->work;
    out.dissipated = out.balance->dissipated();
    return out;
  }
  out.dissipated =
      run.samples.front().energy.total() + out.work - run.samples.back().energy.total();
  return out;
}

}  // namespace thenar
