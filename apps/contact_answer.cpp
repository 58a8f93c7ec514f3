#include "apps/contact_answer.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"
#include "grasp/contact/contact.h"
#include "grasp/contact/friction_pyramid.h"
#include "grasp/limits/wrench_support.h"
#include "grasp/quality/planar_grasp.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {
namespace {

constexpr double kPolytopeGap = 1e-10;  // of the largest wrench: exact at little cost [1]
constexpr double kNothing = 1e-9;       // a load below this part of the largest wrench is none [1]

bool is_polytope(const WrenchSet& set) {
  return std::all_of(set.caps.begin(), set.caps.end(),
                     [](const WrenchCap& cap) { return cap.A.cols() == 0; });
}

double largest_wrench_norm(const WrenchSet& set) {
  double largest = 0;
  for (const WrenchCap& cap : set.caps) largest = std::max(largest, cap.c.norm());
  return largest;
}

/// Caps with their friction axes turned about the normals: other first edges of pyramids.
void turn(WrenchSet& set, double angle) {
  for (WrenchCap& cap : set.caps) {
    if (cap.A.cols() < 2) continue;
    const ScaledWrench a = cap.A.col(0), b = cap.A.col(1);
    cap.A.col(0) = std::cos(angle) * a + std::sin(angle) * b;
    cap.A.col(1) = std::cos(angle) * b - std::sin(angle) * a;
  }
}

/// Numbers of contact_regions that share a limit, one a contact of the file. Wrenches have no
/// place.
std::vector<int> regions_of(const ContactFile& file) {
  std::vector<Contact> contacts;
  int fresh = 0;  // a patch that nobody has
  for (const FileContact& each : file.contacts) fresh = std::max(fresh, each.contact.patch + 1);
  for (const FileContact& each : file.contacts) {
    contacts.push_back(each.contact);
    int& patch = contacts.back().patch;
    if (patch < 0 && !each.wrenches.empty()) patch = fresh++;
  }
  return contact_regions(contacts);
}

WrenchSet cones_of(const ContactFile& file, const Contact& contact,
                   const ContactQuestion& question) {
  if (file.planar) return planar_wrench_set({contact}, file.centre_of_mass, file.torque_scale);
  WrenchSet set = wrench_set({contact}, file.centre_of_mass, file.torque_scale);
  if (question.edges == 0) return set;
  turn(set, question.first_edge * kDegree);
  return pyramids(set, question.edges);
}

/// Wrenches of a file: its cones or their pyramids, and generators where they are given.
WrenchSet wrenches_of(const ContactFile& file, const ContactQuestion& question) {
  const std::vector<int> region = regions_of(file);
  WrenchSet set;
  for (std::size_t i = 0; i < file.contacts.size(); ++i) {
    const FileContact& contact = file.contacts[i];
    for (const ScaledWrench& wrench : contact.wrenches) set.caps.push_back({wrench, {}, region[i]});
    if (!contact.wrenches.empty()) continue;
    for (WrenchCap& cap : cones_of(file, contact.contact, question).caps) {
      cap.contact = region[i];
      set.caps.push_back(std::move(cap));
    }
  }
  return set;
}

double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Epsilon epsilon_of(const WrenchSet& set, const ContactFile& file, const ContactQuestion& question) {
  if (file.planar) return planar_epsilon(set, question.limit);
  EpsilonOptions wanted;
  wanted.limit = question.limit;
  wanted.gap = question.gap;
  const double sharp = kPolytopeGap * largest_wrench_norm(set);
  if (is_polytope(set) && sharp > 0) wanted.gap = std::min(question.gap, sharp);
  Epsilon found = epsilon(set, wanted);
  found.converged = found.upper - found.lower <= question.gap;
  return found;
}

std::optional<Volume> volume_of(const WrenchSet& set, const ContactFile& file,
                                const ContactQuestion& question) {
  if (!question.volume || file.planar) return {};
  VolumeOptions options;
  options.limit = question.limit;
  return volume(set, options);
}

/// Of a plane the columns n and t, and the rows f_x, f_y and torque.
Eigen::MatrixXd planar_matrix(const std::vector<Contact>& contacts, const ContactFile& file) {
  Eigen::MatrixXd G(3, 0);
  for (const Contact& contact : contacts) {
    const Eigen::Vector3d arm = (contact.p - file.centre_of_mass) / file.torque_scale;
    const auto add = [&](const Eigen::Vector3d& f) {
      G.conservativeResize(3, G.cols() + 1);
      G.rightCols(1) << f.x(), f.y(), arm.cross(f).z();
    };
    add(contact.n);
    if (contact.friction > 0) add({-contact.n.y(), contact.n.x(), 0});
  }
  return G;
}

std::optional<GraspMatrixMeasures> matrix_of(const ContactFile& file) {
  std::vector<Contact> contacts;
  for (const FileContact& each : file.contacts) {
    if (!each.wrenches.empty()) return {};
    contacts.push_back(each.contact);
  }
  if (file.planar) return grasp_matrix_measures(planar_matrix(contacts, file));
  return grasp_matrix_measures(grasp_matrix(contacts, file.centre_of_mass, file.torque_scale));
}

/// Each load by itself; the margin is the least of them.
TaskAnswer answer_loads(const ForceSet& forces, const std::vector<ScaledWrench>& loads,
                        double largest) {
  TaskAnswer found{{Status::kSolved, kInfinity, kInfinity, ScaledWrench::Zero(), 0}, {}};
  for (const ScaledWrench& load : loads) {
    if (load.isZero(0)) {
      found.squeezes.push_back(0);
      continue;
    }
    const WrenchSupport reach = load_margin(forces, load);
    found.margin.residual = max_or_nan(found.margin.residual, reach.residual);
    if (reach.status != Status::kSolved) {
      found.squeezes.push_back(std::numeric_limits<double>::quiet_NaN());
      found.margin.status = reach.status;
      continue;
    }
    const double k = reach.value * load.norm() < kNothing * largest ? 0 : reach.value;
    found.squeezes.push_back(1 / k);
    if (k < found.margin.lower) found.margin.worst_load = load;
    found.margin.lower = std::min(found.margin.lower, k);
    found.margin.upper = std::min(found.margin.upper, k == 0 ? 0 : reach.bound);
  }
  return found;
}

std::optional<TaskAnswer> task_of(const WrenchSet& set, const ContactFile& file,
                                  const ContactQuestion& question) {
  if (file.task.kind == FileTask::Kind::kNone) return {};
  std::vector<ScaledWrench> loads = file.task.loads;
  for (ScaledWrench& load : loads) load.tail<3>() /= file.torque_scale;
  const ForceSet forces = unit_forces(set, question.limit);
  TaskAnswer found;
  if (set.caps.empty()) {
    found.margin = {Status::kSolved, 0, 0, loads[0], 0};
    if (file.task.kind == FileTask::Kind::kLoads) found.squeezes.assign(loads.size(), kInfinity);
  } else if (file.task.kind == FileTask::Kind::kLoads) {
    found = answer_loads(forces, loads, largest_wrench_norm(set));
  } else if (file.task.kind == FileTask::Kind::kBox) {
    found.margin = margin_of_box(forces, loads[0], loads[1]);
  } else {
    Eigen::Matrix<double, 6, Eigen::Dynamic> axes(6, static_cast<Eigen::Index>(loads.size()));
    for (std::size_t i = 0; i < loads.size(); ++i)
      axes.col(static_cast<Eigen::Index>(i)) = loads[i];
    found.margin = margin_of_ellipsoid(forces, axes);
  }
  // Below this nothing is borne, but for the programmes' rounding.
  const double none =
      kNothing * largest_wrench_norm(set) / std::max(found.margin.worst_load.norm(), 1e-300);
  if (found.margin.upper < none) found.margin.lower = found.margin.upper = 0;
  found.margin.worst_load.tail<3>() *= file.torque_scale;
  return found;
}

/// Without minus zeros.
OrderedJson plain(const ScaledWrench& w) {
  return to_json(ScaledWrench((w.array() + 0.0).matrix()));
}

/// Of a plane f_x, f_y and the torque.
OrderedJson wrench_json(const ScaledWrench& w, bool planar) {
  return planar ? OrderedJson{w(0) + 0.0, w(1) + 0.0, w(5) + 0.0} : plain(w);
}

/// Null where there is none.
OrderedJson finite(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

OrderedJson task_json(const TaskAnswer& task, bool planar) {
  const bool known = task.margin.status == Status::kSolved;
  OrderedJson squeezes = OrderedJson::array();
  for (const double squeeze : task.squeezes) squeezes.push_back(finite(squeeze));
  return {{"margin",
           {{"lower", known ? finite(task.margin.lower) : OrderedJson(nullptr)},
            {"upper", known ? finite(task.margin.upper) : OrderedJson(nullptr)}}},
          {"squeeze_N", known ? finite(1 / task.margin.lower) : OrderedJson(nullptr)},
          {"squeezes_N", squeezes},
          {"worst_load", wrench_json(task.margin.worst_load, planar)},
          {"solved", known},
          {"residual", task.margin.residual}};
}

OrderedJson matrix_json(const GraspMatrixMeasures& m) {
  return {{"rank", m.rank},
          {"least_singular_value", m.min_singular_value},
          {"isotropy", m.isotropy},
          {"volume", m.volume},
          {"internal_forces", m.internal_forces}};
}

std::string matrix_words(const GraspMatrixMeasures& m) {
  return fmt::format(
      "least singular value {:.4g}, isotropy {:.4g}, volume {:.4g}, {} internal force{}",
      m.min_singular_value, m.isotropy, m.volume, m.internal_forces,
      m.internal_forces == 1 ? "" : "s");
}

std::string task_words(const TaskAnswer& task, bool planar) {
  if (task.margin.status != Status::kSolved) return "the programme did not end";
  if (task.margin.upper == 0)
    return fmt::format("not withstood: nothing holds {}",
                       json_text(wrench_json(task.margin.worst_load, planar), -1));
  if (std::isinf(task.margin.lower)) return "no load";
  return fmt::format("needs normal forces of {:.6g} N, most for {}", 1 / task.margin.lower,
                     json_text(wrench_json(task.margin.worst_load, planar), -1));
}

std::string words(const ScaledWrench& w, bool planar) {
  if (planar)
    return fmt::format("force ({}), torque / scale {}", fmt::join(cells(w.head<2>(), 4), ", "),
                       fmt::join(cells(w.tail<1>(), 4), ", "));
  return fmt::format("force ({}), torque / scale ({})", fmt::join(cells(w.head<3>(), 4), ", "),
                     fmt::join(cells(w.tail<3>(), 4), ", "));
}

std::string enclosed(double lower, double upper) {
  return fmt::format("between {:.6g} and {:.6g}", lower, upper);
}

std::string volume_words(const Volume& v) {
  if (!v.complete) return fmt::format("at least {:.6g}: too many facets or faces", v.lower);
  if (v.lower == v.upper) return fmt::format("{:.6g}", v.estimate);
  return fmt::format("about {:.6g}, {}", v.estimate, enclosed(v.lower, v.upper));
}

}  // namespace

ContactAnswer answer(const ContactFile& file, const ContactQuestion& question) {
  require(!file.planar || question.edges == 0, "pyramids are of cones in space, not in a {}",
          "plane");
  const std::clock_t start = std::clock();
  const WrenchSet set = wrenches_of(file, question);
  ContactAnswer found{};
  found.epsilon = epsilon_of(set, file, question);
  found.epsilon_cpu = seconds_since(start);
  const std::clock_t middle = std::clock();
  found.volume = volume_of(set, file, question);
  found.volume_cpu = seconds_since(middle);
  found.grasp_matrix = matrix_of(file);
  found.task = task_of(set, file, question);
  return found;
}

OrderedJson json_of(const std::string& path, const ContactFile& file, const ContactAnswer& answer) {
  const Epsilon& e = answer.epsilon;
  OrderedJson missing, bounds, complete, volume;
  if (e.has_missing_direction) missing = wrench_json(e.missing_direction, file.planar);
  if (answer.volume) {
    const Volume& v = *answer.volume;
    if (v.complete) volume = v.estimate;
    bounds = {{"lower", v.lower}, {"upper", v.upper}};
    complete = v.complete;
  }
  return {{"epsilon", {{"lower", e.lower + 0.0}, {"upper", e.upper + 0.0}}},
          {"volume", volume},
          {"force_closure", e.force_closure},
          {"rank", e.rank},
          {"missing_direction", missing},
          {"worst_wrench", wrench_json(e.worst_wrench, file.planar)},
          {"cpu_s", answer.epsilon_cpu + answer.volume_cpu},
          {"epsilon_cpu_s", answer.epsilon_cpu},
          {"volume_bounds", bounds},
          {"volume_complete", complete},
          {"converged", e.converged},
          {"grasp_matrix",
           answer.grasp_matrix ? matrix_json(*answer.grasp_matrix) : OrderedJson(nullptr)},
          {"task", answer.task ? task_json(*answer.task, file.planar) : OrderedJson(nullptr)},
          {"planar", file.planar},
          {"file", path},
          {"warnings", file.warnings}};
}

std::string text_of(const std::string& path, const ContactFile& file, const ContactAnswer& answer) {
  const Epsilon& e = answer.epsilon;
  std::string text = fmt::format("{}: {} contacts, torques divided by {} m\n", path,
                                 file.contacts.size(), shown(file.torque_scale));
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<18}{}\n", name, value);
  };
  line("force closure", e.force_closure ? "yes" : "no");
  line("epsilon", enclosed(e.lower, e.upper) + (e.converged ? "" : " (gave up early)"));
  if (answer.volume) line("volume", volume_words(*answer.volume));
  line("rank", fmt::format("{} of {}", e.rank, file.planar ? 3 : 6));
  if (e.has_missing_direction) line("cannot make", words(e.missing_direction, file.planar));
  line(e.has_missing_direction ? "not withstood" : "withstood least",
       words(e.worst_wrench, file.planar));
  if (answer.grasp_matrix) line("grasp matrix", matrix_words(*answer.grasp_matrix));
  if (answer.task) line("task", task_words(*answer.task, file.planar));
  for (const std::string& warning : file.warnings) line("warning", warning);
  return text;
}

}  // namespace thenar
