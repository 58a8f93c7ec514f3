#include "pads/pad_scale.h"

#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

void check_scale(double s) {
  require(s > 0 && std::isfinite(s), "wanted a scale of a pad above 0, got {}", s);
}

}  // namespace

PadShape scaled_shape(PadShape shape, double s) {
  check_scale(s);
  require(!shape.skin || s == 1, "a pad with a skin of its own cannot be scaled by {}", s);
  for (double* length : {&shape.length, &shape.width, &shape.height, &shape.bone_length,
                         &shape.bone_width, &shape.bone_height})
    *length *= s;
  for (SkinLayer& layer : shape.layers) layer.thickness *= s;
  return shape;
}

CalibratedLaws scaled_laws(CalibratedLaws laws, double s) {
  check_scale(s);
  if (s != 1) laws.pad_digest.clear();  // of another pad than they were fitted to
  // Forces go as s^2 at equal strain, lengths as s: powers of the scale that keep the laws' form.
  PowerLawConstants& power = laws.power;
  power.force *= std::pow(s, 2 - power.depth_exponent);
  power.patch *= std::pow(s, 1 - 2 * power.patch_exponent);
  SoftFingerConstants& soft = laws.soft_finger;
  soft.force *= std::pow(s, 2 - soft.depth_exponent - soft.radius_exponent);
  soft.patch *= std::pow(s, 1 - 2 * soft.patch_exponent - soft.patch_radius);
  laws.foundation.thickness *= s;
  laws.evidence.depth *= s;
  laws.evidence.force *= s * s;
  return laws;
}

}  // namespace thenar
