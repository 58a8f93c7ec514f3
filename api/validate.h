#pragma once

/// Validation of files: their kind, or what is wrong with them and where.

#include <optional>
#include <string>
#include <vector>

#include "api/experiment_check.h"
#include "api/named/things.h"

namespace thenar {

/// Options of a validation: files or names, and the data that they are checked against.
struct ValidateRequest {
  std::vector<std::string> things;  // files, or names of bundled items; empty: no file is read
  std::string subject;    // name or file that experiments are checked against; empty: none
  std::string materials;  // file over the built-in table that names of materials are checked
                          // against; empty: that table
  std::string data;       // folder with subjects/ ..; empty: the usual ones
};

/// Result of the validation of one thing: it is read, subjects are built digit by digit, bodies as
/// solids, and fits are set up from their own inputs.
struct FileVerdict {
  std::string path;                   // path of the file, or the requested name if there is none
  std::optional<Thing> thing;         // absent: see `error`
  std::string error;                  // error message; empty: none
  SubjectMatch check;                 // check of an experiment, where a subject was given
  std::vector<std::string> warnings;  // doubts about the content

  [[nodiscard]] bool valid() const { return error.empty() && check.misfits.empty(); }
};

struct Validation {
  ValidateRequest request;         // request that was answered
  std::vector<FileVerdict> files;  // verdicts in the order of the request
  std::string subject;             // path of the subject for experiments; empty: none

  [[nodiscard]] bool valid() const;
};

/// Reads and builds each thing; an error in one does not affect the others.
/// @throws InputError or DataError if the subject cannot be read, or there is no experiment to
/// check against it.
[[nodiscard]] Validation validate(const ValidateRequest& request);

}  // namespace thenar
