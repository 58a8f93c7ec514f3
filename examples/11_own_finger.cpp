// What does the tip of a finger of one's own push, described in the program?
//
// Prints:
//   palmar 5.0 N
#include <cstdio>

#include <thenar/hands.h>

int main() {
  // One hinge at the origin, one bone of 40 mm, one tendon at 20 mm from the axis.
  thenar::TipForceRequest request;
  request.digit.subject = "mine";
  request.digit.subject_text = R"(
  )";
  request.tension = {{"FDP", 10}};
  const thenar::TipForcePoint at = thenar::compute_tip_force(request).points.front();
  std::printf("palmar %.1f N\n", -(at.tip_axes->transpose() * at.force)[1]);
}
