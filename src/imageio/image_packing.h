#pragma once

/// Bounds on how many pixels of an image a byte of its file can stand for, of one bit each where
/// formats have that. What has no such bound still says something about a row or a block of pixels.
namespace ajar::packing {

inline constexpr double kUnpacked = 8.0;
inline constexpr double kRuns = 8.0 * 64.0;       ///< PackBits and the like
inline constexpr double kRowTable = 8192.0;       ///< 8 bytes for a row of at most 65536 pixels
inline constexpr double kDeflate = 8.0 * 1032.0;  ///< it makes at most so many bytes of one
inline constexpr double kLzw = 8.0 * 2560.0;      ///< 12-bit codes of a full table
/// Fixed odds of a block's modes take a bit and a half for 16 × 16 pixels (RFC 6386, section 11.2).
inline constexpr double kVp8 = 2048.0;
/// A colour alone takes no bits; but its own encoder makes at most 26 000 pixels of a byte.
inline constexpr double kVp8Lossless = 65536.0;
inline constexpr double kUnknown = 1 << 20;  ///< fax code spends a bit on a white row

}  // namespace ajar::packing
