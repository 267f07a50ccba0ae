// What an arm's program makes of its INI and the settings.
#pragma once
#include <string>

#include "ariadne/batch/content_hash.h"
#include "ariadne/batch/program.h"

namespace ariadne::batch {

/// Asks the program with --print-config (a program that cannot: the INI as it is).
/// Throws core::UsageError at `where` with what the program said.
std::string resolvedConfig(const Program& program, const ArmCall& call, const std::string& where);

/// The same for the same result: files by what they hold, without comments and [run].
/// @param files takes the data files that the configuration names
/// Throws core::UsageError at `where` when one of them does not exist.
std::string meaningOf(const std::string& config, const std::string& where, FileHashes& hashes,
                      std::map<std::string, std::string>& files);

/// The hash for a word that is the path of a file or of a recording in a folder; it is added to `files`. Else the word.
std::string meaningOfWord(const std::string& word, FileHashes& hashes,
                          std::map<std::string, std::string>& files);

}  // namespace ariadne::batch
