#pragma once

/// Our speed against a rival's on the same task, measured in turns in the same run.

#include <functional>
#include <string>
#include <vector>

namespace thenar::bench {

/// Keeps the compiler from dropping a result.
template <typename T>
void keep(const T& value) {
  asm volatile("" : : "r,m"(&value) : "memory");
}

/// One comparison; each call of `ours` or `rival` does the whole task once.
struct Duel {
  std::string name;
  std::function<void()> ours;
  std::function<void()> rival;
  double required = 1;   // least rival / ours [1]
  double error = 0;      // greatest difference of the two answers
  double tolerance = 0;  // that `error` must not exceed
};

/// One line of the table.
struct Row {
  std::string name;
  double ours = 0;      // median time of one task [us]
  double rival = 0;     // median time of one task [us]
  double ratio = 0;     // median of rival / ours over the turns [1]
  double required = 0;  // [1]
  double error = 0;
  double tolerance = 0;
  std::string note = {};  // lines to print below it

  [[nodiscard]] bool pass() const { return ratio >= required && error <= tolerance; }
};

/// How long to measure.
struct Patience {
  int turns = 41;          // of ours and rival, one after the other
  double seconds = 0.005;  // of each, per turn; a slow task runs once
};

/// The middle value, of an even number the upper one; 0 without values.
[[nodiscard]] double median(std::vector<double> values);

[[nodiscard]] Row measure(const Duel& duel, const Patience& patience = {});

// One function a file.
[[nodiscard]] Row ratio_kinematics();   // ratio_kinematics.cpp
[[nodiscard]] Row ratio_chain();        // the same task on the templated chain
[[nodiscard]] Row ratio_force_map();    // ratio_force_map.cpp
[[nodiscard]] Row ratio_fit();          // ratio_fit.cpp; the rival is a limit
[[nodiscard]] Row ratio_fit_of_many();  // the same
[[nodiscard]] Row ratio_fit_jacobian();
[[nodiscard]] Row ratio_posterior_lanes();  // ratio_posterior_evaluations.cpp; the rival is ours
[[nodiscard]] Row ratio_posterior_gradient();
[[nodiscard]] Row ratio_posterior_jets();
[[nodiscard]] Row ratio_sampler();  // ratio_sampler.cpp
[[nodiscard]] Row ratio_sampler_in_all();
[[nodiscard]] Row ratio_epsilon();  // ratio_epsilon.cpp
[[nodiscard]] Row ratio_epsilon_fine();
[[nodiscard]] Row ratio_distance_of_point();  // ratio_separation.cpp
[[nodiscard]] Row ratio_separation();
[[nodiscard]] Row ratio_separation_mesh();
[[nodiscard]] Row ratio_grasp();           // ratio_grasp.cpp; the rival is a limit
[[nodiscard]] Row ratio_net_relaxation();  // ratio_net.cpp
[[nodiscard]] Row ratio_net_kinsol();
[[nodiscard]] Row ratio_net_masses();
[[nodiscard]] Row ratio_net_tuned_masses();  // no error control
[[nodiscard]] Row ratio_growth_of_guard();   // ratio_growth.cpp; the rival is ours on half a file
[[nodiscard]] Row ratio_growth_of_keys();
[[nodiscard]] Row ratio_growth_of_errors();
[[nodiscard]] Row ratio_growth_of_unknowns();
[[nodiscard]] Row ratio_growth_of_soup();
[[nodiscard]] Row ratio_closed_loop();  // ratio_live.cpp; the rival is ours by a longer way
[[nodiscard]] Row ratio_digit_slider();
[[nodiscard]] Row ratio_hand_instant();
[[nodiscard]] Row ratio_pad_laws();

}  // namespace thenar::bench
