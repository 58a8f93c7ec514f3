#pragma once

/// Grasps of human and robot hands: quality of contacts, closing on objects, comparison.
/// Example: examples/08_contact_quality.cpp, 09_grasp.cpp, 13_own_object.cpp.

#include "api/close.h"
#include "api/compare.h"
#include "api/grasp.h"
#include "api/grasp_measures.h"
#include "api/named/hands.h"
#include "api/named/worlds.h"
#include "api/quality.h"
#include "data/io/world/make_body.h"
