#pragma once

/// Folders of the data that comes with thenar, the same for every question.

#include <string>
#include <vector>

namespace thenar {

/// Returns folders with robots/, objects/, worlds/, contacts/, subjects/.. in the order of search:
///   `given` (--data), the environment's THENAR_DATA, ./data, `near`, what was installed with the
///   program (../share/thenar beside it), the sources that it was built from.
/// Those that are not set are left out; those that are not there are not.
/// @param near  above the folder of a world, whose hands may stand beside it; "": nothing
[[nodiscard]] std::vector<std::string> data_folders(const std::string& given,
                                                    const std::string& near = "");

/// Returns the first of `places` that has `what`, with it: "data/robots/barrett.toml"; "" if none
/// has it.
[[nodiscard]] std::string find_in(const std::vector<std::string>& places, const std::string& what);

/// Returns the first data folder that has the folder `what`.
/// @throws InputError that names all places, if none has it.
[[nodiscard]] std::string data_with(const std::string& what, const std::string& given);

/// Names of the files of a folder like "robots" without ending, of all places, in alphabetic order.
[[nodiscard]] std::vector<std::string> names_in(const std::vector<std::string>& places,
                                                const std::string& folder,
                                                const std::string& ending = ".toml");

/// Returns a file, or by its name one that comes with thenar: "barrett_bobbin" of "worlds".
/// @param what  for messages: "world";  @param folder  "worlds";  @param ending  ".toml"
/// @throws InputError if there is neither, with the places looked in and the nearest name, or what
/// else has that name: "it is a hand: thenar pose barrett".
[[nodiscard]] std::string named_file(const std::string& what, const std::string& name,
                                     const std::string& folder, const std::string& ending,
                                     const std::vector<std::string>& places);

/// Returns "looked in a, b, c".
[[nodiscard]] std::string places_words(const std::vector<std::string>& places);

}  // namespace thenar
