#pragma once

/// Commands that accept a file of a kind, for messages about files of the wrong kind.

#include <string>

#include "base/error.h"

namespace thenar {

/// Returns the text of an error; of a WrongKindError with the commands that accept the file or the
/// name: "'P.nc' is a posterior, wanted a fit; commands that take it: thenar posterior summary ..".
[[nodiscard]] std::string text_with_commands(const Error& error);

}  // namespace thenar
