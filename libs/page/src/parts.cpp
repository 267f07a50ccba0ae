#include "ariadne/page/parts.h"

#include <fmt/format.h>

#include "ariadne/page/glossary.h"
#include "ariadne/page/html.h"

namespace ariadne::page {

namespace {

std::vector<std::string> explainedOf(const std::vector<std::string>& texts) {
  std::vector<std::string> html;
  for (const std::string& text : texts) html.push_back(explained(text));
  return html;
}

}  // namespace

void BoundedList::add(const std::string& piece) {
  if (left_out_ > 0 || text_.size() + piece.size() > most_)
    ++left_out_;
  else
    text_ += piece;
}

std::string leftOutHtml(std::size_t count, const char* what, const char* where) {
  if (count == 0) return "";
  return fmt::format("<p class=\"left-out\">{} more {} are left out of this page: see {}.</p>\n",
                     count, what, where);
}

std::string htmlRow(const std::vector<std::string>& cells, const char* tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, cell);
  return row + "</tr>\n";
}

std::string textRow(const std::vector<std::string>& cells, const char* tag) {
  std::vector<std::string> html;
  for (const std::string& cell : cells) html.push_back(escapedHtml(cell));
  return htmlRow(html, tag);
}

std::string htmlTable(const std::string& label, const std::vector<std::string>& header,
                      const std::string& rows) {
  return fmt::format(
      "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\"><table>\n<thead>{}"
      "</thead>\n<tbody>\n{}</tbody></table></div>\n",
      escapedHtml(label), htmlRow(explainedOf(header), "th"), rows);
}

std::string htmlDetails(const std::string& summary, const std::string& inside) {
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", escapedHtml(summary),
                     inside);
}

std::string htmlListing(const std::string& label, const std::string& text) {
  return fmt::format("<pre class=\"scroll\" tabindex=\"0\" aria-label=\"{}\">{}</pre>\n",
                     escapedHtml(label), escapedHtml(text));
}

}  // namespace ariadne::page
