#pragma once

/// Folders of the data that comes with thenar, the same for every question.

#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace thenar {

/// Error about a file, or a name of the data, of another kind than wanted.
struct WrongKindError : InputError {
  /// @param advice  end of the message: "; a world puts .."
  WrongKindError(const std::string& what, std::string its_kind, std::string its_name,
                 std::string its_advice = "")
      : InputError(what + its_advice),
        kind(std::move(its_kind)),
        name(std::move(its_name)),
        advice(std::move(its_advice)) {}

  std::string kind;    // FileContents::kind of the file, or what the name stands for: "hand"
  std::string name;    // path or name
  std::string advice;  // see the constructor
};

/// Returns folders with robots/, objects/, worlds/, contacts/, subjects/.. in the order of search:
///   `given` (--data), the environment's THENAR_DATA, ./data, `near`, what was installed with the
///   program (../share/thenar beside it), the sources that it was built from.
/// Folders that are not set are left out; set folders that do not exist are kept.
/// @param near parent of the folder of a world, whose hands may be beside it; "": none
[[nodiscard]] std::vector<std::string> data_folders(const std::string& given,
                                                    const std::string& near = "");

/// Returns the path of `what` in the first of `places` that contains it:
/// "data/robots/barrett.toml"; "" if none does.
[[nodiscard]] std::string find_in(const std::vector<std::string>& places, const std::string& what);

/// Returns the first data folder that has the folder `what`.
/// @throws InputError listing all folders, if none has it.
[[nodiscard]] std::string data_with(const std::string& what, const std::string& given);

/// Returns the names, without ending, of the files in a folder like "robots" of all places, in
/// alphabetic order.
[[nodiscard]] std::vector<std::string> names_in(const std::vector<std::string>& places,
                                                const std::string& folder,
                                                const std::string& ending = ".toml");

/// Returns the path of a file given by its path, or by the name of a file that comes with thenar:
/// "barrett_bobbin" of "worlds".
/// @param what  for messages: "world";  @param folder  "worlds";  @param ending  ".toml"
/// @throws InputError if there is neither, listing the searched folders and the nearest name;
/// WrongKindError if another kind has this name: "it is a hand".
[[nodiscard]] std::string named_file(const std::string& what, const std::string& name,
                                     const std::string& folder, const std::string& ending,
                                     const std::vector<std::string>& places);

/// Returns "looked in a, b, c".
[[nodiscard]] std::string places_words(const std::vector<std::string>& places);

}  // namespace thenar
