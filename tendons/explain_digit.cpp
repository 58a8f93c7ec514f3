#include "tendons/explain_digit.h"

#include <fmt/format.h>

#include "base/lists.h"

namespace thenar {
namespace {

/// Sorts every part of the subject into kept and dropped.
class Explainer {
 public:
  Explainer(const Subject& subject, const std::string& digit, const TendonOptions& options,
            const TendonDigit& built)
      : digit_(digit), options_(options), built_(built) {
    for (const Segment& segment : subject.segments) explain_segment(segment);
    for (const JointAxis& joint : subject.joints) explain_joint(joint);
    for (const Strand& strand : subject.strands) explain_strand(strand);
    for (const MuscleUnit& muscle : subject.muscles) explain_muscle(muscle);
    for (const Digit& digit_of : subject.digits)
      if (digit_of.name == digit) explain_hood(digit_of);
  }

  /// Returns the explanation, once.
  DigitExplanation take() { return std::move(explanation_); }

 private:
  void drop(const std::string& what, const std::string& name, const std::string& reason) {
    explanation_.dropped.push_back({what, name, reason});
  }

  [[nodiscard]] bool is_kept_segment(const std::string& name) const {
    return built_.skeleton.link_of_segment.count(name) > 0;
  }

  void explain_segment(const Segment& segment) {
    // Keep segments with links between the wrist and the tip.
    if (is_kept_segment(segment.name))
      explanation_.segments.push_back(segment.name);
    else
      drop("segment", segment.name, fmt::format("not between wrist and {} tip", digit_));
  }

  void explain_joint(const JointAxis& joint) {
    // Keep hinges; drop others for one of three reasons.
    if (contains(built_.names.hinges, joint.name)) {
      explanation_.joints.push_back(joint.name);
    } else if (!is_kept_segment(joint.child)) {
      drop("joint", joint.name, "moves a segment that is dropped");
    } else if (options_.frozen.count(joint.name) > 0) {
      drop("joint", joint.name,
           fmt::format("frozen: {} and {} are welded", joint.parent, joint.child));
    } else {
      drop("joint", joint.name,
           joint.coupling ? "coupled to a frozen joint"
                          : "welded: other digits share it, and the question is of one tip");
    }
  }

  void explain_strand(const Strand& strand) {
    if (contains(built_.names.strands, strand.name))
      explanation_.strands.push_back(strand.name);
    else if (strand.path.empty() && strand.arms.empty())
      drop("strand", strand.name, "has neither path points nor moment arms");
    else
      drop("strand", strand.name, "crosses no kept joint");
  }

  void explain_muscle(const MuscleUnit& muscle) {
    if (contains(built_.names.muscles, muscle.name))
      explanation_.muscles.push_back(muscle.name);
    else
      drop("muscle", muscle.name, "its strand crosses no kept joint");
  }

  void explain_hood(const Digit& digit) {
    // Describe a missing hood, an unused hood, or its muscles and slips.
    if (!digit.hood) {
      explanation_.hood = "none stated: every muscle pulls its own strand";
    } else if (!built_.model.hood) {
      explanation_.hood = "dropped: every muscle pulls its own strand";
      drop("hood", digit.name, "separate tendons were asked for");
    } else {
      const HoodRule& rule = *digit.hood;
      explanation_.hood =
          fmt::format("{} feed central slip {}, bands {} and {}, terminal slip {}",
                      fmt::join(transformed(rule.branches, &HoodBranch::muscle), ", "),
                      rule.central_slip, rule.radial_band, rule.ulnar_band, rule.terminal_slip);
    }
  }

  const std::string& digit_;
  const TendonOptions& options_;
  const TendonDigit& built_;
  DigitExplanation explanation_;
};

}  // namespace

DigitExplanation explain_digit(const Subject& subject, const std::string& name,
                               const TendonOptions& options, const TendonDigit& built) {
  return Explainer(subject, name, options, built).take();
}

}  // namespace thenar
