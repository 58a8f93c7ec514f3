// A cube of 100 g falls by 0.2 m onto a floor: where is it a second later?
//
// Prints:
//   done: centre of the cube at 25.0 mm, speed 0.0 mm/s
#include <cstdio>

#include <thenar/scenes.h>

int main() {
  thenar::SceneBuilder scene("cube");
  scene.add_floor();
  scene.add_box("cube", {0.05, 0.05, 0.05}, 0.1, {0, 0, 0.225});
  scene.set_contact(0.5);
  scene.spec().stepping.duration = 1;
  const thenar::SceneResult fall = thenar::simulate_scene(scene.spec());
  const thenar::RunMeasures& run = fall.measures;
  std::printf("%s: centre of the cube at %.1f mm, speed %.1f mm/s\n",
              thenar::name_of(fall.run.status).c_str(), 1e3 * run.X_WB.back()[1].p.z(),
              1e3 * run.velocity[1].linear.norm());
}
