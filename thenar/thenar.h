#pragma once

/// All public headers of thenar at once. A program that asks one kind of question compiles sooner
/// with the header of that kind:
///
///     #include <thenar/hands.h>
///
/// These headers, and those that they include, are installed; all others are private.

#include "api/import.h"
#include "thenar/deprecated.h"
#include "thenar/fits.h"
#include "thenar/grasps.h"
#include "thenar/hands.h"
#include "thenar/pads.h"
#include "thenar/scenes.h"
#include "thenar/tendons.h"
