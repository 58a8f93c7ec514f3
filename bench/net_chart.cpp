// net_chart PAGE.html
//
// Error of band tensions over time for every way to bring one net to rest, each started from the
// neighbouring posture.

#include <chrono>

#include "bench/chart_main.h"
#include "bench/net_rivals/dynamic_relaxation.h"
#include "bench/net_rivals/kinsol_balance.h"
#include "bench/net_rivals/point_masses.h"
#include "bench/net_sweep.h"
#include "bench/ratios.h"
#include "report/blocks.h"

namespace thenar::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kPoints = 150;  // drawn of each method
constexpr double kFloor = 1e-14;      // of errors drawn: rounding [N]

/// One method's way to rest.
struct Trace {
  std::string name;
  std::vector<double> seconds, error;  // [s], largest error of a tension [N]
};

/// Times a rival without the time spent looking at it.
class Recorder {
 public:
  Recorder() : last_(Clock::now()) {}
  void operator()(const Eigen::Matrix3Xd& x) {
    spent_ += std::chrono::duration<double>(Clock::now() - last_).count();
    seconds_.push_back(spent_);
    x_.push_back(x);
    last_ = Clock::now();
  }
  [[nodiscard]] Trace trace(const std::string& name, const WarmTask& task) const {
    Trace out{name, {}, {}};
    const std::size_t stride = x_.size() / kPoints + 1;
    for (std::size_t i = 0; i < x_.size(); i += (i + 1 == x_.size() ? 1 : stride)) {
      if (i + stride >= x_.size()) i = x_.size() - 1;
      const Eigen::VectorXd off = task.posed.tensions(x_[i]) - task.rest.tension;
      out.seconds.push_back(seconds_[i]);
      out.error.push_back(std::max(off.cwiseAbs().maxCoeff(), kFloor));
    }
    return out;
  }

 private:
  Clock::time_point last_;
  double spent_ = 0;  // [s]
  std::vector<double> seconds_;
  std::vector<Eigen::Matrix3Xd> x_;
};

/// Newton's method, stopped after each of its steps.
Trace newton(const SampleNet& sample, const WarmTask& task) {
  Trace out{"Newton (thenar)", {}, {}};
  for (int steps = 1; steps <= task.rest.iterations; ++steps) {
    NetSolverOptions options;
    options.max_iterations = steps;
    NetSolver solver(sample.net, options);
    NetEquilibrium rest;
    Duel duel{"", {}, {}, 0, 0, 0};
    duel.ours = duel.rival = [&] { rest = solver.solve(task.state, sample.drive, &task.start); };
    out.seconds.push_back(1e-6 * measure(duel, {31, 0.003}).ours);
    const Eigen::VectorXd off = task.posed.tensions(rest.x) - task.rest.tension;
    out.error.push_back(std::max(off.cwiseAbs().maxCoeff(), kFloor));
  }
  return out;
}

/// @param solve  brings the net to rest, telling the recorder of every step
template <typename Solve>
Trace rival(const std::string& name, const WarmTask& task, Solve solve) {
  Recorder recorder;
  (void)solve([&recorder](const Eigen::Matrix3Xd& x) { recorder(x); });
  return recorder.trace(name, task);
}

std::vector<Trace> traces() {
  const SampleNet sample = net_over_head();
  const std::vector<WarmTask> tasks = warm_tasks(sample, 2, 0.02);
  const WarmTask& task = tasks.back();
  KinsolBalance kinsol(sample.net);
  PointMassOptions fixed;
  fixed.fixed_step = 2.5e-5;
  PointMasses controlled(sample.net), tuned(sample.net, fixed);
  return {newton(sample, task),
          rival("KINSOL", task,
                [&](const Watch& watch) { return kinsol.solve(task.posed, task.start, watch); }),
          rival("dynamic relaxation", task,
                [&](const Watch& watch) { return relax(task.posed, task.start, {}, watch); }),
          rival("Simbody point masses, step tuned by hand", task,
                [&](const Watch& watch) { return tuned.solve(task.posed, task.start, watch); }),
          rival("Simbody point masses, error control", task, [&](const Watch& watch) {
            return controlled.solve(task.posed, task.start, watch);
          })};
}

Json page() {
  Json lines{{"type", "lines"},
             {"caption",
              "15 floating nodes and 40 bands over the head of a phalanx, warm from 1.1 deg away. "
              "Each line is one method; lower and further left is better."},
             {"x_label", "time [us]"},
             {"y_label", "largest error of a tension [N]"},
             {"log_x", true},
             {"log_y", true},
             {"height", 460},
             {"series", Json::array()}};
  for (const Trace& trace : traces()) {
    std::vector<double> us;
    for (double s : trace.seconds) us.push_back(1e6 * s);
    lines["series"].push_back(
        {{"name", trace.name}, {"x", us}, {"y", trace.error}, {"style", "both"}});
  }
  return {{"title", "Ways to bring a net to rest"},
          {"sections", {section("solvers", "Error over time", "", {lines})}}};
}

}  // namespace
}  // namespace thenar::bench

int main(int argc, char** argv) {
  return thenar::bench::write_chart("net_chart", argc, argv, thenar::bench::page);
}
