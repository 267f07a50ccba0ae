// How all our pages begin.
#pragma once
#include <string>
#include <string_view>

namespace ariadne::page {

/// Whether a page runs scripts of its own; none loads anything from elsewhere.
enum class Scripts { none, own };

/// All before <body>, with the style sheet that our pages share. @param title text
/// @param style the page's own, on top of it
std::string headHtml(const std::string& title, std::string_view style, Scripts scripts);

}  // namespace ariadne::page
