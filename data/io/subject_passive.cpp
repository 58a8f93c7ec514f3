
#include "base/lists.h"
#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

/// Reads `flexing = {moment_Nmm = 60, width_deg = 20}`; none if it is absent.
PassiveEnd read_passive_end(TomlTable& table, const std::string& key) {
  PassiveEnd end;
  std::optional<TomlTable> inner = table.table(key);
  if (!inner) return end;
  end.moment = inner->number(Dimension::kMoment, "moment", Range::kNotNegative);
  end.width = inner->number(Dimension::kAngle, "width", Range::kPositive);
  inner->done();
  return end;
}

/// The joint of that name, which no earlier table may have given passive moments.
JointAxis& passive_joint(TomlTable& table, const std::string& name, SubjectDraft& draft) {
  check_reference(table, "joints", "joint", name, names_of(draft.subject.joints));
  JointAxis& joint = *find_named(draft.subject.joints, name);
  if (has_passive(joint))
    table.fail(fmt::format("joint '{}' has a passive moment already", name), "joints");
  return joint;
}

}  // namespace

void read_passive(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("passive")) {
    // The law, the same for all joints of the table.
    JointAxis law;
    law.stiffness =
        table.number_or(Dimension::kAngularStiffness, "stiffness", 0, Range::kNotNegative);
    law.flexing = read_passive_end(table, "flexing");
    law.extending = read_passive_end(table, "extending");
    law.passive_spread = table.number_or(Dimension::kNumber, "spread", 0, Range::kNotNegative);
    if (!has_passive(law)) table.fail("wanted 'stiffness', 'flexing' or 'extending' above 0");
    // Each joint rests at its own angle.
    const std::vector<std::string> joints = table.texts("joints");
    const std::vector<double> rest =
        table.numbers(Dimension::kAngle, "rest", static_cast<int>(joints.size()));
    for (std::size_t i = 0; i < joints.size(); ++i) {
      JointAxis& joint = passive_joint(table, joints[i], draft);
      joint.rest = rest[i];
      joint.stiffness = law.stiffness;
      joint.flexing = law.flexing;
      joint.extending = law.extending;
      joint.passive_spread = law.passive_spread;
    }
    table.done();
  }
}

}  // namespace thenar::internal
