#include "resolved_config.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/io/scratch_folder.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/process.h"
#include "data_place.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

// What takes a moment; on a machine with many more jobs than cores one was seen to take over a
// minute.
constexpr double kPrintLimit_s = 300;

std::string trimmedEnd(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

bool namesData(const io::IniEntry& e) {
  return ((e.section == "world" || e.section == "dataset") && e.key == "file") ||
         (e.section == "experiment" && (e.key == "world" || e.key == "path" || e.key == "log"));
}

bool isData(const std::string& word) { return whyNoData(word).empty(); }

void demandData(const io::IniEntry& e, const std::string& where) {
  const std::string why = e.value.empty() ? "" : whyNoData(e.value);
  if (!why.empty())
    throw core::UsageError(
        fmt::format("{}: [{}] {} = {}: {}", where, e.section, e.key, e.value, why));
}

}  // namespace

std::string resolvedConfig(const Program& program, const ArmCall& call, const std::string& where) {
  const auto command = configCommand(program, call);
  if (command.empty()) return io::readIniText(call.config);
  const io::ScratchFolder scratch("config");
  const fs::path printed = scratch.path() / "config.ini";
  process::Process process(command, printed);
  const std::string what = program.path.string() + " --print-config";
  const process::ProcessEnd end = endOf(process, kPrintLimit_s, fmt::format("{}: {}", where, what));
  if (end.signal != 0 || end.exit_code != 0)
    throw core::UsageError(fmt::format("{}: {}", where,
                                       end.last_words.empty()
                                           ? fmt::format("{}: {}", what, describe(end))
                                           : trimmedEnd(end.last_words)));
  return io::readWhole(printed);
}

std::string meaningOfWord(const std::string& word, FileHashes& hashes,
                          std::map<std::string, std::string>& files) {
  if (!isData(word)) return word;
  return files[word] = hashes.of(word);
}

std::string meaningOf(const std::string& config, const std::string& where, FileHashes& hashes,
                      std::map<std::string, std::string>& files) {
  io::IniDocument document;
  try {
    document = io::parseIni(config, where, io::IniDialect::strict);
  } catch (const core::UsageError&) {
    return config;  // of another program: an INI in another dialect, or none
  }
  std::string meaning;
  for (const io::IniEntry& e : document.entries) {
    if (e.section == "run") continue;
    if (e.section == "dataset" && e.key == "file" && e.value.empty())
      throw core::UsageError(fmt::format(
          "{}: neither it nor its INI names a log: dataset = LOG. {}", where, kWhereDataAre));
    if (namesData(e)) demandData(e, where);
    meaning +=
        fmt::format("[{}] {} = {}\n", e.section, e.key, meaningOfWord(e.value, hashes, files));
  }
  return meaning;
}

}  // namespace ariadne::batch
