#include "validation/page/svg_file.h"

#include <cstdio>

#include "output/files.h"
#include "validation/page/gnuplot.h"

namespace furrow::validation {
namespace {

constexpr double beside = 12, above = 8;  // px

// `head`: of the element <svg>.
std::string with_margin(std::string head) {
  const std::size_t size = head.find("width=\""), box = head.find("viewBox=\"");
  double width = 0, height = 0;
  if (size == std::string::npos || box == std::string::npos || size > box ||
      std::sscanf(head.c_str() + box, "viewBox=\"0 0 %lf %lf\"", &width, &height) != 2)
    return head;
  const std::string across = number(width + 2 * beside), down = number(height + 2 * above);
  return head.substr(0, size) + "width=\"" + across + "\" height=\"" + down + "\"\n viewBox=\"" + number(-beside) +
         " " + number(-above) + " " + across + " " + down + head.substr(head.find('"', box + 9));
}

}  // namespace

bool says_something(std::string_view title) {
  return !title.empty() && title.find_first_of("$'") != 0 && title.find(" using ") == std::string_view::npos &&
         title.rfind("gnuplot", 0) != 0 && title.rfind("Gnuplot", 0) != 0 && title.rfind("&#39;", 0) != 0;
}

std::string as_file(std::string_view drawing, const std::string& name, const std::string& what) {
  const std::string_view open = "<title>", close = "</title>", id = "id=\"gnuplot_";
  std::string text;
  bool first = true;
  for (std::size_t at = 0;;) {
    const std::size_t title = drawing.find(open, at), end = drawing.find(close, title);
    if (end == std::string_view::npos) {
      text += drawing.substr(at);
      break;
    }
    text += first ? with_margin(std::string(drawing.substr(at, title - at))) : drawing.substr(at, title - at);
    at = end + close.size();
    const std::string_view words = drawing.substr(title + open.size(), end - title - open.size());
    if (first)
      text += "<title>" + escaped(what) + "</title>";
    else if (says_something(words))
      text += drawing.substr(title, at - title);
    first = false;
  }
  for (std::size_t at = 0; (at = text.find(id, at)) != std::string::npos; at += id.size())
    text.replace(at, id.size(), "id=\"" + name + "_");
  return text;
}

}  // namespace furrow::validation
