// A net of 15 floating nodes and 40 bands on a bone, brought to rest from its neighbouring posture:
// the Newton solver against other ways to the same equilibrium.

#include "bench/net_rivals/dynamic_relaxation.h"
#include "bench/net_rivals/kinsol_balance.h"
#include "bench/net_rivals/point_masses.h"
#include "bench/net_sweep.h"
#include "bench/ratios.h"

namespace thenar::bench {
namespace {

constexpr int kPostures = 16;
constexpr double kStep = 0.02;  // between postures [rad]

struct Bar {
  double required;   // least ratio of times
  double tolerance;  // greatest difference of tensions [N]
};

/// @param rival  from a task to where the rival rests
template <typename Rival>
Row against(const std::string& name, const Bar& bar, const Patience& patience, Rival rival) {
  const SampleNet sample = net_over_head();
  const std::vector<WarmTask> tasks = warm_tasks(sample, kPostures, kStep);
  NetSolver solver(sample.net);

  Duel duel{name, {}, {}, bar.required, 0, bar.tolerance};
  for (const WarmTask& task : tasks)
    duel.error = std::max(duel.error, tension_error(task, rival(sample.net, task)));
  duel.ours = [&, i = 0U]() mutable {
    const WarmTask& task = tasks[i++ % kPostures];
    keep(solver.solve(task.state, sample.drive, &task.start));
  };
  duel.rival = [&, i = 0U]() mutable { keep(rival(sample.net, tasks[i++ % kPostures])); };
  return measure(duel, patience);
}

/// Runs masses to rest; the system is built once and kept.
Row against_masses(const std::string& name, const Bar& bar, const PointMassOptions& options) {
  std::unique_ptr<PointMasses> masses;
  return against(name, bar, {7, 0.05}, [&](const Net& net, const WarmTask& task) {
    if (!masses) masses = std::make_unique<PointMasses>(net, options);
    return masses->solve(task.posed, task.start);
  });
}

}  // namespace

Row ratio_net_relaxation() {
  return against("net on bone: dynamic relaxation to 1e-6 N", {10, 1e-5}, {},
                 [](const Net&, const WarmTask& task) { return relax(task.posed, task.start); });
}

Row ratio_net_kinsol() {
  std::unique_ptr<KinsolBalance> kinsol;
  return against("the same: KINSOL, dense, to 1e-9 N", {1, 1e-7}, {},
                 [&](const Net& net, const WarmTask& task) {
                   if (!kinsol) kinsol = std::make_unique<KinsolBalance>(net);
                   return kinsol->solve(task.posed, task.start);
                 });
}

Row ratio_net_masses() {
  return against_masses("the same: Simbody point masses to 1e-6 N", {4000, 1e-5}, {});
}

Row ratio_net_tuned_masses() {
  PointMassOptions options;
  options.fixed_step = 2.5e-5;
  return against_masses("the same: these, step tuned by hand", {0, 1e-5}, options);
}

}  // namespace thenar::bench
