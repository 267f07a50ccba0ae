// Pieces that our pages' sections are made of.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace ariadne::page {

/// A list of the page that may take a number of bytes; what comes after is only counted.
class BoundedList {
 public:
  /// @param most bytes
  explicit BoundedList(std::size_t most) : most_(most) {}
  /// @param piece HTML
  void add(const std::string& piece);
  /// What had room.
  const std::string& html() const { return text_; }
  /// Pieces that had none.
  std::size_t leftOut() const { return left_out_; }

 private:
  std::size_t most_;
  std::size_t left_out_ = 0;
  std::string text_;
};

/// A paragraph about pieces that the page has no room for; nothing when there are none.
std::string leftOutHtml(std::size_t count, const char* what, const char* where);

/// Cells of a row, as HTML already.
std::string htmlRow(const std::vector<std::string>& cells, const char* tag = "td");
/// The same, of texts.
std::string textRow(const std::vector<std::string>& cells, const char* tag = "td");

/// A table that keyboards can scroll sideways. Its headings are explained().
/// @param rows HTML
std::string htmlTable(const std::string& label, const std::vector<std::string>& header,
                      const std::string& rows);

/// Closed until it is asked for. @param inside HTML
std::string htmlDetails(const std::string& summary, const std::string& inside);

/// A text as it stands, which keyboards can scroll.
std::string htmlListing(const std::string& label, const std::string& text);

}  // namespace ariadne::page
