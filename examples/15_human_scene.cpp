// A human hand hit by a ball of 50 g, its joints free: does energy balance to the end?
//
// Prints:
//   done: energy balances: yes
#include <cstdio>

#include <thenar/scenes.h>

int main() {
  thenar::SceneBuilder scene("a ball on a hand");
  scene.add_hand("human:skewed");
  scene.add_ball("ball", 0.02, 0.05, {0, 0, 0.15}).velocity.linear = {0, 0, -1};
  scene.set_contact(0.8);
  scene.spec().stepping.duration = 0.2;
  const thenar::SceneResult hit = thenar::simulate_scene(scene.spec());
  std::printf("%s: energy balances: %s\n", thenar::name_of(hit.run.status).c_str(),
              hit.measures.balance && hit.measures.balance->holds() ? "yes" : "no");
}
