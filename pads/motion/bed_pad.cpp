#include "pads/motion/bed_pad.h"

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

PadContact BedPad::try_step(const Pose<double>& X_PO, double seconds) {
  // Step the bed from the kept state.
  moved_ = kept_;
  moved_.X_PO = X_PO;
  const BedContact contact =
      bed_->step(*object_.shape, X_PO, object_.friction, seconds, moved_.bed);
  PadContact out;
  if (contact.behind) {
    moved_ = kept_;
    return behind_object();
  }
  out.gap = contact.gap;
  if (contact.force <= 0) return out;
  out.push = contact.push;
  out.force = contact.force;
  out.area = contact.area;
  out.stick = contact.stick;
  out.centre = contact.centre;
  out.normal = contact.normal;
  return out;
}

void BedPad::accept_step() { kept_ = moved_; }

double BedPad::energy() const {
  if (kept_.bed.elastic.size() == 0) return 0;
  double out = 0;
  // Integrate the work of withdrawing the object, by the five-point Gauss rule.
  const BedContact at = bed_->press(*object_.shape, kept_.X_PO);
  const double nodes[] = {0.046910077, 0.230765345, 0.5, 0.769234655, 0.953089923};
  const double weights[] = {0.118463443, 0.239314335, 0.284444444, 0.239314335, 0.118463443};
  for (int i = 0; i < 5 && at.depth > 0; ++i) {
    Pose<double> X = kept_.X_PO;
    X.p -= nodes[i] * at.depth * at.normal;
    out += weights[i] * at.depth * bed_->press(*object_.shape, X).push.force.dot(at.normal);
  }
  // Add the energy of the tangential springs, f^2 / (2 G A / h) each.
  const FoundationColumns& columns = bed_->columns();
  for (Eigen::Index i = 0; i < columns.area.size() && bed_->constants().shear > 0; ++i)
    if (kept_.bed.touching[i])
      out += 0.5 * kept_.bed.shear.col(i).squaredNorm() * columns.thickness[i] /
             (bed_->constants().shear * columns.area[i]);
  return out;
}

double BedPad::reach() const { return bed_->columns().skin.colwise().norm().maxCoeff(); }

}  // namespace thenar
