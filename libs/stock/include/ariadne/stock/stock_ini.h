// INIs of MRPT's rbpf-slam for mapping with 2D lasers, taken as they are: what means the same here
// becomes a parameter, all else is named in a warning. Table: doc/reference/parameters.md.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ariadne/io/ini_text.h"
#include "ariadne/slam/params.h"

namespace ariadne::stock {

/// An INI of MRPT's rbpf-slam in our terms, with what could not be taken over.
struct StockIni {
  slam::SlamParams params;
  std::string rawlog_file;    ///< where it was found, else as it stands in the INI; may be empty
  std::string output_folder;  ///< logOutput_dir; may be empty
  std::vector<std::string> warnings;
};

/// It has a section [MappingApplication].
bool isStockIni(const io::IniDocument& document);

/// Reads the text as MRPT does (continued lines, `@define`, $env{}, $eval{}; names without case; a
/// number ends where it ends; false is 0, no, false; enums by name or number).
/// `file` names it in messages and is where a relative rawlog_file may start from.
/// Throws core::UsageError for maps that are no 2D laser grid and for values that make no sense.
StockIni readStockIni(std::string_view text, const std::filesystem::path& file);

/// Where the stock app would look (the current folder), then beside the INI, then in the folder of
/// MRPT's samples; as given when it is in none of them.
std::string findStockRawlog(const std::string& rawlog, const std::filesystem::path& ini);

}  // namespace ariadne::stock
