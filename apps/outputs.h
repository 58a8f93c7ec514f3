#pragma once

/// Output options: one set of flags for every command, and one way to deliver a result.
///
///   --json, --csv      print JSON or a table instead of text
///   -o FILE            write a file; its ending says what: .html a page, .csv a table, .json, or a
///                      kind of the command's own (.h5, .nc, .toml ..); may be given several times
///   --report FILE      the same as -o with a page (.html)

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "apps/terminal.h"
#include "base/provenance.h"
#include "base/run_record.h"
#include "questions/make_question.h"
#include "report/answers/answer_files.h"

namespace thenar {

/// Requested formats and files of a result.
struct Outputs {
  bool json = false, csv = false;  // format printed instead of text
  std::vector<std::string> files;  // files of -o and --report

  /// Returns the files with one of these endings (".h5"), in the order in which they were given.
  [[nodiscard]] std::vector<std::string> with_ending(const std::vector<std::string>& endings) const;
  /// Returns the only file with the ending; "" if there is none. @throws InputError if there are
  /// several.
  [[nodiscard]] std::string only_file(const std::string& ending) const;
  [[nodiscard]] bool page() const { return !with_ending({".html"}).empty(); }
};

/// Kinds of output that a command has besides text.
struct OutputKinds {
  bool json = true, csv = false, page = false;
  std::vector<std::string> own = {};  // endings of its own files: ".h5"
};

/// Arguments of a command: its request and its outputs.
template <typename Request>
struct Arguments {
  Request request = {};
  Outputs outputs = {};
};

/// Adds the flags of these kinds, old spellings (--out, --output) included. Files with other
/// endings, and files that cannot be written, throw before any work.
void add_output_options(CLI::App& command, Outputs& outputs, const OutputKinds& kinds);

/// Records the run of this process for all outputs. Call it once, when the program starts.
void begin_run(int argc, char** argv);
/// Returns the record of this run for files.
[[nodiscard]] const RunRecord& this_run();
/// Adds the question to the record of the run. @param request  request in SI
void set_request(const std::string& question, const OrderedJson& request);

/// Prints all of the text to standard output.
void print_answer(const std::string& text);
/// Prints a line "wrote FILE" for each file, unless JSON or CSV is printed.
void print_written(const Outputs& outputs);
/// Writes a page, with the record of this run in its provenance.
/// @param files  input files of the result
/// @throws InputError as write_report()
void write_page(Json page, const std::string& path, const FileDigests& files = {});
/// Writes a JSON file, with the record of this run beside its provenance.
/// @param files  input files of the result
/// @throws InputError if the file cannot be written.
void write_json_file(OrderedJson json, const std::string& path, const FileDigests& files = {});
/// Writes a table as CSV. @throws InputError if the file cannot be written.
void write_csv_file(const Table& table, const std::string& path);

/// Prints an answer, its warnings first, and writes it to the requested files.
/// @throws InputError after an answer that must not be used, Stopped after a stopped one
void deliver(const Outputs& outputs, const Answer& answer);

/// Delivers a result, from which report/answers and report/pages make the answer.
template <typename Result>
void deliver(const Outputs& outputs, const Result& result) {
  const std::shared_ptr<const Result> kept(std::shared_ptr<const Result>(), &result);
  Answer answer = answer_of(kept, {});
  answer.refusal.clear();  // the command says why
  deliver(outputs, answer);
}

}  // namespace thenar
