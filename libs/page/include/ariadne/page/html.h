// What our pages are made with: text as HTML, and templates.
#pragma once
#include <functional>
#include <string>
#include <string_view>

namespace ariadne::page {

/// Text as HTML, also between quotes of an attribute.
std::string escapedHtml(std::string_view text);

/// The template with each {{name}} replaced by part(name); what comes in is not looked through
/// again.
std::string filledTemplate(std::string_view page,
                           const std::function<std::string(std::string_view name)>& part);

}  // namespace ariadne::page
