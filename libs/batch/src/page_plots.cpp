#include "page_plots.h"

#include <fmt/format.h>

#include "ariadne/page/html.h"
#include "ariadne/page/parts.h"

namespace ariadne::batch {
namespace {

constexpr std::size_t kMostBytes = 2000000;

std::string titleOf(const Plot& plot) {
  std::string title = plot.figure;
  if (!plot.factor.empty()) title += " over " + plot.factor;
  return plot.panel.empty() ? title : title + ", " + plot.panel;
}

void replaceFirst(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at != std::string::npos) text.replace(at, from.size(), to);
}

/// gnuplot's file as a part of the page. The marks that points are made of are the same in all
/// files and named alike: the first picture's serve all.
std::string inlined(std::string svg, const std::string& label, bool is_first) {
  svg.erase(0, svg.find("<svg"));
  replaceFirst(svg, "<svg", fmt::format("<svg role=\"img\" aria-label=\"{}\"", label));
  replaceFirst(svg, "<g id=\"gnuplot_canvas\">", "<g>");
  const std::size_t title = svg.find("<title>");  // a tip that would show everywhere
  if (title != std::string::npos) svg.erase(title, svg.find("<g>") - title);
  const std::size_t marks = svg.find("<defs>");
  if (!is_first && marks != std::string::npos) svg.erase(marks, svg.find("</defs>") + 7 - marks);
  return svg;
}

std::string numbersOf(const Plot& plot) {
  std::string rows;
  for (const PlotSeries& s : plot.series)
    for (const PlotPoint& p : s.points) {
      std::vector<std::string> row = {s.name, fmt::format("{:.6g}", p.value),
                                      fmt::format("{:.6g}", p.low), fmt::format("{:.6g}", p.high),
                                      std::to_string(p.runs)};
      if (!plot.factor.empty()) row.insert(row.begin(), plot.places[p.place]);
      rows += page::textRow(row);
    }
  std::vector<std::string> header = {"arm", plot.figure, "from", "to", "runs"};
  if (!plot.factor.empty()) header.insert(header.begin(), plot.factor);
  return page::htmlDetails("Numbers", page::htmlTable("Numbers of " + titleOf(plot), header, rows));
}

}  // namespace

std::string plotsHtml(const std::vector<Plot>& plots, const std::vector<Picture>& pictures) {
  if (plots.empty())
    return "<p>None: the INI asks for none, or no run is finished that has what they show.</p>\n";
  page::BoundedList list(kMostBytes);
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const std::string title = page::escapedHtml(titleOf(plots[i]));
    std::string picture;
    if (i < pictures.size())
      picture = fmt::format(
          "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">\n{}</div>\n",
          title, inlined(pictures[i].svg, title, i == 0));
    list.add(
        fmt::format("<figure class=\"card plot\"><figcaption><h3>{}</h3><p>{}</p>"
                    "</figcaption>\n{}{}</figure>\n",
                    title, page::escapedHtml(plots[i].about), picture, numbersOf(plots[i])));
  }
  return (pictures.empty() ? "<p>They could not be drawn: gnuplot was missing or failed.</p>\n"
                           : "") +
         ("<div class=\"chart-grid\">\n" + list.html() + "</div>\n") +
         page::leftOutHtml(list.leftOut(), "plots", "the folder plots");
}

}  // namespace ariadne::batch
