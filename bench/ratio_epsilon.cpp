// Epsilon of grasps with three to six point contacts: the true cones with a certified gap of 1e-3,
// against qhull's whole hull of friction pyramids, which have an error of their own.

#include <algorithm>
#include <ctime>

#include "bench/ratios.h"
#include "grasp/contact/friction_pyramid.h"
#include "grasp/quality/epsilon.h"
#include "tests/grasp/quality/qhull_hull.h"
#include "tests/grasp/quality/random_grasps.h"

namespace thenar::bench {
namespace {

constexpr double kGap = 1e-3;

/// Grasps with force closure, as many of each number of contacts.
std::vector<WrenchSet> closures(int of_each) {
  std::vector<WrenchSet> sets;
  for (int contacts = 3; contacts <= 6; ++contacts) {
    std::mt19937 rng(static_cast<unsigned>(contacts));
    for (int found = 0; found < of_each;) {
      WrenchSet set = wrench_set(random_contacts(rng, contacts), Eigen::Vector3d::Zero(), 1);
      if (!epsilon(set).force_closure) continue;
      sets.push_back(std::move(set));
      ++found;
    }
  }
  return sets;
}

double rival(const WrenchSet& set, int edges) {
  return qhull_hull(vertices_of(friction_pyramids(set, edges), ForceNorm::kL1), "qhull Qt Pp",
                    false)
      .nearest;
}

/// Processor time, as the rival runs but once and others may want the core, too.
double seconds_of(const std::function<void()>& task) {
  const std::clock_t start = std::clock();
  task();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

Row ratio_epsilon() {
  const std::vector<WrenchSet> sets = closures(16);
  Duel duel{"epsilon, certified: qhull with 8 edges", {}, {}, 15, 0, kGap};
  for (const WrenchSet& set : sets) {
    const Epsilon e = epsilon(set);
    duel.error = std::max({duel.error, e.upper - e.lower, rival(set, 8) - e.upper});
  }
  duel.ours = [&, i = 0U]() mutable { keep(epsilon(sets[i++ % sets.size()])); };
  duel.rival = [&, i = 0U]() mutable { keep(rival(sets[i++ % sets.size()], 8)); };
  return measure(duel, {15, 0.2});
}

Row ratio_epsilon_fine() {
  // The rival takes seconds: one grasp of each number of contacts, once; the median of their
  // ratios.
  std::vector<double> ours, theirs, ratios;
  Row row{"the same: qhull with 64 edges", 0, 0, 0, 10000, 0, kGap};
  for (const WrenchSet& set : closures(1)) {
    const Epsilon e = epsilon(set);
    constexpr int kRepeats = 500;
    ours.push_back(1e6 / kRepeats * seconds_of([&] {
                     for (int i = 0; i < kRepeats; ++i) keep(epsilon(set));
                   }));
    double inner = 0;
    theirs.push_back(1e6 * seconds_of([&] { inner = rival(set, 64); }));
    ratios.push_back(theirs.back() / ours.back());
    row.error = std::max({row.error, e.upper - e.lower, inner - e.upper});
  }
  row.ours = median(ours);
  row.rival = median(theirs);
  row.ratio = median(ratios);
  return row;
}

}  // namespace thenar::bench
