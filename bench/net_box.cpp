// How smoothly the slips of a net share over the joint box, and whether its rest depends on the
// way.
//
//   net_box NET.toml SUBJECT.toml DIGIT [PAIRS [SEED]]
//
// For each load, each muscle alone and all together: random pairs of postures in the box of flexion
// and deviation of the knuckle and of the interphalangeal joints, once with the end joint at two
// thirds of the middle one and once apart from it. The net is followed from one posture of a pair
// to the other in steps of half a degree, and each posture is reached a second time from the
// straight finger. Printed: the largest change of a slip's tension per degree, snaps, and the
// largest difference of torque between two ways to the same posture.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/units.h"
#include "bench/run_program.h"
#include "tendons/linear_tendons.h"
#include "tendons/net/net_continuation.h"
#include "tendons/net/posture_sweep.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

/// A load of some muscles.
struct BoxLoad {
  std::string name;
  std::vector<std::pair<std::string, double>> tension;  // muscle, [N]
};

std::vector<BoxLoad> box_loads() {
  return {{"EDC 2.9 N", {{"EDC", 2.9}}},
          {"EDC 10 N", {{"EDC", 10}}},
          {"RI 5 N", {{"RI", 5}}},
          {"LU 0.4 N", {{"LU", 0.4}}},
          {"LU 2.9 N", {{"LU", 2.9}}},
          {"UI 4 N", {{"UI", 4}}},
          {"EDC 3 N, LU 0.4 N", {{"EDC", 3}, {"LU", 0.4}}},
          {"EDC 3 N, RI 5 N, UI 4 N", {{"EDC", 3}, {"RI", 5}, {"UI", 4}}},
          {"EDC 3 N, RI 5 N, LU 0.4 N, UI 4 N", {{"EDC", 3}, {"RI", 5}, {"LU", 0.4}, {"UI", 4}}}};
}

VectorXd tension_of(const BoxLoad& load, const std::vector<std::string>& muscles) {
  VectorXd t = VectorXd::Zero(static_cast<Eigen::Index>(muscles.size()));
  for (const auto& [muscle, tension] : load.tension) {
    const auto at = std::find(muscles.begin(), muscles.end(), muscle);
    require(at != muscles.end(), "no muscle '{}'", muscle);
    t[at - muscles.begin()] = tension;
  }
  return t;
}

/// A posture of the box, from the straight finger [rad] (4).
VectorXd any_in_box(std::mt19937& rng, bool coupled) {
  const auto angle = [&](double low, double high) {
    return kDegree * std::uniform_real_distribution<double>(low, high)(rng);
  };
  VectorXd q(4);
  q << angle(-20, 80), angle(-15, 15), angle(0, 90), angle(0, 60);
  if (coupled) q[3] = q[2] * 2 / 3;
  return q;
}

/// What was seen under one load.
struct BoxFinding {
  double steepest = 0;  // change of a slip's tension per degree of the widest joint [N]
  VectorXd where;       // posture [rad]
  int snaps = 0, steps = 0;
  int apart = 0;      // postures that two ways reach with torques that differ by more than 1 %
  double differ = 0;  // largest such difference, per torque [1]
};

void follow_pair(const NetTendons& tendons, const VectorXd& t, const VectorXd& from,
                 const VectorXd& to, BoxFinding& out) {
  // From the straight finger to one posture, and in small steps to the other.
  NetEquilibrium rest = follow_from_straight(tendons, from, t).rest;
  const double widest = (to - from).cwiseAbs().maxCoeff() / kDegree;
  const int steps = std::max(1, static_cast<int>(std::ceil(2 * widest)));
  VectorXd at = from;
  for (int i = 1; i <= steps; ++i) {
    const VectorXd next = from + (to - from) * i / steps;
    const NetContinuation walk = follow_net(tendons, rest, {at, t}, {next, t});
    const SlipTension before = slip_tension(tendons.net(), rest),
                      after = slip_tension(tendons.net(), walk.rest);
    const double change = std::max(std::abs(after.central - before.central),
                                   std::abs(after.terminal - before.terminal)) /
                          (widest / steps);
    if (change > out.steepest) {
      out.steepest = change;
      out.where = next;
    }
    out.snaps += static_cast<int>(walk.snaps.size());
    ++out.steps;
    rest = walk.rest;
    at = next;
  }
  // The same posture by way of the straight finger.
  const VectorXd here = tendons.torque(to, t, rest),
                 there = tendons.torque(to, t, follow_from_straight(tendons, to, t).rest);
  const double differ = (here - there).norm() / std::max(here.norm(), there.norm());
  out.differ = std::max(out.differ, differ);
  out.apart += differ > 0.01 ? 1 : 0;
}

void run(int argc, char** argv) {
  require(argc >= 4 && argc <= 6, "wanted NET.toml SUBJECT.toml DIGIT [PAIRS [SEED]]");
  const Subject subject = read_subject(argv[2]);
  auto separate = build_linear_tendons(subject, argv[3], {Path::kViaPoint, Hood::kSeparate});
  BuiltNet built = build_net(subject, separate->digit(), read_net(argv[1]));
  const NetTendons tendons(std::move(separate), std::move(built));
  const int pairs = argc > 4 ? std::stoi(argv[4]) : 20;
  const auto seed = static_cast<unsigned>(argc > 5 ? std::stoul(argv[5]) : 1);
  std::cout << "load                                end joint  N per deg  at MCP, dev., PIP, DIP"
               "        steps  snaps  apart  largest\n";
  for (const BoxLoad& load : box_loads())
    for (const bool coupled : {true, false}) {
      std::mt19937 rng(seed);
      BoxFinding found;
      const VectorXd t = tension_of(load, tendons.digit().names.muscles);
      const VectorXd& straight = tendons.net().frame.straight;
      for (int i = 0; i < pairs; ++i) {
        const VectorXd from = straight + any_in_box(rng, coupled);
        follow_pair(tendons, t, from, straight + any_in_box(rng, coupled), found);
      }
      const VectorXd where = (found.where - straight) / kDegree;
      std::cout << fmt::format(
                       "{:<35} {:<9} {:>9.3f}   {:>6.1f} {:>6.1f} {:>6.1f} {:>6.1f} {:>8} "
                       "{:>6} {:>6} {:>8.1e}\n",
                       load.name, coupled ? "coupled" : "apart", found.steepest, where[0], where[1],
                       where[2], where[3], found.steps, found.snaps, found.apart, found.differ)
                << std::flush;
    }
}

}  // namespace
}  // namespace thenar

int main(int argc, char** argv) {
  return thenar::bench::run_program("net_box", [&] { thenar::run(argc, argv); });
}
