// quality_chart PAGE.html
//
// Error of epsilon over time on four point contacts: friction pyramids of 4 to 64 edges, by qhull's
// whole hull and by refining the nearest facet, against the true cones at gaps from 0.1 to 1e-5.

#include <algorithm>
#include <ctime>

#include <fmt/format.h>

#include "bench/chart_main.h"
#include "bench/ratios.h"
#include "grasp/contact/friction_pyramid.h"
#include "grasp/quality/epsilon.h"
#include "report/blocks.h"
#include "tests/grasp/quality/qhull_hull.h"
#include "tests/grasp/quality/random_grasps.h"

namespace thenar::bench {
namespace {

constexpr int kGrasps = 5, kContacts = 4;
constexpr double kReferenceGap = 1e-6;
constexpr double kExact = 1e-10;  // gap asked of polytopes
constexpr double kEnough = 0.02;  // processor time of one measurement [s]

/// One way at one setting, medians over the grasps.
struct Point {
  double us = 0;     // processor time [us]
  double error = 0;  // (true - found) / true, or certified gap / true [1]
};

struct Line {
  std::string name, setting;
  std::vector<double> settings;
  std::vector<Point> points;
};

struct Task {
  WrenchSet set;
  double epsilon;  // to kReferenceGap
};

std::vector<Task> tasks() {
  std::vector<Task> out;
  std::mt19937 rng(4);
  while (out.size() < kGrasps) {
    const WrenchSet set = wrench_set(random_contacts(rng, kContacts), Eigen::Vector3d::Zero(), 1);
    if (!epsilon(set).force_closure) continue;
    EpsilonOptions options;
    options.gap = kReferenceGap;
    options.max_facets = 2000000;
    out.push_back({set, epsilon(set, options).lower});
  }
  return out;
}

/// @param error  from a task to the relative error found
template <typename Error>
Point measure(const std::vector<Task>& tasks, Error error) {
  std::vector<double> us, errors;
  for (const Task& task : tasks) {
    const std::clock_t start = std::clock();
    double spent = 0, found = 0;
    int runs = 0;
    for (; spent < kEnough; ++runs) {
      found = error(task);
      spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    us.push_back(1e6 * spent / runs);
    errors.push_back(found);
  }
  return {median(us), median(errors)};
}

template <typename Error>
Line line(const std::string& name, const std::string& setting, const std::vector<double>& settings,
          const std::vector<Task>& tasks, Error error) {
  Line out{name, setting, settings, {}};
  for (const double value : settings)
    out.points.push_back(
        measure(tasks, [&](const Task& task) { return error(task, value) / task.epsilon; }));
  return out;
}

std::vector<Line> lines() {
  const std::vector<Task> grasps = tasks();
  const std::vector<double> edges{4, 6, 8, 12, 16, 24, 32, 48, 64};
  const auto cones = [](const Task& task, double gap) {
    EpsilonOptions options;
    options.gap = gap;
    const Epsilon e = epsilon(task.set, options);
    return e.upper - e.lower;
  };
  const auto refined = [](const Task& task, double m) {
    EpsilonOptions options;
    options.gap = kExact;
    return task.epsilon - epsilon(friction_pyramids(task.set, static_cast<int>(m)), options).lower;
  };
  const auto whole = [](const Task& task, double m) {
    const WrenchSet cut = friction_pyramids(task.set, static_cast<int>(m));
    return task.epsilon -
           qhull_hull(vertices_of(cut, ForceNorm::kL1), "qhull Qt Pp", false).nearest;
  };
  return {line("true cones, certified gap (thenar)", "gap",
               {0.1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5}, grasps, cones),
          line("pyramids, nearest facet refined (thenar)", "edges", edges, grasps, refined),
          line("pyramids, whole hull (qhull)", "edges", edges, grasps, whole)};
}

Json page() {
  Json block{
      {"type", "lines"},
      {"caption",
       "Epsilon of grasps with four point contacts, medians of five. Pyramids have 4, 6, 8, "
       "12, 16, 24, 32, 48 and 64 edges; for the true cones the error drawn is the certified "
       "gap, at 0.1 to 1e-5. Lower and further left is better."},
      {"x_label", "processor time [us]"},
      {"y_label", "error of epsilon, relative [1]"},
      {"log_x", true},
      {"log_y", true},
      {"height", 460},
      {"series", Json::array()}};
  fmt::print("{:<42}{:>10}{:>14}{:>12}\n", "", "", "time [us]", "error [1]");
  for (const Line& line : lines()) {
    std::vector<double> us, error;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      us.push_back(line.points[i].us);
      error.push_back(line.points[i].error);
      fmt::print("{:<42}{:>10}{:>14.1f}{:>12.2g}\n", line.name,
                 fmt::format("{} {:g}", line.setting, line.settings[i]), us[i], error[i]);
    }
    block["series"].push_back({{"name", line.name}, {"x", us}, {"y", error}, {"style", "both"}});
  }
  return {{"title", "Ways to epsilon"},
          {"sections", {section("epsilon", "Error over time", "", {block})}}};
}

}  // namespace
}  // namespace thenar::bench

int main(int argc, char** argv) {
  return thenar::bench::write_chart("quality_chart", argc, argv, thenar::bench::page);
}
