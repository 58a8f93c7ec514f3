// Prints how many times faster than its rival each part is, and whether that is enough.
// Exit code 1 if any row misses. Medians over turns taken one after the other in this very run.

#include "bench/ratios.h"

#include <fmt/format.h>

int main() {
  using namespace thenar::bench;
  fmt::print("{:<44}{:>11}{:>12}{:>9}{:>10}{:>10}{:>11}\n", "", "ours [us]", "rival [us]", "ratio",
             "required", "error", "verdict");
  bool pass = true;
  for (const auto& row_function : {ratio_kinematics,      ratio_chain,
                                   ratio_force_map,       ratio_fit,
                                   ratio_fit_of_many,     ratio_fit_jacobian,
                                   ratio_posterior_lanes, ratio_posterior_gradient,
                                   ratio_posterior_jets,  ratio_sampler,
                                   ratio_sampler_in_all,  ratio_epsilon,
                                   ratio_epsilon_fine,    ratio_distance_of_point,
                                   ratio_separation,      ratio_separation_mesh,
                                   ratio_grasp,           ratio_net_relaxation,
                                   ratio_net_kinsol,      ratio_net_masses,
                                   ratio_net_tuned_masses,
                                   ratio_growth_of_guard, ratio_growth_of_keys,
                                   ratio_growth_of_errors, ratio_growth_of_unknowns,
                                   ratio_growth_of_soup,  ratio_closed_loop,
                                   ratio_digit_slider,    ratio_hand_instant,
                                   ratio_pad_laws}) {
    const Row row = row_function();
    fmt::print(
        "{:<44}{:>11.3f}{:>12.2f}{:>9.1f}{:>10}{:>10}{:>11}\n", row.name, row.ours, row.rival,
        row.ratio, row.required > 0 ? fmt::format("{:g}", row.required) : "none",
        row.tolerance > 0 ? fmt::format("{:.1e}", row.error) : "-", row.pass() ? "PASS" : "MISS");
    fmt::print("{}", row.note);
    pass = pass && row.pass();
  }
  fmt::print(
      "Rival: Simbody 3.7 as Debian packages it; built from source with -O3 and without asserts\n"
      "it is 2.0 to 2.8 times faster, and the ratios as much smaller. The rival of a fit is the "
      "time that it may take.\n"
      "Who uses what: fits run neither of the first rows but the compiled chain "
      "(kinematics_fit/kernel/);\n"
      "FastKinematics and force_map, which no command calls, stand with the tests.\n"
      "Thumb forces in lanes: the rival runs the same steps of ours, point after point.\n"
      "Effective draws: NUTS, 8 chains in lanes, against Haario's adaptive Metropolis on the "
      "scalar\n"
      "kernel; least bulk ESS of 20 entries, R-hat below 1.01 in both, processor time of one "
      "core.\n"
      "Both start about the modes and know the covariance there; in the second row the rival "
      "learns\n"
      "its own, and search and warm-up are spread over 10,000 draws. The error is that of means, "
      "in\n"
      "Monte Carlo errors.\n"
      "The net starts from its rest 0.02 rad away; its error is that of tensions [N]. Point "
      "masses\n"
      "run by Runge and Kutta's steps of controlled error; stepped by semi-explicit Euler, at a "
      "step\n"
      "just below where it blows up, which takes a search for every net, they rest sooner.\n"
      "Epsilon: means over grasps of three to six contacts; ours certifies a gap of 1e-3 on the "
      "true\n"
      "cones, the rival takes the whole hull of pyramids, whose own error quality_chart prints.\n"
      "Signed distances, to a mesh of 5,100 triangles at 0.05 mm: of a point, where FCL is given "
      "a\n"
      "triangle of a micrometre; and of a body 1 to 20 mm off, a capsule or a mesh of it, where "
      "FCL\n"
      "takes 1,600 or 224 triangles. FCL's have no sign, and of meshes it heeds no tolerance.\n"
      "Grasps: processor time of approach, closing, contacts and quality, on nine "
      "superellipsoids;\n"
      "the rival is the time that one may take. THENAR_BENCH_ALL_GRASPS=1 does all 14,400.\n"
      "Files: three times half of one takes as long as all of it if time grows by the power "
      "1.6.\n"
      "Live sessions: requests and answers as text, sliders and instants, against a step that "
      "tells\n"
      "nothing, a digit that is built anew, a grasp from the start, and a press of elements.\n");
  return pass ? 0 : 1;
}
