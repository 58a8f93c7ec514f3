// How well does a robot hand hold an object?
//
// Prints:
//   grasped, 4 contacts
//   force closure: yes
//   epsilon: 0.10
#include <cstdio>

#include <thenar/grasps.h>

int main() {
  // A Barrett hand above a bobbin on a post: data/worlds/barrett_bobbin.toml.
  thenar::GraspRequest request;
  request.world.world = "barrett_bobbin";
  request.world.hand = "barrett";

  // Goes along the palm until it touches, closes, finds the contacts, and measures.
  const thenar::GraspResult result = thenar::measure_grasp(request);
  const thenar::Epsilon& quality = result.grasp.quality;
  std::printf("%s, %zu contacts\n", thenar::name_of(result.grasp.outcome).c_str(),
              result.grasp.contacts.size());
  std::printf("force closure: %s\n", quality.force_closure ? "yes" : "no");
  std::printf("epsilon: %.2f\n", quality.lower);
}
