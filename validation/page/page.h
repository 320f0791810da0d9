// What a page is made of while it is written.
#pragma once

#include <set>
#include <string>

#include "validation/page/gnuplot.h"

namespace furrow::validation {

struct Page {
  Drawings files;  // beside the page, by name: drawings as SVG, what they show as CSV

  // Made of the first words of a text, unlike any other of the page.
  std::string id(const std::string& words);
  bool has(const std::string& id) const { return taken_.contains(id); }

 private:
  std::set<std::string> taken_;
};

// "<h3 id=...>words #</h3>": words are HTML.
std::string heading(int level, const std::string& id, const std::string& words);

// A table that scrolls by itself, with an id to link to and a caption that may be empty (then `name` is what a screen
// reader says). head: cells as HTML; body: rows.
struct TableFrame {
  std::string id, caption, name, kind, head, body;
};
std::string framed(const TableFrame& table);
std::string head_cell(const std::string& words, bool number = false);

// A figure and its links: drawings and data of these names beside the page, and others, as HTML.
struct FigureFrame {
  std::string id, content, caption;
  std::string name{};  // of the drawing: NAME.svg, and NAME.csv if there is one; empty: no links
  std::string links{};
};
std::string framed(const Page& page, const FigureFrame& figure);

// Verdicts as signs with colours; other words as they are, escaped.
std::string chip_or_words(const std::string& words);

// HTML without its tags.
std::string bare(const std::string& html);

}  // namespace furrow::validation
