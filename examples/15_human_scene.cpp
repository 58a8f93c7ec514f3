// A ball falls onto the bones and skin of a human hand: does it stay above it?
//
// Prints:
//   done
#include <cstdio>

#include <thenar/scenes.h>

int main() {
  thenar::SceneBuilder scene("ball on a hand");
  scene.add_hand("human:skewed");
  scene.add_ball("ball", 0.02, 0.05, {0, 0, 0.15});
  scene.set_contact(0.8);
  scene.spec().stepping.duration = 0.5;
  const thenar::SceneResult run = thenar::simulate_scene(scene.spec());
  std::printf("%s: %zu contacts at the end, ball at %.0f mm\n",
              thenar::name_of(run.run.status).c_str(), run.run.samples.back().contacts.size(),
              1e3 * run.measures.X_WB.back()[0].p.z());
}
