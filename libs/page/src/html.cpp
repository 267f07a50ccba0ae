#include "ariadne/page/html.h"

namespace ariadne::page {

std::string escapedHtml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else
      out += c;
  }
  return out;
}

std::string filledTemplate(std::string_view page,
                           const std::function<std::string(std::string_view name)>& part) {
  std::string out;
  for (std::size_t at = 0;;) {
    const std::size_t open = page.find("{{", at);
    out += page.substr(at, open - at);
    if (open == std::string_view::npos) return out;
    const std::size_t close = page.find("}}", open);
    out += part(page.substr(open + 2, close - open - 2));
    at = close + 2;
  }
}

}  // namespace ariadne::page
