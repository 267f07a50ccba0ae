#include "ariadne/page/head.h"

#include <fmt/format.h>

#include "ariadne/page/html.h"
#include "style.h"

namespace ariadne::page {

std::string headHtml(const std::string& title, std::string_view style, Scripts scripts) {
  constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'{}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>{}</title>
<style>
{}{}
</style>
</head>
)";
  return fmt::format(kHead, scripts == Scripts::own ? "; script-src 'unsafe-inline'" : "",
                     escapedHtml(title), kStyle, style);
}

}  // namespace ariadne::page
