// A finger pad pressed on a plate by 1 N: how deep, and over what area?
//
// Prints:
//   1.0 N: 1.75 mm deep, 80 mm2
#include <cstdio>

#include <thenar/pads.h>

int main() {
  thenar::PressRequest request;
  request.force = 1;
  const thenar::PressInstant end = thenar::press_pad(request).instants.back();
  std::printf("%.1f N: %.2f mm deep, %.0f mm2\n", end.force, 1e3 * end.depth, 1e6 * end.area);
}
