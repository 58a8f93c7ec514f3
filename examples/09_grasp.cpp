// How well does a robot hand hold an object?
//
// Prints:
//   grasped, 4 contacts
//     palm
//     finger 1 L3
//     finger 2 L3
//     finger 3 L2
//   force closure: yes, epsilon 0.10
#include <cstdio>

#include <thenar/thenar.h>

int main() {
  // A Barrett hand above a bobbin on a post: data/worlds/barrett_bobbin.toml.
  thenar::WorldRequest request;
  request.world = "barrett_bobbin";
  const thenar::WorldCase world = thenar::open_world(request, false);

  // Go along the palm until it touches, close, find the contacts, measure.
  const thenar::CollisionHand hand =
      thenar::collision_hand(*world.hand.named.hand, world.scene.materials);
  const thenar::Grasp grasp = thenar::grasp(hand, world.hand.X_WH, world.hand.q, world.scene);
  std::printf("%s, %d contacts\n", thenar::name_of(grasp.outcome).c_str(),
              static_cast<int>(grasp.contacts.size()));
  for (const thenar::HandContact& touch : grasp.contacts)
    std::printf("  %s\n",
                hand.hand->surfaces()[static_cast<std::size_t>(touch.surface)].name.c_str());
  std::printf("force closure: %s, epsilon %.2f\n", grasp.quality.force_closure ? "yes" : "no",
              grasp.quality.lower);
}
