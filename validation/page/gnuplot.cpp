#include "validation/page/gnuplot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "output/child.h"
#include "output/files.h"
#include "report/embedded.h"
#include "validation/page/svg.h"
#include "validation/page/svg_file.h"

namespace furrow::validation {
namespace {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// Never an integer: gnuplot divides those as integers.
std::string gnuplot_number(double value) {
  if (!std::isfinite(value)) return "NaN";
  const std::string text = number(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string gnuplot_text(std::string_view text) { return "'" + replaced(std::string(text), "'", "''") + "'"; }

// What it draws on its standard output.
std::string drawn_by_gnuplot(const std::string& script, const std::string& figure) {
  const ChildEnd end = run_child({.words = {"gnuplot", "{input}"}, .input = script});
  if (end.code == 127) throw std::runtime_error("gnuplot is not installed (or not in PATH): the figures need it");
  if (end.code != 0)
    throw std::runtime_error("gnuplot failed on " + figure + " (exit " + std::to_string(end.code) + "): " + end.errors);
  if (end.output.find("<svg") == std::string::npos || end.output.find("</svg>") == std::string::npos)
    throw std::runtime_error("gnuplot drew nothing for " + figure + ": " + end.errors);
  return end.output;
}

// What the lines at the head of a script say of the blocks goes before them.
std::string data_of(const PlotInput& input, std::string_view script) {
  if (input.csv().empty()) return {};
  std::string head;
  for (std::size_t at = 0; at < script.size() && script[at] == '#';) {
    const std::size_t end = std::min(script.find('\n', at), script.size());
    head += std::string(script.substr(at, end - at)) + "\n";
    at = end + 1;
  }
  return head + input.csv();
}

}  // namespace

PlotInput& PlotInput::set(std::string_view name, double value) {
  text_ += std::string(name) + " = " + gnuplot_number(value) + "\n";
  return *this;
}

PlotInput& PlotInput::set(std::string_view name, std::string_view text) {
  text_ += std::string(name) + " = " + gnuplot_text(text) + "\n";
  return *this;
}

PlotInput& PlotInput::block(std::string_view name, const std::vector<Row>& rows) {
  text_ += "$" + std::string(name) + " << END_OF_BLOCK\n";
  for (const auto& [values, label] : rows) {
    csv_ += name;
    for (const double value : values) {
      text_ += gnuplot_number(value) + ",";
      csv_ += "," + number(value);
    }
    text_ += '"' + label + "\"\n";
    csv_ += label.empty() ? "\n" : ",\"" + replaced(label, "\"", "\"\"") + "\"\n";
  }
  if (rows.empty()) text_ += "-1e9,-1e9,-1e9,-1e9\n";
  text_ += "END_OF_BLOCK\n";
  return *this;
}

std::string draw(const PlotInput& input, std::string_view script, Drawings& drawings, const std::string& name,
                 std::string_view description) {
  const std::string drawing =
      drawn_by_gnuplot("set encoding utf8\nset datafile separator comma\nset terminal svg\n" + input.text() +
                           std::string(embedded("validation/figures/palettes.gp")) + std::string(script),
                       name);
  drawings[name + ".svg"] = as_file(drawing, name, std::string(description));
  if (std::string data = data_of(input, script); !data.empty()) drawings[name + ".csv"] = std::move(data);
  return compacted(drawing, name, std::string(description));
}

std::string escaped(std::string_view text) {
  std::string safe = replaced(std::string(text), "&", "&amp;");
  safe = replaced(replaced(std::move(safe), "<", "&lt;"), ">", "&gt;");
  return replaced(std::move(safe), "\"", "&quot;");
}

}  // namespace furrow::validation
