#include "api/named/data_folders.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/shipped_data.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/outside_path.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

// Folders of the data, and the kind of their files
constexpr std::pair<const char*, const char*> kKnownFolders[] = {
    {"subjects", "subject"},
    {"robots", "hand"},
    {"worlds", "world"},
    {"scenes", "scene"},
    {"pads", "pad"},
    {"presses", "file of measured presses"},
    {"objects", "object"},
    {"experiments", "experiment"},
    {"contacts", "file of contacts"}};

/// Returns the kind of the file of a name in another folder; absent: there is none.
std::optional<std::string> kind_elsewhere(const std::string& name, const std::string& folder,
                                          const std::vector<std::string>& places) {
  for (const auto& [known, kind] : kKnownFolders) {
    if (known == folder) continue;
    // Look for the name in every folder and with every ending that thenar reads.
    for (const char* ending : {".toml", ".json", ".jsonl"})
      if (!find_in(places, (fs::path(known) / (name + ending)).string()).empty()) return kind;
  }
  return {};
}

}  // namespace

std::vector<std::string> data_folders(const std::string& given, const std::string& near) {
  std::error_code none;
  require_field("data", given.empty() || fs::is_directory(given, none), "there is no folder {}",
                given);
  // Order of precedence: the folder given, the environment, ./data, the folder of the file, data
  // that came with thenar.
  const char* named = std::getenv("THENAR_DATA");
  std::vector<std::string> places;
  std::vector<std::string> all{given, named == nullptr ? "" : named, "data", near};
  append_all(all, shipped_data());
  // Keep the first mention of each folder alone.
  append_new(places, all);
  erase_where(places, [](const std::string& place) { return place.empty(); });
  return places;
}

std::string find_in(const std::vector<std::string>& places, const std::string& what) {
  // Names do not lead out of the folders.
  if (outside_fault(what, OutsideUse::kInside)) return "";
  std::error_code none;
  for (const std::string& place : places)
    if (fs::exists(fs::path(place) / what, none)) return (fs::path(place) / what).string();
  return "";
}

std::string data_with(const std::string& what, const std::string& given) {
  const std::vector<std::string> places = data_folders(given);
  std::error_code none;
  for (const std::string& place : places)
    if (fs::is_directory(fs::path(place) / what, none)) return place;
  throw InputError(fmt::format("there is no folder with {}/: {}; THENAR_DATA may name one", what,
                               places_words(places)),
                   "data");
}

std::vector<std::string> names_in(const std::vector<std::string>& places, const std::string& folder,
                                  const std::string& ending) {
  std::vector<std::string> names;
  for (const std::string& place : places) {
    const fs::path here = fs::path(place) / folder;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(here, none))
      if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
  }
  // The same name in several folders is one entry: the first folder wins when it is opened.
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string named_file(const std::string& what, const std::string& name, const std::string& folder,
                       const std::string& ending, const std::vector<std::string>& places) {
  // A path that exists beats a name of the data.
  if (is_file(name)) return name;
  if (name.find('/') == std::string::npos) {
    std::string found = find_in(places, (fs::path(folder) / (name + ending)).string());
    if (!found.empty()) return found;
  }
  // Otherwise explain: a name of another kind, a misspelt one, or an unknown one.
  if (const auto kind = kind_elsewhere(name, folder, places))
    throw WrongKindError(
        fmt::format("there is no {} '{}'; it is a{} {}", what, name,
                    kind->front() == 'o' || kind->front() == 'e' ? "n" : "", *kind),
        *kind, name);
  const std::vector<std::string> known = names_in(places, folder, ending);
  const std::string meant = did_you_mean(name, known);
  std::error_code none;
  if (fs::exists(name, none))  // a folder, a pipe or a device
    throw InputError(fmt::format("there is no {} '{}'{} is neither a file nor one of {}/; {}", what,
                                 name, meant.empty() ? ": it" : meant + " It", folder,
                                 places_words(places)));
  throw InputError(fmt::format(
      "there is no {} '{}'{} is no such file, and no such name in {}/ of {}", what, name,
      meant.empty() ? ": there" : meant + " There", folder, fmt::join(places, ", ")));
}

std::string places_words(const std::vector<std::string>& places) {
  return fmt::format("looked in {}", fmt::join(places, ", "));
}

}  // namespace thenar
