#include "data/io/subject.h"

#include "data/io/subject_parts.h"

namespace thenar {
namespace {

using internal::SubjectDraft;

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
}

/// Every segment but the base hangs on a joint.
void check_segments_move(const TomlTable& top, const Subject& subject) {
  for (const Segment& segment : subject.segments) {
    bool moved = segment.name == subject.base;
    for (const JointAxis& joint : subject.joints) moved = moved || joint.child == segment.name;
    if (!moved)
      top.fail(fmt::format("segment '{}' is not the base and no joint moves it", segment.name));
  }
}

}  // namespace

Subject parse_subject(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  SubjectDraft draft;
  read_header(top, draft);
  internal::read_segments(top, draft);
  internal::read_joints(top, draft);
  internal::read_dh_chains(top, draft);
  internal::read_frames(top, draft);
  internal::read_surfaces(top, draft);
  internal::read_strands(top, draft);
  internal::read_muscles(top, draft);
  internal::read_digits(top, draft);
  internal::read_tip_maps(top, draft);
  top.done();
  check_segments_move(top, draft.subject);
  return draft.subject;
}

Subject read_subject(const std::string& path) { return parse_subject(read_text_file(path), path); }

}  // namespace thenar
