#include "data/io/subject.h"

#include <algorithm>

#include "base/error.h"
#include "data/io/experiment.h"
#include "data/io/subject_parts.h"

namespace thenar {
namespace {

using internal::SubjectDraft;

/// Reads the experiments to which the numbers were fitted, each once.
void read_calibration(TomlTable& top, Subject& subject) {
  for (TomlTable& row : top.tables("calibrated_on")) {
    // All specimens of a publication, or one.
    CalibratedOn seen;
    seen.source = row.text_or("source", "");
    if (seen.source.empty()) {
      seen.experiment = row.text("experiment");
      seen.specimen = row.text("specimen");
    }
    for (const CalibratedOn& other : subject.calibrated_on) {
      if (other.experiment != seen.experiment || other.source != seen.source) continue;
      const char* key = seen.source.empty() ? "experiment" : "source";
      row.fail(fmt::format("{} '{}' is named twice", key, seen.experiment + seen.source), key);
    }
    row.done();
    subject.calibrated_on.push_back(std::move(seen));
  }
}

void read_header(TomlTable& top, SubjectDraft& draft) {
  Subject& subject = draft.subject;
  subject.name = top.text("name");
  subject.description = top.text_or("description", "");
  subject.side = top.choice("side", {"right", "left"});
  subject.base = top.text_or("base", "");
  subject.reference_length =
      top.number_or(Dimension::kLength, "reference_length", 0, Range::kPositive);
  draft.specific_tension =
      top.number_or(Dimension::kStress, "specific_tension", 0, Range::kPositive);
  if (std::optional<TomlTable> lengths = top.table("lengths"))
    subject.lengths = lengths->all(Dimension::kLength);
  read_calibration(top, subject);
}

/// Refuses segments that neither are the base nor hang on a joint.
void check_segments_move(const TomlTable& top, const Subject& subject) {
  for (const Segment& segment : subject.segments) {
    const auto moves = [&](const JointAxis& joint) { return joint.child == segment.name; };
    if (segment.name != subject.base && !any_of(subject.joints, moves))
      top.fail(fmt::format("segment '{}' is not the base and no joint moves it", segment.name));
  }
}

}  // namespace

bool has_seen(const std::vector<CalibratedOn>& seen, const Experiment& experiment) {
  return std::any_of(seen.begin(), seen.end(), [&](const CalibratedOn& on) {
    if (!on.source.empty()) return on.source == experiment.source;
    return on.experiment == experiment.name || on.specimen == experiment.specimen;
  });
}

PassiveMoments passive_named(const std::string& word) {
  return value_in(kPassiveNames, word, "switch of passive moments");
}

std::vector<const JointAxis*> joints_to(const Subject& subject, std::string segment) {
  std::vector<const JointAxis*> found;
  for (auto joint = subject.joints.rbegin(); joint != subject.joints.rend(); ++joint)
    if (joint->child == segment) {
      found.push_back(&*joint);
      segment = joint->parent;
    }
  return found;
}

bool has_passive(const JointAxis& joint) {
  return joint.stiffness > 0 || joint.flexing.moment > 0 || joint.extending.moment > 0;
}

Subject with_passive(Subject subject, PassiveMoments passive) {
  if (passive == PassiveMoments::kOn) return subject;
  for (JointAxis& joint : subject.joints) {
    joint.rest = joint.stiffness = joint.passive_spread = 0;
    joint.flexing = joint.extending = {};
  }
  return subject;
}

Subject parse_subject(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  SubjectDraft draft;
  // In this order each part refers to earlier ones only.
  read_header(top, draft);
  internal::read_segments(top, draft);
  internal::read_joints(top, draft);
  internal::read_dh_chains(top, draft);
  internal::read_passive(top, draft);
  internal::read_frames(top, draft);
  internal::read_surfaces(top, draft);
  internal::read_strands(top, draft);
  internal::read_muscles(top, draft);
  internal::read_digits(top, draft);
  internal::read_tip_maps(top, draft);
  top.done();
  // Checks of the whole.
  check_segments_move(top, draft.subject);
  return draft.subject;
}

Subject read_subject(const std::string& path) { return parse_subject(read_text_file(path), path); }

}  // namespace thenar
