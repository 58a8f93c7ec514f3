// contact_chart PAGE.html
//
// Solvers of the contact problem of one step: how many problems each answers, in how many steps, to
// what residual and in what time, over the number of contacts, from nothing and from the answer of
// a neighbouring problem.

#include <algorithm>
#include <ctime>
#include <numeric>

#include <fmt/format.h>

#include "bench/chart_main.h"
#include "bench/ratios.h"
#include "contact/contact_solver.h"
#include "report/blocks.h"
#include "tests/contact/contact_samples.h"

namespace thenar::bench {
namespace {

constexpr int kProblems = 60;
constexpr double kEnough = 2e-4;  // processor time of one measurement [s]
constexpr double kChange = 0.01;  // of velocities, between neighbouring problems [1]

/// A problem and its neighbour.
struct Pair {
  ContactProblem first, second;
};

void change_velocities(std::mt19937& rng, sample::TouchingBodies* bodies) {
  std::normal_distribution<double> normal;
  for (sample::TouchingBodies::Body& body : bodies->bodies)
    for (int k = 0; k < 6; ++k) body.velocity(k) *= 1 + kChange * normal(rng);
}

/// Balls at random on each other and the ground; tangled where they are few.
Pair random_pair(std::mt19937& rng, int contacts) {
  sample::RandomTouch like;
  like.contacts = contacts;
  like.bodies = 1 + static_cast<int>(rng() % 3);
  sample::TouchingBodies bodies = sample::random_touch(rng, like);
  Pair out;
  out.first = bodies.problem();
  change_velocities(rng, &bodies);
  out.second = bodies.problem();
  return out;
}

/// An object of 0.2 kg between as many fingertips of 20 g, soft fingers, which press on it with 2
/// N; a step of 1 ms.
Pair held_pair(std::mt19937& rng, int contacts, double friction) {
  constexpr double kStep = 1e-3, kForce = 2, kTip = 0.02, kRadius = 0.03;
  sample::TouchingBodies bodies;
  const auto add = [&](double mass, double radius, const Eigen::Vector3d& centre,
                       const Eigen::Vector3d& velocity) {
    sample::TouchingBodies::Body body;
    body.mass = mass;
    body.inertia = 0.4 * mass * radius * radius * Eigen::Matrix3d::Identity();
    body.centre = centre;
    body.velocity << 0, 0, 0, velocity;
    bodies.bodies.push_back(body);
  };
  add(0.2, kRadius, Eigen::Vector3d::Zero(), Eigen::Vector3d(0, 0, -9.81 * kStep));
  std::vector<Eigen::Vector3d> normals;
  for (int k = 0; k < contacts; ++k) {
    // Opposite each other in pairs, so that they hold.
    const Eigen::Vector3d n =
        k % 2 == 1 ? Eigen::Vector3d(-normals.back()) : sample::random_direction(rng);
    normals.push_back(n);
    add(kTip, 0.008, (kRadius + 0.008) * n, -kForce * kStep / kTip * n);
  }
  for (int k = 0; k < contacts; ++k)
    bodies.touch(soft_finger_block(friction, 0.003), 0, k + 1,
                 kRadius * normals[static_cast<std::size_t>(k)],
                 -normals[static_cast<std::size_t>(k)]);
  Pair out;
  out.first = bodies.problem();
  change_velocities(rng, &bodies);
  out.second = bodies.problem();
  return out;
}

Pair grasp_pair(std::mt19937& rng, int contacts) { return held_pair(rng, contacts, 0.8); }
Pair slip_pair(std::mt19937& rng, int contacts) { return held_pair(rng, contacts, 0.02); }

/// What a method did on many problems.
struct Outcome {
  int solved = 0;
  std::vector<double> us, steps, residuals;
};

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

void add_run(ContactSolver* solver, const ContactProblem& problem, const Eigen::VectorXd& start,
             const ContactSolverOptions& options, Outcome* out) {
  const std::clock_t begin = std::clock();
  double spent = 0;
  int runs = 0;
  for (; spent < kEnough; ++runs) {
    (void)solver->solve(problem, start, options);
    spent = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  }
  const ContactSolution& found = solver->solve(problem, start, options);
  out->us.push_back(1e6 * spent / runs);
  out->steps.push_back(found.newton_steps + found.sweeps + found.interior_steps + found.pivots);
  out->residuals.push_back(found.residual.natural);
  out->solved += found.status == Status::kSolved ? 1 : 0;
}

void print(const char* scene, ContactMethod method, int contacts, const char* start,
           const Outcome& out) {
  fmt::print("{:<8}{:<16}{:>3}  {:<6}{:>7.0f}{:>9.0f}{:>9.0f}{:>11.1f}{:>11.1f}{:>11.1g}\n", scene,
             name_of(method), contacts, start, 100.0 * out.solved / kProblems, median(out.steps),
             largest(out.steps), median(out.us), largest(out.us), median(out.residuals));
}

/// Median times of one method over the number of contacts, cold and warm; prints as it goes.
template <typename Make>
Json series_of(const char* scene, ContactMethod method, const std::vector<int>& sizes, Make make) {
  std::vector<double> x, warm_us;
  for (const int contacts : sizes) {
    std::mt19937 rng(static_cast<unsigned>(contacts));
    ContactSolver solver;
    Outcome cold, warm;
    for (int k = 0; k < kProblems; ++k) {
      const Pair pair = make(rng, contacts);
      ContactSolverOptions options;
      const Eigen::VectorXd answer = solver.solve(pair.first, Eigen::VectorXd(), options).f;
      options.method = method;
      add_run(&solver, pair.second, Eigen::VectorXd(), options, &cold);
      add_run(&solver, pair.second, answer, options, &warm);
    }
    print(scene, method, contacts, "cold", cold);
    print(scene, method, contacts, "warm", warm);
    x.push_back(contacts);
    warm_us.push_back(median(warm.us));
  }
  return {{"name", name_of(method)}, {"x", x}, {"y", warm_us}, {"style", "both"}};
}

template <typename Make>
Json block_of(const char* scene, const std::string& caption, Make make) {
  Json block{{"type", "lines"},       {"caption", caption},
             {"x_label", "contacts"}, {"y_label", "processor time, warm, median [us]"},
             {"log_x", true},         {"log_y", true},
             {"height", 420},         {"series", Json::array()}};
  const std::vector<int> sizes{1, 2, 4, 8, 12, 20};
  for (const ContactMethod method :
       {ContactMethod::kAutomatic, ContactMethod::kNewton, ContactMethod::kGaussSeidel,
        ContactMethod::kInteriorPoint, ContactMethod::kPyramid})
    block["series"].push_back(
        series_of(scene, method,
                  method == ContactMethod::kPyramid ? std::vector<int>{1, 2, 4} : sizes, make));
  return block;
}

Json page() {
  fmt::print("{:<8}{:<16}{:>3}  {:<6}{:>7}{:>9}{:>9}{:>11}{:>11}{:>11}\n", "scene", "method", "n",
             "start", "solved", "steps", "most", "time [us]", "most", "residual");
  return {{"title", "Solvers of the contact problem"},
          {"sections",
           {section("grasp", "Grasps", "",
                    {block_of("grasp", "An object held by fingertips, soft fingers that stick.",
                              grasp_pair)}),
            section("slip", "Slipping grasps", "",
                    {block_of("slip", "The same with friction 0.02: the object slips through.",
                              slip_pair)}),
            section("random", "Random contacts", "",
                    {block_of("random",
                              "Balls, limits, boxes and ties at random on one to three bodies: "
                              "heavily redundant where contacts are many.",
                              random_pair)})}}};
}

}  // namespace
}  // namespace thenar::bench

int main(int argc, char** argv) {
  return thenar::bench::write_chart("contact_chart", argc, argv, thenar::bench::page);
}
