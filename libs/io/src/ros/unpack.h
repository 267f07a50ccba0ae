// The compressions of ROS recordings: bz2, lz4 (frames) and zstd.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace ariadne::io::ros {

enum class Codec { none, bz2, lz4, zstd };

/// "", "none", "bz2", "lz4", "zstd" as the formats write them; nullopt for another.
std::optional<Codec> codecOf(std::string_view name);

/// Whether these bytes begin a frame of zstd.
bool looksLikeZstd(std::string_view bytes);

/// Unpacks a chunk that must give `size` bytes, 1 GiB at most. Memory grows with what truly comes
/// out. Throws BagDamage when the data are damaged or give more or less.
std::vector<char> unpack(Codec codec, std::string_view packed, std::uint64_t size);

/// Unpacks a frame of zstd whose size nobody states, `most` bytes at most.
std::vector<char> unpackZstd(std::string_view packed, std::size_t most);

}  // namespace ariadne::io::ros
