#include "export/engine_output.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "export/export.h"
#include "output/files.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

// The number in "end.10.txt"; 0 if it is another file.
int refine_of(const std::string& name) {
  if (!name.starts_with("end.") || !name.ends_with(".txt") || name.size() < 9) return 0;
  int refine = 0;
  for (const char digit : name.substr(4, name.size() - 8)) {
    if (digit < '0' || digit > '9' || refine > 1'000'000) return 0;
    refine = 10 * refine + (digit - '0');
  }
  return refine;
}

// Of the last of the moments in a local dump: number, then the two.
std::vector<std::vector<double>> last_entries(const fs::path& file) {
  std::vector<std::vector<double>> last;
  std::ifstream stream(file);
  bool entries = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("ITEM:")) {
      entries = line.starts_with("ITEM: ENTRIES");
      if (entries) last.clear();
    } else if (entries) {
      std::istringstream words(line);
      double number = 0, a = 0, b = 0;
      if (words >> number >> a >> b) last.push_back({a, b});
    }
  }
  return last;
}

EngineOutput read(const fs::path& directory, int refine) {
  EngineOutput out;
  out.refine = refine;
  const auto rows = [&](const std::string& file, std::size_t columns) {
    return fs::exists(directory / file) ? rows_of_numbers(directory / file, columns)
                                        : std::vector<std::vector<double>>{};
  };
  out.forces = rows(forces_file(refine), 0);
  out.tears = rows(tears_file(refine), 2);
  if (fs::exists(directory / links_file(refine))) out.links = last_entries(directory / links_file(refine));
  // Before its atoms a dump has its box, in rows of two, and counts, in rows of one.
  for (const auto& row : rows(ends_file(refine), 5))
    out.end.push_back({static_cast<int>(row[0]), {row[1], row[2]}, {row[3], row[4]}});
  return out;
}

}  // namespace

std::vector<std::vector<double>> rows_of_numbers(const fs::path& file, std::size_t columns) {
  std::ifstream stream(file);
  if (!stream) throw FileError(file.string() + ": cannot be read");
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    std::vector<double> row;
    for (double value; words >> value;) row.push_back(value);
    if (words.eof() && !row.empty() && (columns == 0 || row.size() == columns)) rows.push_back(row);
  }
  return rows;
}

std::vector<EngineOutput> engine_outputs(const fs::path& directory) {
  std::vector<int> refines;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (const int refine = refine_of(entry.path().filename()); refine > 0) refines.push_back(refine);
  }
  if (refines.empty())
    throw FileError(directory.string() + ": the engine has left no end.1.txt; run it there: lmp -in in.lammps");
  std::sort(refines.begin(), refines.end());
  std::vector<EngineOutput> all;
  for (const int refine : refines) all.push_back(read(directory, refine));
  return all;
}

}  // namespace furrow
