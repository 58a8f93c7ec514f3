#pragma once

/// A motion of one digit that was recorded, shown again.

#include "api/read_motion.h"
#include "live/digit_picture.h"
#include "live/recorded_timeline.h"

namespace thenar {

/// A recorded motion of a digit on its line of time. Between two instants that it kept, angles,
/// speeds, tensions and activations go straight; a net is at rest under what they are there, as
/// it comes there from the straight finger.
class RecordedDigitMotion final : public RecordedTimeline {
 public:
  explicit RecordedDigitMotion(RecordedDigit run);

  [[nodiscard]] const LiveShape& shape() const override { return picture_.shape(); }
  [[nodiscard]] LiveInstant instant() const override;
  /// Joints have no efforts, and there are no bodies and no contacts: the file has none of them.
  /// Muscles have their tensions, and activations as "FDP activation".
  [[nodiscard]] TimelineState state(const MotionParts& parts) const override;
  /// Nothing of that is recorded.
  [[nodiscard]] MotionQuality quality() const override { return {}; }
  [[nodiscard]] std::vector<std::string> warnings() const override { return run_.warnings; }
  [[nodiscard]] const std::string& name() const override { return name_; }

 private:
  [[nodiscard]] MotionEnergy energy() const;

  RecordedDigit run_;
  std::string name_;  // of the subject and its digit
  DigitPicture picture_;
};

}  // namespace thenar
