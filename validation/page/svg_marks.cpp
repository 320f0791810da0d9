#include <string>

#include "validation/page/svg.h"

namespace furrow::validation {

std::string shared_marks() {
  const std::string line = " fill=\"none\" stroke=\"currentColor\" stroke-width=\".178\"",
                    filled = " fill=\"currentColor\"";
  const auto path = [](int index, const std::string& paint, const std::string& d) {
    return "<path id=\"gpPt" + std::to_string(index) + "\"" + paint + " d=\"" + d + "\"/>";
  };
  const std::string square = "M-1-1h2v2h-2z", up = "M0-1.33-1.33.67 1.33.67z", down = "M0 1.33 1.33-.67-1.33-.67z",
                    diamond = "M0-1.41 1.41 0 0 1.41-1.41 0z",
                    five = "M0 1.33 1.265.411.782-1.067-.782-1.076-1.265.411z";
  std::string marks = path(0, line, "M-1 0h2M0-1v2") + path(1, line, "M-1-1 1 1M1-1-1 1") +
                      path(2, line, "M-1 0 1 0M0-1 0 1M-1-1 1 1M-1 1 1-1") + path(3, line, square) +
                      path(4, filled, square) + "<circle id=\"gpPt5\"" + line + " r=\"1\"/><circle id=\"gpPt6\"" +
                      filled + " r=\"1\"/>";
  int index = 7;
  for (const std::string& shape : {up, down, diamond, five}) {
    marks += path(index, line, shape) + path(index + 1, filled, shape);
    index += 2;
  }
  const auto box = [](const std::string& id, const std::string& colour) {
    return "<filter id=\"" + id + "\" x=\"0\" y=\"0\" height=\"1\" width=\"1\"><feFlood flood-color=\"" + colour +
           "\" result=\"ground\"/><feComposite in=\"SourceGraphic\" in2=\"ground\" operator=\"atop\"/></filter>";
  };
  return "<svg width=\"0\" height=\"0\" aria-hidden=\"true\" class=\"marks\"><defs>" + marks + "<circle id=\"gpDot\"" +
         filled + " r=\".5\"/>" + box("textbox", "white") + box("greybox", "lightgrey") + "</defs></svg>\n";
}

}  // namespace furrow::validation
