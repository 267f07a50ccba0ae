// A file appears whole or not at all: written beside its place, checked, then renamed into it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace ariadne::io {

/// Writes `content` to `path`, replacing what is there only once all of it is on the disk.
/// Throws core::Error naming the path and the system's reason; then `path` is as it was.
void writeWhole(const std::filesystem::path& path, std::string_view content);

/// The same for a writer that needs a file name of its own (MRPT's, Cairo's). `write` must throw
/// when it fails; the temporary name keeps the extension of `path`.
void writeWhole(const std::filesystem::path& path,
                const std::function<void(const std::filesystem::path& temporary)>& write);

/// When a process of this machine was started, in ticks since boot (proc(5), field 22); empty when
/// there is none. Tells it from a later one with the same number.
std::string startOf(const std::string& pid);

/// "1234-567", this process and its start, of which the names of its half-written files are made:
/// on a shared folder processes of two machines or containers may well have the same number.
std::string writerMark();

/// All of a file. Throws core::Error naming the path when it cannot be read, or is a folder, or
/// holds more than `most_bytes`.
std::string readWhole(const std::filesystem::path& path, std::size_t most_bytes = SIZE_MAX);
/// The same of a text in any encoding that core::plainText knows.
std::string readText(const std::filesystem::path& path, std::size_t most_bytes = SIZE_MAX);

}  // namespace ariadne::io
