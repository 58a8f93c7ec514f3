#pragma once

/// Measured presses of a finger pad, to which its constants are fitted.

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace thenar {

/// A constant that a fit moves, as a file names it.
struct PadDataConstant {
  int layer = 0;         // skin layer from the outside in, from 1; 0: the pulp, or the pad's shape
  std::string constant;  // "shear_modulus", "exponent", "poisson_ratio", "share", "thickness",
                         // "bone_height"
  int term = 1;          // term of the relaxation, from 1; for "share"
  std::optional<double> start;  // start of the search and median of the prior [Pa], [m] or
                                // [1]; empty: the pad's own
  double lower_factor = 0.01, upper_factor = 100;  // bounds over the start [1]
  std::optional<double> prior_factor;              // one sd of the prior as a factor, > 1 [1]
  int line = 0;
};

/// Numbers measured under loads of a press.
struct PadDataRows {
  std::vector<double> loads;      // imposed loads [N] or [m]
  std::string quantity;           // measured: "indentation", "force" or "area"
  std::optional<double> part_at;  // numbers are parts of the quantity at this load [N] or [m]
  std::vector<double> values;     // [m], [N], [m^2]; parts [1]
  std::vector<double> sds;        // standard deviation of each value, same unit
  std::string source;             // citation keys
  int line = 0;
};

/// One press.
struct PadDataPress {
  std::string name;
  std::string object = "plane";  // "plane", "sphere" or "cylinder", which lies across the finger
  double radius = 0;             // radius of a sphere or cylinder [m]
  double angle = 0;      // angle between pad and object, as in touch_pad(): above 0 towards the
                         // tip [rad]
  double friction = 0;   // Coulomb [1]
  bool by_force = true;  // true: forces are imposed; false: indentations
  double ramp = 0;       // time from touch to the largest load, at a constant rate of the imposed
                         // quantity; 0: at once, infinity: relaxed [s]
  std::vector<PadDataRows> rows;
  int line = 0;
};

/// Cells of the mesh that a fit uses.
struct PadDataCells {
  int across = 4, around = 2, through = 3;
};

/// A data file.
struct PadData {
  std::string path, title;
  std::string pad;  // a file beside this one, or a name
  PadDataCells cells;
  std::vector<PadDataConstant> constants;
  std::vector<PadDataPress> presses;
  std::map<std::string, std::string> own_sources;  // citation keys that the file defines
};

/// Reads a data file; docs/data_format.md has its keys.
/// @throws DataError `path:line: ...`: what was wanted, and what came.
[[nodiscard]] PadData read_pad_data(const std::string& path);

/// Parses pad data from a text. @param path  names it in messages
[[nodiscard]] PadData parse_pad_data(const std::string& text, const std::string& path);

}  // namespace thenar
