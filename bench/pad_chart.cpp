// pad_chart PAGE.html [NU...]
// pad_chart --pad PAD NU
//
// Elements and meshes of a finger pad, ours and a rival's: errors of the force over processor time.
// The pad of data/pads/index_pad.toml, elastic, is pressed by a plane to 1 mm without friction. NU
// are Poisson's ratios, 0.49 and 0.499 unless given. --pad writes the pad for pad_dealii, which is
// run, too, if it was built.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "base/error.h"
#include "base/thread_seconds.h"
#include "bench/chart_main.h"
#include "bench/pad_rivals/tetrahedra.h"
#include "bench/ratios.h"
#include "geometry/primitives.h"
#include "pads/build_pad.h"
#include "pads/pad_press.h"

namespace thenar::bench {
namespace {

constexpr double kDepth = 1e-3;   // [m]
constexpr double kForce = 1;      // of presses to a force [N]
constexpr double kEnough = 0.02;  // error that is asked of all [1]
constexpr double kOften = 1;      // processor time of runs that are repeated five times [s]
constexpr double kSeldom = 5;     // three times; longer ones run once [s]
constexpr double kBox = 0.2;      // edges of the box whose face is the plane [m]
constexpr double kNearby = 1.05;  // forces between which the stiffness is found [1]
constexpr int kMaxElements = 40000;

/// What a press came to.
struct Press {
  std::size_t elements = 0, unknowns = 0;
  double force = 0, depth = 0;  // [N], [m]
  double cpu = 0;               // [s]
};

/// A press to be done, and what came of it.
struct Run {
  std::string mesh;
  std::function<Press()> press;
  Press found = {};
  std::vector<double> cpu = {};  // of all turns [s]
  double error = 0;              // [1]
  [[nodiscard]] double seconds() const { return median(cpu); }
};

/// Runs of one kind, from coarse to fine.
struct Course {
  std::string name;
  std::vector<Run> runs;
  bool ours_even = false;  // even meshes of our elements
};

/// The pad without relaxation.
PadModel pad_at(double nu) {
  PadModel model = build_pad(read_pad(std::string(THENAR_DATA_DIR) + "/pads/index_pad.toml"));
  for (Tissue& tissue : model.tissues) {
    tissue.relaxation.clear();
    tissue.poisson_ratio = nu;
  }
  return model;
}

/// One press by our elements from rest, to a depth or to a force.
Press press_elements(const PadModel& model, double asked, std::optional<double> force) {
  PadPressOptions options;
  options.force_error = asked;
  options.max_penetration = HUGE_VAL;
  options.max_elements = kMaxElements;
  const double began = thread_seconds();
  Pose<double> touch;
  touch.p = Eigen::Vector3d(0, 0, model.shape.height + kBox / 2);
  PadPress press(model, {build_box({kBox, kBox, kBox}), 0}, touch, options);
  PressGoal goal;
  goal.X_PO = touch;
  goal.force = force;
  if (!force) goal.X_PO.p -= Eigen::Vector3d(0, 0, kDepth);
  const PadPressResult result = press.step(goal);
  require(result.solved.status == Status::kSolved, "{}, {} elements: {}", name_of(model.element),
          result.elements, result.solved.message);
  return {result.elements, static_cast<std::size_t>(press.body().unknowns()), -result.push.force[2],
          touch.p[2] - press.state().X_PO.p[2], thread_seconds() - began};
}

Press press_rival(const PadModel& model, const PadCells& cells) {
  const double began = thread_seconds();
  const TetrahedraPress press =
      press_tetrahedra(model.shape, cells, model.tissues.front(), model.shape.height - kDepth);
  require(press.solved, "{} tetrahedra were not solved", press.elements);
  return {press.elements, press.unknowns, press.force, kDepth, thread_seconds() - began};
}

/// The pad on a coarse mesh as pad_dealii reads it.
void write_pad(const PadModel& model, const PadCells& cells, const std::string& file) {
  const PadShape& shape = model.shape;
  const Tissue& tissue = model.tissues.front();
  require(shape.layers.empty() && shape.skin == nullptr, "pad_dealii has no skin of its own");
  const HexMesh mesh = pad_mesh(shape, cells);
  std::ofstream out(file);
  out << fmt::format("{} {} {}\n{} {} {}\n{} {} {}\n{} {}\n", shape.length / 2, shape.width / 2,
                     shape.height, shape.bone_length / 2, shape.bone_width / 2, shape.bone_height,
                     tissue.shear_modulus, bulk_modulus(tissue), kDepth, mesh.nodes(),
                     mesh.active().size());
  for (int node = 0; node < mesh.nodes(); ++node) {
    const Eigen::Vector3d& c = mesh.chart_point(node);
    out << fmt::format("{} {} {}\n", c[0], c[1], c[2]);
  }
  for (const int cell : mesh.active())
    out << fmt::format("{}\n",
                       fmt::join(mesh.cells()[static_cast<std::size_t>(cell)].corners, " "));
  out.close();
  require(!out.fail(), "{} cannot be written", file);
}

#ifdef THENAR_PAD_DEALII
/// The other program's meshes, from one run of it, in a process of its own.
Course dealii_course(const PadModel& model) {
  Course out{"Q2P1, adaptive (deal.II)", {}};
  const std::string file = fmt::format("/tmp/thenar_pad_{}.txt", getpid());
  write_pad(model, {4, 2, 2}, file);
  const std::string call = fmt::format("{} {} 3", THENAR_PAD_DEALII, file);
  FILE* lines = popen(call.c_str(), "r");
  require(lines != nullptr, "pad_dealii does not start");
  Press press;
  press.depth = kDepth;
  while (std::fscanf(lines, "%zu %zu %lf %*f %lf %*d", &press.elements, &press.unknowns,
                     &press.force, &press.cpu) == 4)
    out.runs.push_back({fmt::format("mesh {}", out.runs.size() + 1), [press] { return press; }});
  const int failed = pclose(lines);
  std::remove(file.c_str());
  require(failed == 0, "pad_dealii failed");
  return out;
}
#endif

std::string name_of(const PadCells& cells) {
  return fmt::format("{}, {}, {}", cells.across, cells.around, cells.through);
}

Course even_course(const PadModel& model, HexElement element, const std::vector<PadCells>& meshes) {
  Course out{name_of(element) + ", even", {}, true};
  for (const PadCells& cells : meshes)
    out.runs.push_back({name_of(cells), [=] {
                          PadModel even = model;
                          even.element = element;
                          even.cells = cells;
                          return press_elements(even, HUGE_VAL, {});
                        }});
  return out;
}

Course adaptive_course(const PadModel& model, const std::vector<double>& errors,
                       std::optional<double> force) {
  Course out{"Q1P0, adaptive", {}};
  for (const double asked : errors)
    out.runs.push_back({fmt::format("asked {:g} %", 100 * asked),
                        [=] { return press_elements(model, asked, force); }});
  return out;
}

Course tetrahedra_course(const PadModel& model, const std::vector<PadCells>& meshes) {
  Course out{"linear tetrahedra, LDLT", {}};
  for (const PadCells& cells : meshes)
    out.runs.push_back({name_of(cells), [=] { return press_rival(model, cells); }});
  return out;
}

/// In turns, so that a change of the machine's load meets all of them.
void run_all(std::vector<Course>& courses) {
  for (int turn = 0; turn < 5; ++turn)
    for (Course& course : courses)
      for (Run& run : course.runs) {
        const double longest = turn == 0 ? HUGE_VAL : turn < 3 ? kSeldom : kOften;
        if (turn > 0 && run.found.cpu > longest) continue;
        const Press found = run.press();
        if (turn == 0) run.found = found;
        run.cpu.push_back(found.cpu);
      }
}

/// The force that all are held to.
struct Reference {
  double force = 0;    // mean of the two finest meshes [N]
  double unknown = 0;  // largest change from coarser to finer, and between the two [1]
};

Reference find_reference(const PadModel& model) {
  PadModel even = model;
  const auto at = [&](const PadCells& cells) {
    even.cells = cells;
    return press_elements(even, HUGE_VAL, {}).force;
  };
  const double coarse = at({16, 8, 10}), fine = at({20, 10, 12});
  const double coarse_too = press_elements(model, 0.02, {}).force;
  const double fine_too = press_elements(model, 0.01, {}).force;
  Reference out;
  out.force = (fine + fine_too) / 2;
  for (const double change : {coarse - fine, coarse_too - fine_too, fine - fine_too})
    out.unknown = std::max(out.unknown, std::abs(change) / out.force);
  return out;
}

/// The coarsest run from which on all are good enough; null: none.
const Run* first_to_stay(const Course& course) {
  const Run* out = nullptr;
  for (auto run = course.runs.rbegin(); run != course.runs.rend() && run->error <= kEnough; ++run)
    out = &*run;
  return out;
}

/// What a course says of meshes that it did not try: powers through its two finest.
void print_extrapolated(const Course& course, double adaptive) {
  const Run& fine = course.runs.back();
  const Run& coarse = course.runs[course.runs.size() - 2];
  const auto power = [](double a, double b, double x, double y) {
    return std::log(b / a) / std::log(y / x);
  };
  const auto n = static_cast<double>(fine.found.unknowns);
  const auto before = static_cast<double>(coarse.found.unknowns);
  const double order = -power(coarse.error, fine.error, before, n);
  const double cost = power(coarse.seconds(), fine.seconds(), before, n);
  const double needed = n * std::pow(fine.error / kEnough, 1 / order);
  fmt::print(
      "{}: {:.1f} % off after {:.3g} s, at least {:.0f} times the adaptive one's; by powers "
      "(error as unknowns^-{:.2f}, time as unknowns^{:.2f}) {:.2g} unknowns, {:.2g} s, {:.2g} "
      "times\n",
      course.name, 100 * fine.error, fine.seconds(), fine.seconds() / adaptive, order, cost, needed,
      fine.seconds() * std::pow(needed / n, cost),
      fine.seconds() * std::pow(needed / n, cost) / adaptive);
}

/// How much longer the others take to 2 % than meshes that refine. @return time of those [s]
double print_ratios(const std::vector<Course>& courses) {
  const Run* adaptive = first_to_stay(courses.front());
  require(adaptive != nullptr, "no adaptive mesh is within {:g} %", 100 * kEnough);
  const double seconds = adaptive->seconds();
  fmt::print("\nwithin {:g} % from there on: {}, {}, {:.3g} s\n", 100 * kEnough,
             courses.front().name, adaptive->mesh, seconds);
  double best = HUGE_VAL;
  for (const Course& course : courses) {
    if (&course == &courses.front()) continue;
    if (const Run* run = first_to_stay(course)) {
      fmt::print("{}: {}, {:.3g} s, {:.1f} times\n", course.name, run->mesh, run->seconds(),
                 run->seconds() / seconds);
      if (course.ours_even) best = std::min(best, run->seconds());
    } else {
      print_extrapolated(course, seconds);
    }
  }
  fmt::print("best even mesh: {:.1f} times\n", best / seconds);
  return seconds;
}

/// Presses to a force: what the depth is off by, as a share of the force at the same depth.
void print_force_presses(const PadModel& model) {
  const Press reference = press_elements(model, 0.02, kForce);
  const Press above = press_elements(model, 0.02, kNearby * kForce);
  const double power = std::log(kNearby) / std::log(above.depth / reference.depth);
  fmt::print("\nto {:g} N; reference {:.4f} mm, force as depth^{:.2f}\n", kForce,
             1e3 * reference.depth, power);
  std::vector<Course> courses{adaptive_course(model, {0.15, 0.12, 0.1, 0.07, 0.05}, kForce)};
  run_all(courses);
  for (const Run& run : courses.front().runs)
    fmt::print("{:<26}{:<14}{:>9}  {:.4f} mm, force {:+.2f} %, {:.0f} ms\n", courses.front().name,
               run.mesh, run.found.elements, 1e3 * run.found.depth,
               -100 * power * (run.found.depth / reference.depth - 1), 1e3 * run.seconds());
}

Json block_of(double nu, const Reference& reference, const std::vector<Course>& courses,
              double adaptive) {
  Json chart{
      {"type", "lines"},
      {"caption", fmt::format("Poisson's ratio {:g}. Error of the force against {:.4f} N, known to "
                              "{:.1f} %: errors below that mean nothing. Lower and further left is "
                              "better.",
                              nu, reference.force, 100 * reference.unknown)},
      {"x_label", "processor time [s]"},
      {"y_label", "error of the force, relative [1]"},
      {"log_x", true},
      {"log_y", true},
      {"height", 460},
      {"series", Json::array()}};
  Json rows = Json::array();
  for (const Course& course : courses) {
    Json x = Json::array(), y = Json::array(), hints = Json::array();
    for (const Run& run : course.runs) {
      x.push_back(run.seconds());
      y.push_back(run.error);
      hints.push_back(fmt::format("{}: {} elements", run.mesh, run.found.elements));
      rows.push_back({course.name, run.mesh, run.found.elements, run.found.unknowns,
                      run.found.force, 100 * run.error, run.seconds(), run.seconds() / adaptive});
    }
    chart["series"].push_back(
        {{"name", course.name}, {"x", x}, {"y", y}, {"style", "both"}, {"hints", hints}});
  }
  return row_block({chart, table_block("All runs; ratios to the first adaptive mesh within 2 %",
                                       {{"elements", ""},
                                        {"mesh", ""},
                                        {"count", "", 0},
                                        {"unknowns", "", 0},
                                        {"force", "N", 4},
                                        {"error", "%", 2},
                                        {"processor time", "s"},
                                        {"ratio", "1"}},
                                       rows)});
}

Json section_of(double nu) {
  const PadModel model = pad_at(nu);
  const std::vector<PadCells> even{{4, 2, 3}, {6, 3, 4}, {8, 4, 5}, {12, 6, 7}};
  std::vector<Course> courses{
      adaptive_course(model, {0.3, 0.25, 0.15, 0.1, 0.07, 0.05, 0.03}, {}),
      even_course(model, HexElement::kDisplacement, even),
      even_course(model, HexElement::kMeanDilatation, even),
      even_course(model, HexElement::kCentroidDilatation, even),
      even_course(model, HexElement::kQuadratic,
                  {{2, 1, 2}, {4, 2, 2}, {4, 2, 3}, {6, 3, 4}, {8, 4, 5}}),
      tetrahedra_course(model, {{4, 2, 3}, {6, 3, 4}, {8, 4, 5}, {12, 6, 7}, {14, 7, 8}})};
#ifdef THENAR_PAD_DEALII
  courses.push_back(dealii_course(model));
#endif
  const Reference reference = find_reference(model);
  fmt::print(
      "\nnu = {:g}: {:.5f} N, known to {:.2f} %\n{:<26}{:<14}{:>9}{:>10}{:>10}{:>10}{:>10}\n", nu,
      reference.force, 100 * reference.unknown, "", "cells", "elements", "unknowns", "force [N]",
      "error [%]", "CPU [s]");
  run_all(courses);
  for (Course& course : courses)
    for (Run& run : course.runs) {
      run.error = std::abs(run.found.force / reference.force - 1);
      fmt::print("{:<26}{:<14}{:>9}{:>10}{:>10.5f}{:>10.2f}{:>10.3g}\n", course.name, run.mesh,
                 run.found.elements, run.found.unknowns, run.found.force, 100 * run.error,
                 run.seconds());
    }
  std::fflush(stdout);
  const double adaptive = print_ratios(courses);
  print_force_presses(model);
  return section(fmt::format("nu-{:g}", 1000 * nu), fmt::format("Poisson's ratio {:g}", nu), "",
                 {block_of(nu, reference, courses, adaptive)});
}

Json page(const std::vector<double>& ratios) {
  Json sections = Json::array();
  for (const double nu : ratios) sections.push_back(section_of(nu));
  return {{"title", "Elements of a finger pad"}, {"sections", sections}};
}

}  // namespace
}  // namespace thenar::bench

int main(int argc, char** argv) {
  if (argc == 4 && std::string(argv[1]) == "--pad")
    return thenar::bench::run_program("pad_chart", [&] {
      thenar::bench::write_pad(thenar::bench::pad_at(std::atof(argv[3])), {4, 2, 2}, argv[2]);
    });
  std::vector<double> ratios;
  for (int i = 2; i < argc; ++i) ratios.push_back(std::atof(argv[i]));
  if (ratios.empty()) ratios = {0.49, 0.499};
  return thenar::bench::write_chart("pad_chart", std::min(argc, 2), argv,
                                    [&] { return thenar::bench::page(ratios); });
}
