#pragma once

/// All public headers of thenar at once. A program that asks one kind of question compiles sooner
/// with the header of that kind:
///
///     #include <thenar/hands.h>
///
/// Public is what the headers of api/ declare that these include, and the structs that their requests
/// and results name. Other headers are installed because these include them; all else in them is
/// private and may change at any time (VERSIONING.md).

#include "api/import.h"
#include "thenar/deprecated.h"
#include "thenar/fits.h"
#include "thenar/grasps.h"
#include "thenar/hands.h"
#include "thenar/pads.h"
#include "thenar/scenes.h"
#include "thenar/tendons.h"
