// A finger of one's own, described in the program: what does its tip push?
//
// Prints:
//   palmar 2.5 N
#include <cstdio>

#include <thenar/hands.h>

int main() {
  // One hinge 40 mm from the tip, one tendon 10 mm from its axis.
  thenar::TipForceRequest request;
  request.digit.subject = "mine";
  request.digit.subject_text = R"(
    name = "mine"
    side = "right"
    base = "palm"
    source = "own"
    sources = {own = "A finger of one joint"}
    segment = [{name = "palm"}, {name = "bone"}]
    joint = [{name = "MCP", parent = "palm", child = "bone", direction = [0, 0, 1], point_mm = [40, 0, 0]}]
    strand = [{name = "FDP", arms_mm = {MCP = 10}}]
    muscle = [{name = "FDP", max_force_N = 100}]
    [[digit]]
    name = "index"
    tip_segment = "bone"
    tip_mm = [0, 0, 0]
    proximal = [1, 0, 0]
    dorsal = [0, 1, 0]
    radial = [0, 0, 1])";
  request.tension = {{"FDP", 10}};
  std::printf("palmar %.1f N\n", -thenar::compute_tip_force(request).points.front().force.y());
}
