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
  // The blocks again, as comma separated values: the block's name, its numbers, its label. Empty if there are none.
  const std::string& csv() const { return csv_; }

 private:
  std::string text_, csv_;
};

// The figures of a page as they are drawn, SVG by the name of its file, and what they show, as CSV.
using Drawings = std::map<std::string, std::string>;

// Draws NAME.svg, puts the blocks of its data beside it as NAME.csv, and returns the drawing as an element of a page, see
// svg.h; `description` is for those who cannot see it. Throws std::runtime_error if gnuplot is not installed, fails, draws
// nothing, or does not end within a minute; Interrupted.
std::string draw(const PlotInput& input, std::string_view script, Drawings& drawings, const std::string& name,
                 std::string_view description);

// Text as it may stand in HTML, also between quotes.
std::string escaped(std::string_view text);

}  // namespace furrow::validation
