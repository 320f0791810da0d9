#include "output/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "output/files.h"
#include "output/table.h"

namespace furrow {
namespace {

void replace_all(std::string& text, std::string_view from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
}

std::string gnuplot_number(double value) { return std::isfinite(value) ? number(value) : "NaN"; }

std::string quoted(std::string_view text) {
  std::string inside(text);
  replace_all(inside, "'", "''");
  return "'" + inside + "'";
}

// Runs gnuplot on `script`, its output into `svg`, its complaints into `complaints`; returns its exit status.
int run_gnuplot(const std::string& script, const std::string& svg, const std::string& complaints) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, svg.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, complaints.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  std::string program = "gnuplot", argument = script;
  char* const arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed == ENOENT) throw std::runtime_error("gnuplot is not installed (or not in PATH): the figures need it");
  if (failed != 0) throw std::runtime_error(std::string("gnuplot cannot be started: ") + std::strerror(failed));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

void PlotInput::set(std::string_view name, double value) { text_ << name << " = " << gnuplot_number(value) << "\n"; }

void PlotInput::set(std::string_view name, std::string_view text) { text_ << name << " = " << quoted(text) << "\n"; }

void PlotInput::block(std::string_view name, std::size_t columns, const std::vector<std::vector<double>>& rows) {
  text_ << "$" << name << " << END_OF_BLOCK\n";
  const std::vector<double> nothing(columns, std::nan(""));
  for (const auto& row : rows.empty() ? std::vector{nothing} : rows) {
    for (const double value : row) text_ << gnuplot_number(value) << " ";
    text_ << "\n";
  }
  text_ << "END_OF_BLOCK\n";
}

void PlotInput::labels(std::string_view name, const std::vector<std::pair<std::vector<double>, std::string>>& rows) {
  text_ << "$" << name << " << END_OF_BLOCK\n";
  for (const auto& [values, label] : rows) {
    for (const double value : values) text_ << gnuplot_number(value) << " ";
    text_ << '"' << label << "\"\n";
  }
  if (rows.empty()) text_ << "NaN NaN NaN \"\"\n";
  text_ << "END_OF_BLOCK\n";
}

std::string draw(const PlotInput& input, std::string_view script, const std::filesystem::path& svg,
                 std::string_view description) {
  const std::string source = svg.string() + ".gp", complaints = svg.string() + ".err";
  OutputFile file(source);
  file << "set encoding utf8\n" << input.text() << script;
  file.finish();
  const int status = run_gnuplot(source, svg.string(), complaints);
  const std::string said = run_file(complaints);
  std::filesystem::remove(complaints);
  if (status != 0) throw std::runtime_error("gnuplot failed on " + source + ":\n" + said);
  std::filesystem::remove(source);
  return inlined(run_file(svg), svg.stem().string(), description);
}

std::string escaped(std::string_view text) {
  std::string safe(text);
  replace_all(safe, "&", "&amp;");
  replace_all(safe, "<", "&lt;");
  replace_all(safe, ">", "&gt;");
  replace_all(safe, "\"", "&quot;");
  return safe;
}

std::string inlined(std::string svg, const std::string& prefix, std::string_view description) {
  const std::size_t start = svg.find("<svg");
  if (start == std::string::npos) throw std::runtime_error("gnuplot drew nothing for " + prefix);
  svg.erase(0, start);
  for (const std::string& before : {" id='", " id=\"", "href='#", "href=\"#", "url(#"}) replace_all(svg, before, before + prefix + "_");
  replace_all(svg, "<title>Gnuplot</title>", "");
  return svg.replace(0, 4, "<svg role=\"img\" aria-label=\"" + escaped(description) + "\"");
}

}  // namespace furrow
