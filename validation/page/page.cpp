#include "validation/page/page.h"

#include <cctype>
#include <map>

#include "validation/page/html.h"

namespace furrow::validation {
namespace {

constexpr std::size_t longest_id = 56;

std::string slug(const std::string& words) {
  std::string id;
  for (const char c : words) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!id.empty() && id.back() != '_')
      id += '_';
  }
  if (id.size() > longest_id)
    id.erase(id.rfind('_', longest_id) == std::string::npos ? longest_id : id.rfind('_', longest_id));
  while (!id.empty() && id.back() == '_') id.pop_back();
  return id.empty() ? "part" : id;
}

std::string link_here(const std::string& id, const std::string& what) {
  return "<a class=\"here\" href=\"#" + id + "\" aria-label=\"Link to this: " + escaped(what) + "\">#</a>";
}

}  // namespace

std::string Page::id(const std::string& words) {
  const std::string wanted = slug(words);
  std::string id = wanted;
  for (int k = 2; !taken_.insert(id).second; ++k) id = wanted + "_" + std::to_string(k);
  return id;
}

std::string bare(const std::string& html) {
  std::string text;
  bool inside = false;
  for (const char c : html) {
    if (c == '<') inside = true;
    if (!inside) text += c;
    if (c == '>') inside = false;
  }
  return text;
}

std::string heading(int level, const std::string& id, const std::string& words) {
  const std::string tag = "h" + std::to_string(level);
  return "<" + tag + " id=\"" + id + "\">" + words + " " + link_here(id, bare(words)) + "</" + tag + ">\n";
}

std::string head_cell(const std::string& words, bool number) {
  return std::string("<th scope=\"col\"") + (number ? " class=\"number\">" : ">") + words + "</th>";
}

std::string framed(const TableFrame& table) {
  const std::string first = bare(table.caption), said = first.substr(0, first.find_first_of(".:;"));
  const std::string name = said.empty() || said == table.name ? table.name : table.name + ": " + said;  // unlike others
  const std::string caption =
      element("caption", (table.caption.empty() ? "<span class=\"unseen\">" + table.name + "</span>" : table.caption) +
                             " " + link_here(table.id, "table"));
  return "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped(bare(name)) +
         "\"><table id=\"" + table.id + "\" class=\"" + table.kind + "\">" + caption +
         element("thead", element("tr", table.head)) + element("tbody", table.body) + "</table></div>\n";
}

std::string framed(const Page& page, const FigureFrame& figure) {
  std::string links = figure.links;
  const auto add = [&](const std::string& file, const std::string& words) {
    if (page.files.contains(file)) links += " <a href=\"" + file + "\">" + words + "</a>";
  };
  if (!figure.name.empty()) {
    add(figure.name + ".svg", "drawing");
    add(figure.name + ".csv", "data (CSV)");
  }
  return "<figure id=\"" + figure.id + "\">" + figure.content +
         element("figcaption", figure.caption + " <span class=\"links\">" + links + " " +
                                   link_here(figure.id, "figure") + "</span>") +
         "</figure>\n";
}

std::string chip_or_words(const std::string& words) {
  static const std::map<std::string, std::pair<const char*, const char*>> chips{{"reproduced", {"good", "✓"}},
                                                                                {"reproduced in kind", {"partly", "≈"}},
                                                                                {"not reproduced", {"bad", "✗"}},
                                                                                {"not testable", {"none", "–"}},
                                                                                {"kept", {"good", "✓"}},
                                                                                {"allowed", {"partly", "!"}},
                                                                                {"warned", {"bad", "✗"}},
                                                                                {"broken", {"bad", "✗"}},
                                                                                {"not watched", {"none", "–"}},
                                                                                {"no: not ranked", {"bad", "✗"}},
                                                                                {"below the limit", {"good", "✓"}},
                                                                                {"above the limit", {"bad", "✗"}},
                                                                                {"right", {"good", "✓"}},
                                                                                {"lower order", {"partly", "≈"}},
                                                                                {"another law", {"bad", "✗"}},
                                                                                {"failed", {"bad", "!"}},
                                                                                {"cannot", {"none", "–"}}};
  const auto found = chips.find(words);
  if (found == chips.end()) return escaped(words);
  return std::string("<span class=\"chip ") + found->second.first + "\"><span aria-hidden=\"true\">" +
         found->second.second + "</span> " + words + "</span>";
}

}  // namespace furrow::validation
