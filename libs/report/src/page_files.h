// The files of page/ and Chart.js, as they were when the library was built.
#pragma once
#include <string_view>

namespace ariadne::report {

extern const std::string_view kPageHtml;
extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;
extern const std::string_view kPageChartJs;

}  // namespace ariadne::report
