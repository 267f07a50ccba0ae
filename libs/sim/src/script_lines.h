// The line format that worlds and drives share: a command and its words a line, `#` opens a
// comment.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ariadne/core/error.h"
#include "ariadne/core/fields.h"

namespace ariadne::sim {

struct ScriptLine {
  std::string where;  ///< "file:12"
  int number = 0;     ///< from 1
  std::string command;
  std::vector<std::string> words;  ///< behind the command
};

/// Lines with a command in them. Throws core::Error for NUL bytes.
std::vector<ScriptLine> scriptLines(std::string_view text, const std::string& name);

/// Throws core::Error naming the path and why it cannot be opened.
void expectReadable(const std::filesystem::path& path);

/// All of a file. Throws core::Error naming the path when it cannot be read, or is larger than any
/// script (4 MB).
std::string readScript(const std::filesystem::path& path);

/// "file:12: corridor: what".
core::Error lineError(const ScriptLine& line, const std::string& what);
/// Names the nearest of `known`.
core::Error unknownCommand(const ScriptLine& line, const std::vector<std::string>& known);

/// One word as a finite number within bounds; `what` names it in the error.
double numberIn(const ScriptLine& line, const std::string& word, const std::string& what,
                const core::Bounds& bounds);
long long wholeNumberIn(const ScriptLine& line, const std::string& word, const std::string& what,
                        const core::Bounds& bounds);

/// Throws unless the line has so many words; `usage` says which: "wall x0 y0 x1 y1".
void expectWords(const ScriptLine& line, std::size_t count, const std::string& usage);

/// Words as coordinates, metres, at most 1e5 from the origin.
std::vector<double> coordinates(const ScriptLine& line, std::size_t first = 0);

}  // namespace ariadne::sim
