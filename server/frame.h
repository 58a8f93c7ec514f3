#pragma once

/// Binary encoding of an instant of a live model, for pages.
///
/// Format, little-endian, version 1:
///      0  char[4] "THF1"    4 u32 revision of the scene    8 u32 sequence    12 u32 0
///     16  f64 time [s]
///     24  u16 bodies, joints, lines, contacts, arrows, line points of all lines
///     36  u16 step of line points in units of 1e-6 m; 0 stands for 10
///     38  u16 0
///     40  f32 origin of line points x, y, z [m]
///     52  bodies x 7 f32: position [m], quaternion w, x, y, z
///         joints x f32 [rad] or [m]
///         lines x f32 tension [N]; NaN unknown, 0 slack
///         contacts x (u16 a, u16 b (0xffff: none), f32 point [m] (3), normal (3), force [N] (3),
///                     friction)
///         arrows x 6 f32: from [m] (3), vector (3)
///         line points x 3 i16, in steps from the origin

#include <cstdint>
#include <string>

#include "live/live_picture.h"
#include "report/json.h"

namespace thenar {

/// Returns the quaternion w, x, y, z of a rotation, with w >= 0.
[[nodiscard]] Eigen::Vector4d quaternion_of(const Eigen::Matrix3d& R);

/// Encodes an instant that has passed check_instant().
/// @param revision  revision of the scene;  @param sequence  number of the frame
/// @throws InputError if it has more than 65535 entries of a kind, or lines that are too long
[[nodiscard]] std::string encode_frame(const LiveInstant& instant, std::uint32_t revision,
                                       std::uint32_t sequence);

/// Encodes an instant as JSON, with full precision.
[[nodiscard]] OrderedJson frame_json(const LiveShape& shape, const LiveInstant& instant,
                                     unsigned long revision);

}  // namespace thenar
