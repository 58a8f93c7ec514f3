#pragma once

/// Words, JSON and tables of which bands an extensor net has where slack lengths, paths and the
/// like are free: parts of text_of(), json_of() and table_of() of a NetInference with `free`.

#include <string>
#include <vector>

#include "api/tendon_infer.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {

/// "yes", "no", or why it cannot be told.
[[nodiscard]] std::string verdict_words(const BandBelief& band);
/// "0.97", "0.43 +- 0.05", "1 (no set without it)".
[[nodiscard]] std::string probability_words(const BandBelief& band);
/// "17.67 +- 0.12", "held" [mm].
[[nodiscard]] std::string slack_words(const BandBelief& band);

/// How many sets were fitted, and how well the best explains the forces, a sentence each.
[[nodiscard]] std::vector<std::string> posterior_in_words(const FreeInference& free);
/// What the trials that are proposed would tell, in one sentence.
[[nodiscard]] std::string next_in_words(const FreeInference& free);

[[nodiscard]] std::string text_of_free(const NetInference& inference);
[[nodiscard]] OrderedJson json_of_free(const NetInference& inference);
/// A row for each band in question.
[[nodiscard]] Table table_of_free(const NetInference& inference);

}  // namespace thenar
