#include "comparison_page.h"

#include <fmt/format.h>
#include <mrpt/system/string_utils.h>

#include <algorithm>

#include "ariadne/io/whole_file.h"
#include "ariadne/page/glossary.h"
#include "ariadne/page/head.h"
#include "ariadne/page/html.h"
#include "ariadne/page/parts.h"
#include "comparison_output.h"
#include "page_files.h"

namespace ariadne::compare_app {
namespace {

namespace fs = std::filesystem;
using page::escapedHtml;

std::string picture(const fs::path& png, const std::string& caption) {
  const std::string bytes = io::readWhole(png);
  std::string digits;
  mrpt::system::encodeBase64({bytes.begin(), bytes.end()}, digits);
  digits.erase(std::remove(digits.begin(), digits.end(), '\n'), digits.end());  // as in e-mail
  return fmt::format(
      "<figure class=\"card\"><figcaption>{0}</figcaption><img alt=\"Map by {0}\" "
      "src=\"data:image/png;base64,{1}\"></figure>\n",
      caption, digits);
}

std::string factsHtml(const Comparison& c) {
  std::string text;
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, escapedHtml(value));
  };
  add("Log", c.dataset);
  add("Settings of both", c.settings);
  add("Stock's other settings", c.stock_base);
  return text;
}

std::string figuresHtml(const Comparison& c) {
  std::string rows;
  for (const ComparedFigure& f : c.figures)
    rows += page::htmlRow({page::explained(f.kind.name()), escapedHtml(spreadText(f.ours)),
                           escapedHtml(spreadText(f.stock)), numberText(f.ratio()),
                           escapedHtml(f.kind.about)});
  return page::htmlTable("Figures", {"", "ariadne-slam", "stock MRPT", "ratio", ""}, rows);
}

std::string requirementsHtml(const Comparison& c, const std::vector<Requirement>& requirements) {
  if (requirements.empty()) return "";
  std::string items;
  for (const Requirement& r : requirements) {
    const double value = valueOf(c, r.name);
    items +=
        fmt::format("<li{}>{}: {} (it is {})</li>\n", r.metBy(value) ? "" : " class=\"unmet\"",
                    r.metBy(value) ? "met" : "not met", escapedHtml(r.text), numberText(value));
  }
  return "<section class=\"card\" aria-labelledby=\"requirements-heading\">\n"
         "<h2 id=\"requirements-heading\">Requirements</h2>\n<ul>\n" +
         items + "</ul>\n</section>\n";
}

}  // namespace

std::string comparisonPage(const Comparison& c, const std::vector<Requirement>& requirements,
                           const fs::path& ours, const fs::path& stock) {
  const std::string title =
      "ariadne-slam and stock MRPT on " + fs::path(c.dataset).filename().string();
  return page::filledTemplate(kPageHtml, [&](std::string_view part) -> std::string {
    if (part == "head") return page::headHtml(title, kPageStyle, page::Scripts::none);
    if (part == "title") return escapedHtml(title);
    if (part == "facts") return factsHtml(c);
    if (part == "figures") return figuresHtml(c);
    if (part == "repeats") return repeatsText(c);
    if (part == "requirements") return requirementsHtml(c, requirements);
    return picture(ours, "ariadne-slam") + picture(stock, "stock MRPT");
  });
}

}  // namespace ariadne::compare_app
