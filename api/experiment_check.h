#pragma once

/// Check that an experiment suits a subject, before anything is fitted.

#include <string>
#include <vector>

#include "base/provenance.h"
#include "data/io/experiment.h"
#include "data/io/subject.h"

namespace thenar {

/// Sentences, each with its line in the experiment's file: "H01.toml:31: posture 'Hook' ..".
struct SubjectMatch {
  std::vector<std::string> misfits;  // errors that make a fit impossible
  std::vector<std::string> doubts;   // sentences about what is unusual but possible
};

/// Compares names of digit, joints, muscles and segment. Then checks whether the subject was
/// calibrated on the specimen; in every posture, joint limits and how straight the finger is; and
/// in every trial, whether tensions and forces are plausible:
///   |force| <= sum of tensions + 2 sds  levers of a finger are shorter for tendons than for forces
///   median angle to the subject's own prediction < 90 deg
/// @param source  text and path of the experiment
/// @throws DataError if the experiment cannot be read.
[[nodiscard]] SubjectMatch check_experiment(const SourceText& source, const Subject& subject);

}  // namespace thenar
