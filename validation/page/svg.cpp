#include "validation/page/svg.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

#include "validation/page/gnuplot.h"
#include "validation/page/svg_file.h"
#include "validation/page/svg_path.h"
#include "validation/page/svg_tree.h"

namespace furrow::validation {
namespace {

using Style = std::map<std::string, std::string>;

// What a group hands down, besides its transform.
const std::array<const char*, 10> styling{"fill",         "stroke",      "color",     "stroke-width", "stroke-linejoin",
                                          "fill-opacity", "font-family", "font-size", "text-anchor",  "font-weight"};

// "rgb( 12,  0, 255)" as "#0c00ff", black as the colour of the text around.
std::string colour_of(const std::string& colour) {
  if (colour == "black") return "currentColor";
  if (colour.rfind("rgb(", 0) != 0) return colour;
  std::array<int, 3> part{};
  if (std::sscanf(colour.c_str(), "rgb( %d , %d , %d )", &part[0], &part[1], &part[2]) != 3) return colour;
  if (part[0] + part[1] + part[2] == 0) return "currentColor";
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", part[0] & 255, part[1] & 255, part[2] & 255);
  return text.data();
}

std::string value_or(const Style& style, const std::string& key, const std::string& otherwise) {
  const auto found = style.find(key);
  return found == style.end() ? otherwise : found->second;
}

// The colour that an attribute stands for: "currentColor" is the group's.
std::string paint_of(const SvgNode& node, const Style& style, const std::string& key, const std::string& otherwise) {
  std::string paint = node.attribute(key);
  if (paint.empty()) paint = value_or(style, key, otherwise);
  if (paint == "currentColor") {
    const std::string own = node.attribute("color");
    paint = own.empty() ? value_or(style, "color", "black") : own;
  }
  return colour_of(paint);
}

// Translation and scale of a mark.
struct Place {
  double x = 0, y = 0, scale = 1;
  bool known = false;
};

Place place_of(const std::string& transform) {
  Place place;
  double x = 0, y = 0, scale = 1;
  const int read = std::sscanf(transform.c_str(), "translate(%lf,%lf) scale(%lf)", &x, &y, &scale);
  if (read == 3 && transform.find("rotate") == std::string::npos) place = {x, y, scale, true};
  return place;
}

class Compactor {
 public:
  explicit Compactor(std::string name) : name_(std::move(name)) {}

  std::string body(const SvgNode& svg) {
    walk(svg, {});
    release();
    flush();
    return out_;
  }

 private:
  void walk(const SvgNode& node, const Style& style) {
    for (const SvgNode& child : node.children) {
      if (child.name != "use") release();
      if (child.name == "g" && child.attribute("transform").rfind("translate", 0) == 0) {
        texts(child, style);
      } else if (child.name == "g") {
        group(child, style);
      } else if (child.name == "path" || child.name == "polygon" || child.name == "rect" || child.name == "circle") {
        shape(child, style);
      } else if (child.name == "use") {
        mark(child, style);
      } else if (child.name == "defs" && !shared(child)) {
        flush();
        out_ += own_ids(text_of(child));
      }
    }
  }

  void group(const SvgNode& node, Style style) {
    for (const char* key : styling) {
      if (const std::string value = node.attribute(key); !value.empty()) style[key] = value;
    }
    const auto titled = std::find_if(node.children.begin(), node.children.end(),
                                     [](const SvgNode& child) { return child.name == "title"; });
    const std::string title =
        titled != node.children.end() && !titled->children.empty() ? titled->children[0].text : "";
    flush();
    const std::size_t before = out_.size();
    walk(node, style);
    release();
    flush();
    if (says_something(title) && out_.size() > before)
      out_ = out_.substr(0, before) + "<g><title>" + title + "</title>" + out_.substr(before) + "</g>";
  }

  // What is drawn in one style goes into one group.
  void add(const std::string& style, const std::string& element) {
    if (style != style_) flush();
    style_ = style;
    pending_ += element;
    ++count_;
  }

  // Lines of one style are one path: `d` goes on where the last one ended.
  void add_line(const std::string& style, const std::string& d) {
    if (style != style_ || !line_) flush();
    style_ = style;
    line_ = true;
    pending_ += d;
    count_ = 1;
  }

  void flush() {
    if (line_) {
      out_ += "<path" + style_ + " d=\"" + pending_ + "\"/>";
    } else if (count_ > 0) {
      out_ += style_.empty() ? pending_ : "<g" + style_ + ">" + pending_ + "</g>";
    }
    out_ += pending_.empty() ? "" : "\n";
    pending_.clear();
    style_.clear();
    line_ = false;
    count_ = 0;
  }

  // "0.40" as ".4"; empty: none.
  static std::string faintness(const SvgNode& node) {
    const std::string value = node.attribute("opacity");
    return value.empty() ? value : short_number(std::strtod(value.c_str(), nullptr), 2);
  }

  std::string painted(const SvgNode& node, const Style& style) const {
    const std::string fill = paint_of(node, style, "fill", "none");
    std::string stroke = paint_of(node, style, "stroke", "none");
    // gnuplot fills polygons without a stroke of their own.
    if (node.name == "polygon" && node.attribute("stroke").empty()) stroke = "none";
    std::string text;
    if (fill != "none") text += " fill=\"" + fill + "\"";
    if (stroke != "none") {
      const std::string own = node.attribute("stroke-width");
      const double width = std::strtod((own.empty() ? value_or(style, "stroke-width", "1") : own).c_str(), nullptr);
      text += " stroke=\"" + stroke + "\"";
      if (width != 1) text += " stroke-width=\"" + short_number(width, 2) + "\"";
    }
    for (const char* key : {"stroke-dasharray", "fill-opacity", "stroke-opacity", "opacity", "filter"}) {
      std::string value = node.attribute(key);
      if (value.empty() && std::string(key) == "fill-opacity") value = value_or(style, key, "");
      if (value.find_first_of("#") != std::string::npos) value = own_ids(value);
      if (std::string(key) == "opacity") value = faintness(node);
      if (!value.empty() && value != "1") text += std::string(" ") + key + "=\"" + value + "\"";
    }
    return text;
  }

  void shape(const SvgNode& node, const Style& style) {
    const std::string paint = painted(node, style);
    if (paint.empty()) return;  // nothing to see
    if (node.name == "path" || node.name == "polygon") {
      const std::string d =
          node.name == "path" ? short_path(node.attribute("d")) : closed_path(node.attribute("points"));
      if (d.empty()) return;
      if (paint.find("fill") == std::string::npos && paint.find("dash") == std::string::npos) return add_line(paint, d);
      return add(paint, "<path d=\"" + d + "\"/>");
    }
    std::string element = "<" + node.name;
    for (const char* key : {"points", "x", "y", "width", "height", "cx", "cy", "r", "rx"}) {
      if (const std::string value = node.attribute(key); !value.empty())
        element += std::string(" ") + key + "=\"" + short_numbers(value) + "\"";
    }
    add(paint, element + "/>");
  }

  void mark(const SvgNode& node, const Style& style) {
    const std::string shape = node.attribute("xlink:href"), transform = node.attribute("transform");
    const std::string colour = paint_of(node, style, "color", "black"), faint = faintness(node);
    const std::string opacity = faint.empty() || faint == "1" ? "" : " opacity=\"" + faint + "\"";
    const Place place = place_of(transform);
    if (place.known && shape == "#gpPt6") return disc(place, colour, opacity);
    release();
    if (place.known && shape == "#gpPt4") return dot(place, colour, opacity, "square");
    const std::string paint = " color=\"" + colour + "\"" + opacity, use = "<use href=\"" + shape + "\"";
    if (!place.known) return add(paint, use + " transform=\"" + short_numbers(transform, 2) + "\"/>");
    // The group scales, so that a mark says no more than its place.
    const std::string scale = short_number(place.scale, 2);
    const double scaled = std::strtod(scale.c_str(), nullptr);
    add(paint + " transform=\"scale(" + scale + ")\"",
        use + " x=\"" + short_number(place.x / scaled, 2) + "\" y=\"" + short_number(place.y / scaled, 2) + "\"/>");
  }

  // A disc on a larger one at the same place is one circle with a rim, so each waits for the next.
  void disc(const Place& place, const std::string& colour, const std::string& opacity) {
    if (held_.known && held_.x == place.x && held_.y == place.y && held_.scale > place.scale && opacity.empty() &&
        held_opacity_.empty()) {
      add(" stroke=\"" + held_colour_ + "\" stroke-width=\"" + short_number(held_.scale - place.scale, 2) + "\"",
          "<circle cx=\"" + short_number(place.x) + "\" cy=\"" + short_number(place.y) + "\" r=\"" +
              short_number((held_.scale + place.scale) / 2) + "\" fill=\"" + colour + "\"/>");
      held_.known = false;
      return;
    }
    release();
    held_ = place, held_colour_ = colour, held_opacity_ = opacity;
  }

  void release() {
    if (std::exchange(held_.known, false)) dot(held_, held_colour_, held_opacity_, "round");
  }

  // The end of a line without a length.
  void dot(const Place& place, const std::string& colour, const std::string& opacity, const std::string& cap) {
    add_line(" stroke=\"" + colour + "\"" + opacity + " stroke-width=\"" + short_number(2 * place.scale, 2) +
                 "\" stroke-linecap=\"" + cap + "\"",
             "M" + short_number(place.x) + (place.y < 0 ? "" : " ") + short_number(place.y) + "h0");
  }

  void texts(const SvgNode& node, const Style& style) {
    const std::string transform = node.attribute("transform"), fill = paint_of(node, style, "fill", "black");
    std::string placed;
    double x = 0, y = 0;
    if (transform.find("rotate") == std::string::npos &&
        std::sscanf(transform.c_str(), "translate(%lf,%lf)", &x, &y) == 2)
      placed = " x=\"" + short_number(x) + "\" y=\"" + short_number(y) + "\"";
    else
      placed = " transform=\"" + short_numbers(transform) + "\"";
    const std::string anchor = node.attribute("text-anchor"), size = node.attribute("font-size"),
                      weight = node.attribute("font-weight");
    std::string common = " font-size=\"" + short_number(std::strtod(size.c_str(), nullptr)) + "\"";
    if (!anchor.empty() && anchor != "start") common += " text-anchor=\"" + anchor + "\"";
    if (!weight.empty() && weight != "normal") common += " font-weight=\"" + weight + "\"";
    if (fill != "currentColor") common += " fill=\"" + fill + "\"";
    for (const SvgNode& child : node.children) {
      if (child.name != "text") continue;
      const std::string words = words_of(child);
      if (!words.empty()) add(common, "<text" + placed + ">" + words + "</text>");
    }
  }

  static bool shared(const SvgNode& defs) { return text_of(defs).find("gpDot") != std::string::npos; }

  std::string own_ids(std::string text) const {
    for (const std::string before : {"id=\"", "href=\"#", "url(#"}) {
      for (std::size_t at = 0; (at = text.find(before, at)) != std::string::npos; at += before.size()) {
        const std::size_t after = at + before.size();
        if (text.compare(after, 4, "gpPt") != 0 && text.compare(after, 7, "textbox") != 0 &&
            text.compare(after, 7, "greybox") != 0)
          text.insert(after, name_ + "_");
      }
    }
    return text;
  }

  std::string name_, out_, pending_, style_, held_colour_, held_opacity_;
  Place held_;
  bool line_ = false;
  int count_ = 0;
};

}  // namespace

std::string compacted(std::string_view file, const std::string& name, const std::string& description) {
  const SvgNode svg = parsed_svg(file);
  const std::string box = short_numbers(svg.attribute("viewBox"));
  return "<svg role=\"img\" aria-label=\"" + escaped(description) + "\" viewBox=\"" + box + "\" data-width=\"" +
         short_number(std::strtod(svg.attribute("width").c_str(), nullptr)) + "\">\n" + Compactor(name).body(svg) +
         "</svg>";
}

}  // namespace furrow::validation
