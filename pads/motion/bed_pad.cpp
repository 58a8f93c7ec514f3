#include "pads/motion/bed_pad.h"

#include <cmath>

#include "base/error.h"

namespace thenar {

BedPad::BedPad(std::shared_ptr<const FoundationBed> bed, RigidObject object,
               const Pose<double>& X_PO)
    : bed_(std::move(bed)), object_(std::move(object)) {
  require(bed_ && object_.shape && object_.friction >= 0,
          "a pad in motion wants an object with a shape and a friction >= 0");
  require(object_.friction == 0 || bed_->constants().shear > 0,
          "a bed without shear has no stiffness across: a pad in motion would hold nothing");
  kept_.X_PO = moved_.X_PO = X_PO;
}

std::unique_ptr<MovingPad> BedPad::clone() const {
  return std::make_unique<BedPad>(bed_, object_, kept_.X_PO);
}

PadContact BedPad::move(const Pose<double>& X_PO, double seconds) {
  moved_ = kept_;
  moved_.X_PO = X_PO;
  const BedContact contact =
      bed_->step(*object_.shape, X_PO, object_.friction, seconds, moved_.bed);
  PadContact out;
  if (contact.behind) {
    moved_ = kept_;
    return behind_object();
  }
  if (contact.force <= 0) return out;
  out.push = contact.push;
  out.force = contact.force;
  out.area = contact.area;
  out.stick = contact.stick;
  out.centre = contact.centre;
  out.normal = contact.normal;
  return out;
}

void BedPad::keep() { kept_ = moved_; }

}  // namespace thenar
