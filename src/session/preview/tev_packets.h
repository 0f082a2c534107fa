#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/vector.h"
#include "session/output/output.h"

namespace ajar {

/// Names of the channels of a picture's layers, in their order: R, G, B, direct.R, …
std::vector<std::string> channel_names(const Picture& picture);

/// Packets of the protocol by which programs show pictures in the viewer tev, over TCP (usually
/// port 14158). A packet is its length in bytes (uint32, itself counted), a type (1 byte) and
/// fields; numbers are little-endian, texts end with a zero byte. Viewers answer nothing.
/// Source: tev's own client, src/python/ipc.py.

/// A new picture of that name and size, black, in the place of any other of the name.
std::string create_image_packet(const std::string& name, Vec2i size,
                                const std::vector<std::string>& channels);

/// The pixels of `region` (full-image coordinates, max inclusive, inside the picture's crop), all
/// layers.
std::string update_image_packet(const std::string& name, const Picture& picture,
                                const Box2i& region);

}  // namespace ajar
