// Which program an INI is for.
#pragma once
#include <filesystem>
#include <string>

namespace ariadne::app {

/// Throws core::UsageError naming the right program when the text of `file` is clearly an INI of
/// another than `program` ("ariadne-slam"), by its sections. What is none of ours passes.
void expectIniOf(const std::string& program, const std::filesystem::path& file,
                 const std::string& text);

}  // namespace ariadne::app
