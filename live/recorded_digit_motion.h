#pragma once

/// Playback of a recorded motion of one digit.

#include "api/read_motion.h"
#include "live/digit_picture.h"
#include "live/recorded_timeline.h"

namespace thenar {

/// Recorded motion of a digit. Angles, speeds, tensions and activations are interpolated linearly
/// between recorded instants. A net is in equilibrium under the interpolated tensions, followed
/// from the straight finger.
class RecordedDigitMotion final : public RecordedTimeline {
 public:
  explicit RecordedDigitMotion(RecordedDigit run);

  [[nodiscard]] const LiveShape& shape() const override { return picture_.shape(); }
  [[nodiscard]] LiveInstant instant() const override;
  /// Returns joints (without efforts), energy and muscles; the file holds no bodies and no
  /// contacts. Muscles give their tensions, and their activations as "FDP activation".
  [[nodiscard]] TimelineState state(const MotionParts& parts) const override;
  /// Returns an empty quality: the file records none.
  [[nodiscard]] MotionQuality quality() const override { return {}; }
  [[nodiscard]] std::vector<std::string> warnings() const override { return run_.warnings; }
  [[nodiscard]] const std::string& name() const override { return name_; }

 private:
  [[nodiscard]] MotionEnergy energy() const;

  RecordedDigit run_;
  std::string name_;  // "subject/digit"
  DigitPicture picture_;
};

}  // namespace thenar
