#pragma once

/// Hands and digits: poses, moment arms, fingertip forces and what limits them.
/// Example: examples/01_pose.cpp .. 04_feasible_force.cpp, 11_own_finger.cpp.

#include "api/feasible_force.h"
#include "api/moment_arms.h"
#include "api/named/data_folders.h"
#include "api/named/digit_result.h"
#include "api/named/digits.h"
#include "api/named/files.h"
#include "api/named/posture.h"
#include "api/pose.h"
#include "api/robot_pose.h"
#include "api/tip_force.h"
