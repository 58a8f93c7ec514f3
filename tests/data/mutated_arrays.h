#pragma once

/// Files of results in which one array after the other is another one than was written.

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "data/io/inference_file.h"
#include "data/io/result_layout.h"

namespace thenar {

/// A change of the values and the shape of an array; false: this array has nothing to change.
struct ArrayMutation {
  const char* name;
  std::function<bool(std::vector<double>& values, std::vector<std::size_t>& shape)> change;
};

inline std::size_t product_of(const std::vector<std::size_t>& shape) {
  std::size_t size = 1;
  for (const std::size_t length : shape) size *= length;
  return size;
}

/// Row-major values of the array with its dimensions in reverse.
inline std::vector<double> reversed_values(const std::vector<double>& values,
                                           const std::vector<std::size_t>& shape) {
  std::vector<double> turned(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::size_t rest = i, at = 0, stride = values.size();
    std::vector<std::size_t> index(shape.size());
    for (std::size_t k = shape.size(); k-- > 0; rest /= shape[k]) index[k] = rest % shape[k];
    stride = 1;
    for (std::size_t k = 0; k < shape.size(); ++k) {
      at += index[k] * stride;
      stride *= shape[k];
    }
    turned[at] = values[i];
  }
  return turned;
}

/// Transposed (a list: one row), shorter, longer, empty, of another rank, with NaN in it.
inline const std::vector<ArrayMutation>& array_mutations() {
  using Values = std::vector<double>;
  using Lengths = std::vector<std::size_t>;
  static const std::vector<ArrayMutation> all{
      {"transposed",
       [](Values& values, Lengths& shape) {
         const Lengths before = shape;
         values = reversed_values(values, shape);
         if (shape.size() == 1)
           shape.insert(shape.begin(), 1);
         else
           std::reverse(shape.begin(), shape.end());
         return shape != before;
       }},
      {"shorter",
       [](Values& values, Lengths& shape) {
         if (shape.empty() || shape[0] == 0) return false;
         --shape[0];
         values.resize(product_of(shape));
         return true;
       }},
      {"longer",
       [](Values& values, Lengths& shape) {
         if (shape.empty()) return false;
         ++shape[0];
         values.resize(product_of(shape), 0.5);
         return true;
       }},
      {"empty",
       [](Values& values, Lengths& shape) {
         if (values.empty()) return false;
         shape.assign(std::max<std::size_t>(shape.size(), 1), 0);
         values.clear();
         return true;
       }},
      {"of another rank",
       [](Values& /*values*/, Lengths& shape) {
         if (shape.size() < 3)
           shape.push_back(1);
         else
           shape = {product_of(shape)};
         return true;
       }},
      {"not a number",
       [](Values& values, Lengths& /*shape*/) {
         if (values.empty()) return false;
         values[values.size() / 2] = std::numeric_limits<double>::quiet_NaN();
         return true;
       }},
  };
  return all;
}

/// What became of one changed file: "fit/z transposed: PATH:1: .."; where it was read: "..: read".
using MutationVerdicts = std::vector<std::string>;
/// Number of changed files that each result has at least: with fewer, arrays were left out.
inline constexpr std::size_t kMinMutations = 101;

/// Changes every array of a result in every way, and reads each file.
/// @param path  where changed files are written
template <typename Read>
MutationVerdicts verdicts_on_mutations(const ResultFile& good, const std::string& path,
                                       const Read& read) {
  MutationVerdicts verdicts;
  const auto attempt = [&](const ResultFile& file, const std::string& key, const char* what) {
    write_result(file, path);
    std::string said = "read";
    try {
      read(path);
    } catch (const Error& error) {
      said = error.what();
    }
    verdicts.push_back(key + " " + what + ": " + said);
  };
  for (const auto& [key, array] : good.arrays) {
    for (const ArrayMutation& mutation : array_mutations()) {
      ResultFile file = good;
      ResultArray& changed = file.arrays.at(key);
      changed.labels.clear();
      if (mutation.change(changed.values, changed.shape)) attempt(file, key, mutation.name);
    }
    ResultFile without = good;
    without.arrays.erase(key);
    attempt(without, key, "missing");
    without.texts[key] = {"a text"};
    attempt(without, key, "a text");
  }
  return verdicts;
}

/// Those of changed files that were read.
inline MutationVerdicts read_all_the_same(const MutationVerdicts& verdicts) {
  MutationVerdicts read;
  for (const std::string& verdict : verdicts)
    if (verdict.size() > 6 && verdict.compare(verdict.size() - 6, 6, ": read") == 0)
      read.push_back(verdict.substr(0, verdict.size() - 6));
  return read;
}

/// The same of a posterior: each array gets dimensions of its own of the wanted lengths. Those that
/// only people read are transposed or missing, which is enough and soon done.
/// @param computed_with  groups that the program goes on with
template <typename Read>
MutationVerdicts verdicts_on_mutations(const InferenceFile& good, const std::string& path,
                                       const std::set<std::string>& computed_with,
                                       const Read& read) {
  MutationVerdicts verdicts;
  const auto attempt = [&](const InferenceFile& file, const std::string& key, const char* what) {
    write_inference(file, path);
    std::string said = "read";
    try {
      read(path);
    } catch (const Error& error) {
      said = error.what();
    }
    verdicts.push_back(key + " " + what + ": " + said);
  };
  for (const auto& [group_name, group] : good.groups)
    for (const auto& [name, array] : group.arrays) {
      const std::string key = group_name + "/" + name;
      for (const ArrayMutation& mutation : array_mutations()) {
        if (computed_with.count(group_name) == 0 && &mutation != &array_mutations().front()) break;
        InferenceFile file = good;
        InferenceGroup& to = file.groups.at(group_name);
        InferenceArray& changed = to.arrays.at(name);
        std::vector<std::size_t> shape = shape_in(group, array);
        if (!mutation.change(changed.values, shape)) continue;
        changed.dimensions.clear();
        changed.integer = changed.boolean = false;
        for (std::size_t k = 0; k < shape.size(); ++k) {
          changed.dimensions.push_back("own_" + std::to_string(k));
          to.lengths[changed.dimensions.back()] = shape[k];
        }
        attempt(file, key, mutation.name);
      }
      InferenceFile without = good;
      without.groups.at(group_name).arrays.erase(name);
      attempt(without, key, "missing");
    }
  return verdicts;
}

}  // namespace thenar
