#include "comparison_page.h"

#include <fmt/format.h>
#include <mrpt/system/string_utils.h>

#include <algorithm>

#include "ariadne/io/html.h"
#include "ariadne/io/whole_file.h"
#include "comparison_output.h"

namespace ariadne::compare_app {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>ariadne-slam and stock MRPT</title>
<style>
body { font: 15px/1.4 sans-serif; margin: 1.5rem auto; max-width: 90rem; padding: 0 1rem; color: #222 }
table { border-collapse: collapse } th, td { padding: .25rem .8rem; border-bottom: 1px solid #ccc }
td + td, th + th { text-align: right; font-variant-numeric: tabular-nums }
td:last-child, th:last-child { text-align: left; color: #555 }
.maps { display: flex; flex-wrap: wrap; gap: 1rem; margin-top: 1.5rem }
figure { flex: 1 1 30rem; margin: 0 } img { max-width: 100% }
.unmet { color: #a00; font-weight: bold }
</style></head><body>
)";

std::string picture(const std::filesystem::path& png, const std::string& caption) {
  const std::string bytes = io::readWhole(png);
  std::string digits;
  mrpt::system::encodeBase64({bytes.begin(), bytes.end()}, digits);
  digits.erase(std::remove(digits.begin(), digits.end(), '\n'), digits.end());  // as in e-mail
  return fmt::format(
      "<figure><figcaption>{0}</figcaption><img alt=\"{0}\" src=\"data:image/png;base64,{1}\">"
      "</figure>\n",
      caption, digits);
}

std::string table(const Comparison& c) {
  std::string out =
      "<table><tr><th></th><th>ariadne-slam</th><th>stock MRPT</th><th>ratio</th><th></th></tr>\n";
  for (const ComparedFigure& f : c.figures)
    out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                       f.kind.name(), spreadText(f.ours), spreadText(f.stock),
                       numberText(f.ratio()), io::escapedHtml(f.kind.about));
  return out + "</table>\n";
}

}  // namespace

std::string comparisonPage(const Comparison& c, const std::vector<Requirement>& requirements,
                           const std::filesystem::path& ours, const std::filesystem::path& stock) {
  std::string page = kHead;
  page += fmt::format(
      "<h1>ariadne-slam and stock MRPT</h1>\n<p>{}</p>\n<p>{} Stock's other settings: {}. {} Costs "
      "are those of whole processes, taken in turns.</p>\n",
      io::escapedHtml(c.dataset), io::escapedHtml(c.settings), io::escapedHtml(c.stock_base),
      repeatsText(c));
  page += table(c);
  for (const Requirement& r : requirements) {
    const double value = valueOf(c, r.name);
    page +=
        fmt::format("<p{}>{}: {} (it is {})</p>\n", r.metBy(value) ? "" : " class=\"unmet\"",
                    r.metBy(value) ? "met" : "not met", io::escapedHtml(r.text), numberText(value));
  }
  page += "<div class=\"maps\">\n" + picture(ours, "ariadne-slam, first run") +
          picture(stock, "stock MRPT, first run") + "</div>\n</body></html>\n";
  return page;
}

}  // namespace ariadne::compare_app
