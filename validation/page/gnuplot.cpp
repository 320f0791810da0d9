#include "page/gnuplot.h"

#include <sys/wait.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "output/files.h"
#include "page/table.h"

namespace furrow {
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

void run_gnuplot(const std::string& script) {
  FILE* pipe = popen(("gnuplot '" + replaced(script, "'", "'\\''") + "' 2>&1").c_str(), "r");
  if (!pipe) throw std::runtime_error("gnuplot cannot be started");
  std::string said;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), part.size(), pipe)) said += part.data();
  const int status = pclose(pipe);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) {
    throw std::runtime_error("gnuplot is not installed (or not in PATH): the figures need it");
  }
  if (status != 0) throw std::runtime_error("gnuplot failed on " + script + ": " + said);
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
    for (const double value : values) text_ += gnuplot_number(value) + ",";
    text_ += '"' + label + "\"\n";
  }
  if (rows.empty()) text_ += "-1e9,-1e9,-1e9,-1e9\n";
  text_ += "END_OF_BLOCK\n";
  return *this;
}

std::string draw(const PlotInput& input, std::string_view script, const std::filesystem::path& svg,
                 std::string_view description) {
  const std::string source = svg.string() + ".gp";
  OutputFile file(source);
  file << "set encoding utf8\nset datafile separator comma\nset terminal svg\nset output " << gnuplot_text(svg.string())
       << "\n"
       << input.text() << script;
  file.finish();
  std::filesystem::remove(svg);  // one of an earlier run must not pass for this one's
  run_gnuplot(source);
  std::filesystem::remove(source);
  std::string text = std::filesystem::exists(svg) ? run_text(svg) : "";
  if (text.find("<svg") == std::string::npos || text.find("</svg>") == std::string::npos)
    throw std::runtime_error("gnuplot drew nothing into " + svg.string());
  text.erase(0, text.find("<svg"));
  for (const std::string before : {" id='", " id=\"", "href='#", "href=\"#", "url(#"}) {
    text = replaced(std::move(text), before, before + svg.stem().string() + "_");
  }
  text = replaced(std::move(text), "<title>Gnuplot</title>", "");
  return text.replace(0, 4, "<svg role=\"img\" aria-label=\"" + escaped(description) + "\"");
}

std::string escaped(std::string_view text) {
  std::string safe = replaced(std::string(text), "&", "&amp;");
  safe = replaced(replaced(std::move(safe), "<", "&lt;"), ">", "&gt;");
  return replaced(std::move(safe), "\"", "&quot;");
}

}  // namespace furrow
