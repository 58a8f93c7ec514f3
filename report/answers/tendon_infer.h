#pragma once

/// Text, fields and tables of the bands of an extensor net that measured forces require.
///
/// The evidence for a band is the increase of chi-square without it, in units of the errors of the
/// best net. Above 6 it exists, below -6 it does not, between it is undecided. With free slack
/// lengths, paths and the like it has a probability instead.

#include <string>
#include <vector>

#include "api/tendon_infer.h"
#include "report/fields.h"

namespace thenar {

/// Returns an inference as text: the fit of the best net to the forces, the verdict on every band,
/// the bands that cannot be distinguished, and the next measurements.
[[nodiscard]] std::string text_of(const InferNetResult& inference);
/// Returns an inference as fields; evidence, sd_of_log_EA, log_bayes_factor, chi2_without and
/// effective_parameters_with are null where they are infinite, EA where the data do not decide it.
[[nodiscard]] Fields fields_of(const InferNetResult& inference);
/// Returns a table with a row for each candidate band.
[[nodiscard]] Table table_of(const InferNetResult& inference);

/// Returns the errors of the best net, a sentence each.
[[nodiscard]] std::vector<std::string> fit_in_words(const InferNetResult& inference);
/// Returns the expected information of the proposed tests, in one sentence.
[[nodiscard]] std::string next_in_words(const InferNetResult& inference);
/// Returns a sentence for each group of bands of which the data require some, but do not determine
/// which.
[[nodiscard]] std::vector<std::string> groups_in_words(const InferredNet& inferred);

/// Returns the reason why there is no answer; empty if there is one.
[[nodiscard]] std::string refusal_of(const InferNetResult& inference);

// Free inference: slack lengths, paths and the like are free.

/// Returns the verdict in words: "yes", "no", or why it is undecided.
[[nodiscard]] std::string verdict_words(const BandBelief& band);
/// Returns the probability in words: "0.97", "0.43 +- 0.05", "1 (no set without it)".
[[nodiscard]] std::string probability_words(const BandBelief& band);
/// Returns the slack length in words [mm]: "17.67 +- 0.12", "held".
[[nodiscard]] std::string slack_words(const BandBelief& band);

/// Returns the number of fitted sets and the errors of the best set, a sentence each.
[[nodiscard]] std::vector<std::string> posterior_in_words(const FreeInference& free);
/// Returns the expected information of the proposed trials, in one sentence.
[[nodiscard]] std::string next_in_words(const FreeInference& free);

}  // namespace thenar
