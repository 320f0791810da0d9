// Figures by gnuplot: a script of validation/figures after the settings and data of one figure.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace furrow::validation {

// What goes before the script: variables, and data as named blocks.
class PlotInput {
 public:
  PlotInput& set(std::string_view name, double value);
  PlotInput& set(std::string_view name, std::string_view text);
  // Rows of numbers, each with a label that may be empty. A block without rows gets one that is out of sight, since
  // gnuplot 5.4 crashes on labels that are all undefined.
  using Row = std::pair<std::vector<double>, std::string>;
  PlotInput& block(std::string_view name, const std::vector<Row>& rows);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// The figures of a page as they are drawn: SVG by the name of its file.
using Drawings = std::map<std::string, std::string>;

// Draws NAME.svg and returns the drawing as an element of a page: every id and reference is prefixed by the name,
// `description` is for those who cannot see it. Throws std::runtime_error if gnuplot is not installed, fails, draws
// nothing, or does not end within a minute; Interrupted.
std::string draw(const PlotInput& input, std::string_view script, Drawings& drawings, const std::string& name,
                 std::string_view description);

// Text as it may stand in HTML, also between quotes.
std::string escaped(std::string_view text);

}  // namespace furrow::validation
