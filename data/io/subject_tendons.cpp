#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

PointFrame read_frame(TomlTable& table, const SubjectDraft& draft) {
  PointFrame frame;
  frame.segment = segment_reference(table, "segment", draft);
  frame.origin = table.vector(Dimension::kLength, "origin");
  frame.unit =
      table.number_or(Dimension::kLength, "unit", draft.subject.reference_length, Range::kPositive);
  if (table.has("axes")) frame.axes = table.rows3("axes");
  const Eigen::Matrix3d gram = frame.axes * frame.axes.transpose();
  if ((gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > 1e-6)
    table.fail("wanted 'axes' as three perpendicular unit vectors", "axes");
  table.done();
  return frame;
}

Strand read_strand(TomlTable& table, const SubjectDraft& draft) {
  Strand strand;
  strand.name = new_name(table, names_of(draft.subject.strands));
  for (TomlTable& point : table.tables("path"))
    strand.path.push_back(read_path_element(point, draft));
  check_path(table, strand, draft);
  strand.arms = table.named(Dimension::kLength, "arms");
  for (const auto& [joint, arm] : strand.arms)
    check_reference(table, "arms", "joint", joint, names_of(draft.subject.joints));
  if (strand.path.empty() && strand.arms.empty())
    table.fail(fmt::format("strand '{}' needs a 'path' or 'arms_mm'", strand.name));
  table.done();
  return strand;
}

/// The strand a muscle pulls: the one it names, or the one of its own name.
std::string read_pulled(TomlTable& table, const std::string& muscle, const Subject& subject) {
  const std::vector<std::string> strands = names_of(subject.strands);
  if (table.has("strand")) return reference(table, "strand", "strand", strands);
  if (strands.empty()) return "";
  check_reference(table, "name", "strand", muscle, strands);
  return muscle;
}

/// F0 as stated, or as PCSA times specific tension; absent if neither is known.
std::optional<double> read_max_force(TomlTable& table, double pcsa, double specific_tension) {
  const double tension =
      table.number_or(Dimension::kStress, "specific_tension", specific_tension, Range::kPositive);
  if (table.has(Dimension::kForce, "max_force"))
    return table.number(Dimension::kForce, "max_force", Range::kNotNegative);
  return pcsa * tension > 0 ? std::optional<double>(pcsa * tension) : std::nullopt;
}

MuscleUnit read_muscle(TomlTable& table, const SubjectDraft& draft) {
  MuscleUnit muscle;
  muscle.name = new_name(table, names_of(draft.subject.muscles));
  muscle.strand = read_pulled(table, muscle.name, draft.subject);
  muscle.pcsa = table.number_or(Dimension::kArea, "pcsa", 0, Range::kNotNegative);
  muscle.max_force = read_max_force(table, muscle.pcsa, draft.specific_tension);
  muscle.fibre_length = table.number_or(Dimension::kLength, "fibre_length", 0, Range::kNotNegative);
  muscle.tendon_slack = table.number_or(Dimension::kLength, "tendon_slack", 0, Range::kNotNegative);
  muscle.pennation = table.number_or(Dimension::kAngle, "pennation", 0, Range::kNotNegative);
  table.done();
  return muscle;
}

}  // namespace

void read_frames(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("frame")) {
    const std::string name = table.text("name");
    if (!draft.frames.emplace(name, read_frame(table, draft)).second)
      table.fail(fmt::format("[[frame]] '{}' is given twice", name), "name");
  }
}

void read_strands(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("strand"))
    draft.subject.strands.push_back(read_strand(table, draft));
}

void read_muscles(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("muscle"))
    draft.subject.muscles.push_back(read_muscle(table, draft));
}

}  // namespace thenar::internal
