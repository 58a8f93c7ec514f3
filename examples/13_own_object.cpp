// Two robot hands on a mesh of one's own: how often does each take it?
//
// Prints:
//   barrett: 1 of 4
//   allegro: 1 of 4
#include <cstdio>

#include <thenar/grasps.h>

int main() {
  // A tetrahedron with edges of 85 mm.
  thenar::TriangleMesh mesh{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 4)};
  mesh.vertices << 30, -30, -30, 30, 30, -30, 30, -30, 30, 30, -30, -30;
  mesh.vertices /= 1e3;
  mesh.triangles << 0, 0, 0, 1, 1, 2, 3, 3, 2, 3, 1, 2;
  thenar::CompareRequest request;
  request.hands = {"barrett", "allegro"};
  request.objects = {};
  request.own_objects = {thenar::make_body("tetrahedron", thenar::mesh_shape(mesh), 0.05)};
  request.approaches = 4;
  for (const thenar::HandOnObject& cell : thenar::compare_hands(request).comparison.cells)
    std::printf("%s: %d of %d\n", cell.hand.c_str(), cell.closures, cell.approaches);
}
