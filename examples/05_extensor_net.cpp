// How does the extensor mechanism of a middle finger share a pull of the extensor and the
// lumbrical?
//
// Prints:
//   trusted: yes
//   slips: central 1.41 N, radial 1.17 N, ulnar 1.31 N, terminal 2.22 N
//   MCP3_FE  -23.16 N mm
//   MCP3_AA    0.60 N mm
//   PIP3     -12.89 N mm
//   DIP3      -8.27 N mm
#include <cstdio>

#include <thenar/tendons.h>

int main() {
  // The finger with the net of its extensor hood; muscles that are not named are slack.
  thenar::TendonRequest request;
  request.digit.subject = "synek2019_middle";
  request.digit.posture.named = {{"MCP3_FE", 20}, {"PIP3", 30}, {"DIP3", 20}};
  request.digit.posture.unit = thenar::PostureUnit::kTyped;
  request.tension = {{"EDC", 2.9}, {"LU", 0.4}};

  // The net comes to rest, starting from the straight finger.
  const thenar::TendonSolveResult answer = thenar::solve_tendons(request);
  const thenar::TendonTorque& rest = answer.point.pull;
  std::printf("trusted: %s\n", thenar::is_trusted(rest.status) ? "yes" : "no");
  std::printf("slips: central %.2f N, radial %.2f N, ulnar %.2f N, terminal %.2f N\n",
              rest.slips.central, rest.slips.radial, rest.slips.ulnar, rest.slips.terminal);

  // What that does to the joints: extension is negative.
  const std::vector<std::string>& joints = answer.loaded.bones().names.coordinates;
  for (std::size_t j = 0; j < joints.size(); ++j)
    std::printf("%-8s %6.2f N mm\n", joints[j].c_str(),
                rest.tau[static_cast<Eigen::Index>(j)] / thenar::kNewtonMillimetre);
}
