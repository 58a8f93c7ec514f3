// How does the extensor mechanism of a middle finger share a pull of the extensor and the
// lumbrical?
//
// Prints:
//   trusted: yes
//   slips: central 0.62 N, radial 1.42 N, ulnar 1.25 N, terminal 2.11 N
//   MCP3_FE  -21.19 N mm
//   MCP3_AA    0.76 N mm
//   PIP3     -12.87 N mm
//   DIP3      -7.84 N mm
#include <cstdio>

#include <thenar/thenar.h>

int main() {
  // The finger with Winslow's net of bands instead of fixed shares of tension.
  thenar::DigitRequest request;
  request.subject = "synek2019_middle";
  request.posture.named = {{"MCP3_FE", 20}, {"PIP3", 30}, {"DIP3", 20}};
  request.posture.unit = thenar::PostureUnit::kTyped;
  const thenar::DigitCase finger = thenar::build_digit(request, thenar::Hood::kFloatingNet);
  const thenar::DigitTendons& tendons = *finger.tendons;

  // The net comes to rest, starting from the straight finger.
  const Eigen::VectorXd& q = finger.grid.postures.front();
  const Eigen::VectorXd t = thenar::tensions(finger, {{"EDC", 2.9}, {"LU", 0.4}});
  const thenar::TendonTorque rest = tendons.pull(q, t, thenar::start_from_straight(tendons, q, t));
  std::printf("trusted: %s\n", thenar::trusted(rest.status) ? "yes" : "no");
  std::printf("slips: central %.2f N, radial %.2f N, ulnar %.2f N, terminal %.2f N\n",
              rest.slips.central, rest.slips.radial, rest.slips.ulnar, rest.slips.terminal);

  // What that does to the joints: extension is negative.
  for (Eigen::Index j = 0; j < rest.tau.size(); ++j)
    std::printf("%-8s %6.2f N mm\n",
                finger.bones().names.coordinates[static_cast<std::size_t>(j)].c_str(),
                rest.tau[j] / thenar::kNmm);
}
