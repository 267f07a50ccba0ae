#include "ariadne/batch/text_table.h"

#include <algorithm>

namespace ariadne::batch {
namespace {

using Row = std::vector<std::string>;

/// Columns as terminals count them: UTF-8's later bytes take none.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string asText(const TextTable& t) {
  std::vector<std::size_t> widths;
  for (const std::string& h : t.header) widths.push_back(widthOf(h));
  for (const Row& row : t.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], widthOf(row[i]));
  const auto line = [&](const Row& row) {
    std::string out;
    for (std::size_t i = 0; i < row.size(); ++i)
      out += row[i] + std::string(widths[i] - widthOf(row[i]) + 2, ' ');
    return out.substr(0, out.find_last_not_of(' ') + 1) + "\n";
  };
  std::string out = t.title + "\n\n" + line(t.header);
  for (const Row& row : t.rows) out += line(row);
  if (!t.notes.empty()) out += "\n";
  for (const std::string& note : t.notes) out += note + "\n";
  return out;
}

std::string csvCell(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string out = "\"";
  for (const char c : cell) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string joined(const Row& row, const char* between, std::string (*cell)(const std::string&)) {
  std::string out;
  for (std::size_t i = 0; i < row.size(); ++i) out += (i == 0 ? "" : between) + cell(row[i]);
  return out;
}

std::string asCsv(const TextTable& t) {
  std::string out = joined(t.header, ",", csvCell) + "\n";
  for (const Row& row : t.rows) out += joined(row, ",", csvCell) + "\n";
  return out;
}

std::string markdownCell(const std::string& cell) {
  std::string out;
  for (const char c : cell) {
    if (c == '|' || c == '<') out += '\\';
    out += c;
  }
  return out;
}

std::string asMarkdown(const TextTable& t) {
  std::string out = "**" + t.title + "**\n\n| " + joined(t.header, " | ", markdownCell) + " |\n|";
  for (std::size_t i = 0; i < t.header.size(); ++i) out += "---|";
  out += "\n";
  for (const Row& row : t.rows) out += "| " + joined(row, " | ", markdownCell) + " |\n";
  for (const std::string& note : t.notes) out += "\n" + note + "\n";
  return out;
}

std::string latexCell(const std::string& cell) {
  std::string out;
  for (const char c : cell) {
    if (c == '<' || c == '>')
      out += std::string("$") + c + "$";
    else if (c == '~' || c == '^')
      out += std::string("\\") + c + "{}";
    else if (c == '\\')
      out += "\\textbackslash{}";
    else if (std::string("%&_#${}").find(c) != std::string::npos)
      out += std::string("\\") + c;
    else
      out += c;
  }
  return out;
}

/// Needs the package booktabs.
std::string asLatex(const TextTable& t) {
  std::string out = "% " + t.title + "\n\\begin{tabular}{" + std::string(t.header.size(), 'l') +
                    "}\n\\toprule\n" + joined(t.header, " & ", latexCell) + " \\\\\n\\midrule\n";
  for (const Row& row : t.rows) out += joined(row, " & ", latexCell) + " \\\\\n";
  out += "\\bottomrule\n\\end{tabular}\n";
  for (const std::string& note : t.notes) out += "% " + note + "\n";
  return out;
}

}  // namespace

std::string render(const TextTable& table, TableFormat format) {
  switch (format) {
    case TableFormat::csv:
      return asCsv(table);
    case TableFormat::markdown:
      return asMarkdown(table);
    case TableFormat::latex:
      return asLatex(table);
    case TableFormat::text:
      break;
  }
  return asText(table);
}

}  // namespace ariadne::batch
