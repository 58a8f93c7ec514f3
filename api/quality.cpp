#include "api/quality.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <utility>

#include "api/contact_warnings.h"
#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "data/io/contact_file.h"
#include "grasp/contact/friction_pyramid.h"
#include "grasp/limits/wrench_support.h"
#include "grasp/quality/planar_grasp.h"
#include "grasp/quality/task_margin.h"

namespace thenar {
namespace {

// Most edges; finer pyramids take minutes and change nothing
constexpr int kMaxPyramidEdges = 1000;
// Gap of the bounds of a polytope's epsilon, over the largest wrench; it costs little [1]
constexpr double kPolytopeGap = 1e-10;
// Least load, over the largest wrench; smaller is rounding [1]
constexpr double kMinLoadRatio = 1e-9;

bool is_polytope(const WrenchSet& set) {
  return all_of(set.caps, [](const WrenchCap& cap) { return cap.A.cols() == 0; });
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
    const WrenchCoordinates a = cap.A.col(0), b = cap.A.col(1);
    cap.A.col(0) = std::cos(angle) * a + std::sin(angle) * b;
    cap.A.col(1) = std::cos(angle) * b - std::sin(angle) * a;
  }
}

/// Numbers of contact_regions that share a limit, one a contact of the file. Wrenches have no
/// place.
std::vector<int> regions_of(const ContactFile& file) {
  std::vector<Contact> contacts = contacts_of(file);
  int fresh = 0;  // a patch that nobody has
  for (const Contact& each : contacts) fresh = std::max(fresh, each.patch + 1);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (contacts[i].patch < 0 && !file.contacts[i].wrenches.empty()) contacts[i].patch = fresh++;
  return contact_regions(contacts);
}

WrenchSet cones_of(const ContactFile& file, const Contact& contact,
                   const ContactQualityRequest& request) {
  if (file.planar) return planar_wrench_set({contact}, file.centre_of_mass, file.torque_scale);
  WrenchSet set = wrench_set({contact}, file.centre_of_mass, file.torque_scale);
  if (request.edges == 0) return set;
  turn(set, request.first_edge);
  return friction_pyramids(set, request.edges);
}

/// Wrenches of a file: its cones or their pyramids, and generators where they are given.
WrenchSet wrenches_of(const ContactFile& file, const ContactQualityRequest& request) {
  const std::vector<int> region = regions_of(file);
  const std::vector<Contact> contacts = contacts_of(file);
  WrenchSet set;
  // Generators of the file replace the cone of their contact.
  for (std::size_t i = 0; i < file.contacts.size(); ++i) {
    const std::vector<FileWrench>& generators = file.contacts[i].wrenches;
    for (const FileWrench& wrench : generators)
      set.caps.push_back({ScaledWrench::from_coordinates(wrench), {}, region[i]});
    if (!generators.empty()) continue;
    for (WrenchCap& cap : cones_of(file, contacts[i], request).caps) {
      cap.contact = region[i];
      set.caps.push_back(std::move(cap));
    }
  }
  return set;
}

double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Epsilon epsilon_of(const WrenchSet& set, const ContactFile& file,
                   const ContactQualityRequest& request) {
  if (file.planar) return planar_epsilon(set, request.norm);
  // Search a polytope to a smaller gap than requested, which makes its epsilon exact.
  EpsilonOptions wanted;
  wanted.limit = request.norm;
  wanted.gap = request.gap;
  const double sharp = kPolytopeGap * largest_wrench_norm(set);
  if (is_polytope(set) && sharp > 0) wanted.gap = std::min(request.gap, sharp);
  // The bounds of a curved set cannot meet more closely than rounding allows.
  const double least = is_polytope(set) ? 0 : min_gap(set, request.norm);
  require_field("gap", request.gap >= least, "wanted a gap of at least {:.2g}, got {}", least,
                request.gap);
  Epsilon found = epsilon(set, wanted);
  found.converged = found.upper - found.lower <= request.gap;
  return found;
}

std::optional<Volume> volume_of(const WrenchSet& set, const ContactFile& file,
                                const ContactQualityRequest& request) {
  if (!request.volume || file.planar) return {};
  VolumeOptions options;
  options.limit = request.norm;
  return volume(set, options);
}

/// Computes the grasp matrix of a planar grasp: columns n and t of each contact, rows f_x, f_y and
/// torque.
Eigen::MatrixXd planar_matrix(const std::vector<Contact>& contacts, const ContactFile& file) {
  // Torques are divided by the torque scale, as in all wrenches of the file.
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
  for (const FileContact& each : file.contacts)
    if (!each.wrenches.empty()) return {};
  const std::vector<Contact> contacts = contacts_of(file);
  if (file.planar) return grasp_matrix_measures(planar_matrix(contacts, file));
  return grasp_matrix_measures(grasp_matrix(contacts, file.centre_of_mass, file.torque_scale));
}

/// A margin as a result has it: unknown where a program did not end.
TaskQuality quality_of(const TaskMargin& margin, double torque_scale) {
  TaskQuality task;
  task.status = margin.status;
  if (margin.status == Status::kSolved) {
    task.lower = margin.lower;
    task.upper = margin.upper;
  }
  task.worst_load = unscaled_wrench(margin.worst_load, torque_scale);
  task.residual = margin.residual;
  return task;
}

/// Computes the margin of each load; the margin of the task is the smallest.
/// @param grasp_forces  of each load gets the least limit that withstands it
TaskMargin margin_of_each(const ForceSet& forces, const std::vector<ScaledWrench>& loads,
                          double largest, std::vector<std::optional<double>>& grasp_forces) {
  TaskMargin margin{Status::kSolved, kInfinity, kInfinity, ScaledWrench{}, 0};
  for (const ScaledWrench& load : loads) {
    grasp_forces.emplace_back();
    if (load.is_zero()) {
      grasp_forces.back() = 0;
      continue;
    }
    // The largest multiple of the load that unit forces withstand.
    const WrenchSupport reach = load_margin(forces, load);
    margin.residual = max_or_nan(margin.residual, reach.residual);
    if (reach.status != Status::kSolved) {
      margin.status = reach.status;
      continue;
    }
    const double k = reach.value * load.norm() < kMinLoadRatio * largest ? 0 : reach.value;
    grasp_forces.back() = 1 / k;
    if (k < margin.lower) margin.worst_load = load;
    margin.lower = std::min(margin.lower, k);
    margin.upper = std::min(margin.upper, k == 0 ? 0 : reach.bound);
  }
  return margin;
}

TaskMargin margin_of_axes(const ForceSet& forces, const std::vector<ScaledWrench>& axes) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> Q(6, static_cast<Eigen::Index>(axes.size()));
  for (std::size_t i = 0; i < axes.size(); ++i)
    Q.col(static_cast<Eigen::Index>(i)) = axes[i].vector();
  return margin_of_ellipsoid(forces, Q);
}

std::optional<TaskQuality> task_of(const WrenchSet& set, const ContactFile& file,
                                   const ContactQualityRequest& request) {
  if (file.task.kind == FileTask::Kind::kNone) return {};
  // Moments of loads are divided by the torque scale, as those of contacts are.
  const bool each = file.task.kind == FileTask::Kind::kLoads;
  std::vector<ScaledWrench> loads;
  for (const FileWrench& load : file.task.loads)
    loads.push_back(scaled_wrench({load.tail<3>(), load.head<3>()}, file.torque_scale));
  const double largest = largest_wrench_norm(set);
  // The margin of the kind of task that the file has.
  const ForceSet forces = unit_forces(set, request.norm);
  std::vector<std::optional<double>> grasp_forces;
  TaskMargin margin{Status::kSolved, 0, 0, loads[0], 0};
  if (set.caps.empty() && each)
    grasp_forces.assign(loads.size(), kInfinity);
  else if (!set.caps.empty())
    margin = each ? margin_of_each(forces, loads, largest, grasp_forces)
             : file.task.kind == FileTask::Kind::kBox ? margin_of_box(forces, loads[0], loads[1])
                                                      : margin_of_axes(forces, loads);
  // Below this nothing is borne, but for the programmes' rounding.
  const double none = kMinLoadRatio * largest / std::max(margin.worst_load.norm(), 1e-300);
  if (margin.upper < none) margin.lower = margin.upper = 0;
  // Convert the worst load to N and N m, the units of the file.
  TaskQuality task = quality_of(margin, file.torque_scale);
  task.grasp_forces = std::move(grasp_forces);
  return task;
}

ContactFile read_contacts(const ContactQualityRequest& request) {
  if (!request.text.empty()) return parse_contacts(request.contacts, request.text, request.line);
  // A name, unless it can only be a file.
  std::string file = request.contacts;
  std::error_code none;
  if (!std::filesystem::exists(file, none) && std::filesystem::path(file).filename() == file &&
      std::filesystem::path(file).extension() != ".json")
    file = named_file("contact set", file, "contacts", ".json", data_folders(request.data));
  require_kind(file, {"contacts"});
  return read_contact_file(file);
}

}  // namespace

void require_valid(const ContactQualityRequest& request) {
  require_field("gap", request.gap > 0, "wanted a gap above 0, got {}", request.gap);
  require_field("edges",
                request.edges == 0 || (request.edges >= 3 && request.edges <= kMaxPyramidEdges),
                "wanted pyramids of 3 to {} edges, got {}", kMaxPyramidEdges, request.edges);
  require_field("first_edge", request.edges > 0 || request.first_edge == 0,
                "a first edge is of pyramids: say how many edges they have");
}

ContactQualityResult measure_contacts(const ContactQualityRequest& request) {
  require_valid(request);
  const ContactFile file = in_field("contacts", [&] { return read_contacts(request); });
  require_field("edges", !file.planar || request.edges == 0,
                "pyramids are of cones in space, not in a plane");
  ContactQualityResult found;
  // Record the request and the inputs.
  found.request = request;
  found.contacts = file.path;
  found.count = file.contacts.size();
  found.torque_scale = file.torque_scale;
  found.planar = file.planar;
  found.outcome.warnings = file.warnings;
  found.outcome.warn(contact_warnings(file));
  // Epsilon with the making of the wrenches, then the volume, each with its processor time.
  const std::clock_t start = std::clock();
  const WrenchSet set = wrenches_of(file, request);
  found.epsilon = epsilon_of(set, file, request);
  found.epsilon_cpu = seconds_since(start);
  const std::clock_t middle = std::clock();
  found.volume = volume_of(set, file, request);
  found.volume_cpu = seconds_since(middle);
  // The grasp matrix and the task are immediate, and not timed.
  found.grasp_matrix = matrix_of(file);
  found.task = task_of(set, file, request);
  return found;
}

}  // namespace thenar
