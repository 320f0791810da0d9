// Figures by gnuplot: a script of validation/figures behind the settings and data of one figure.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

// What goes before the script: variables and named data blocks.
class PlotInput {
 public:
  void set(std::string_view name, double value);
  void set(std::string_view name, std::string_view text);
  // Values separated by blanks; a block without rows gets one of NaN, so that gnuplot has something to skip.
  void block(std::string_view name, std::size_t columns, const std::vector<std::vector<double>>& rows);
  void labels(std::string_view name, const std::vector<std::pair<std::vector<double>, std::string>>& rows);
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

// Draws into the file `svg` and returns the drawing for a page: without XML heading, every id and reference prefixed by the
// file's stem, `description` for those who cannot see it. Throws std::runtime_error if gnuplot is not installed or fails.
std::string draw(const PlotInput& input, std::string_view script, const std::filesystem::path& svg,
                 std::string_view description);

// Text as it may stand in HTML, also between quotes.
std::string escaped(std::string_view text);

// The SVG as an element of a page; see draw().
std::string inlined(std::string svg, const std::string& prefix, std::string_view description);

}  // namespace furrow
