#include "export/engine_output.h"

#include <algorithm>
#include <set>

#include "export/engine_file.h"
#include "export/export.h"
#include "output/files.h"
#include "scene/wording.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;
using Bond = std::pair<int, int>;

// The rows of one output; `every`: steps of the engine between two of them.
class Series {
 public:
  Series(const fs::path& file, int refine, const std::string& scene_hash) : file_(file, refine), hash_(scene_hash) {}

  std::vector<std::vector<double>> rows(std::size_t columns, long every, long count) {
    std::vector<std::vector<double>> rows;
    while (file_.next()) {
      if (file_.line().starts_with('#')) {
        tied_ = tied_ || file_.line() == output_title(hash_);
        continue;
      }
      if (!tied_) file_.fail_whole("is of another deck: it does not name the scene " + hash_);
      if (static_cast<long>(rows.size()) == count) file_.fail("is more than the run has");
      rows.push_back(file_.row(columns));
      const long step = static_cast<long>(rows.size() - 1) * every;
      if (rows.back().front() != static_cast<double>(step))
        file_.fail("is of step " + shortest(rows.back().front()) + ", not " + std::to_string(step));
    }
    if (static_cast<long>(rows.size()) < count)
      file_.fail_whole("ends after " + std::to_string(rows.size()) + " of " + std::to_string(count) + " rows");
    return rows;
  }

  const EngineFile& file() const { return file_; }

 private:
  EngineFile file_;
  const std::string& hash_;
  bool tied_ = false;
};

// Before its entries a dump has its step, their number, and its box.
long dump_heading(EngineFile& file, long step, const std::string& entries) {
  file.expect_number(step, "step");
  file.expect("ITEM: NUMBER OF " + entries);
  const long count = file.count();
  file.expect("ITEM: BOX BOUNDS");
  for (int axis = 0; axis < 3; ++axis) {
    file.need_next();
    file.row(2);
  }
  return count;
}

int body_of(const EngineFile& file, double id, int bodies) {
  if (!(id >= 1 && id <= bodies && id == static_cast<int>(id)))
    file.fail("has body " + shortest(id) + ", but the scene has 1 to " + std::to_string(bodies));
  return static_cast<int>(id);
}

std::vector<EngineBody> bodies_at_end(const fs::path& path, int refine, const DeckRun& run) {
  EngineFile file(path, refine);
  file.expect("ITEM: TIMESTEP");
  if (const long count = dump_heading(file, run.steps * refine, "ATOMS"); count != run.bodies)
    file.fail_whole("has " + std::to_string(count) + " bodies, not " + std::to_string(run.bodies));
  file.expect("ITEM: ATOMS id x y vx vy");
  std::vector<EngineBody> bodies;
  std::set<int> seen;
  for (int k = 0; k < run.bodies; ++k) {
    file.need_next();
    const std::vector<double> row = file.row(5);
    const int id = body_of(file, row[0], run.bodies);
    if (!seen.insert(id).second) file.fail("has body " + std::to_string(id) + " again");
    bodies.push_back({id, {row[1], row[2]}, {row[3], row[4]}});
  }
  if (file.next()) file.fail("is more than the run has");
  return bodies;
}

// The bonds that are whole at one step.
std::set<Bond> whole_bonds(EngineFile& file, long step, const DeckRun& run) {
  const long count = dump_heading(file, step, "ENTRIES");
  file.expect("ITEM: ENTRIES");
  std::set<Bond> bonds;
  for (long k = 0; k < count; ++k) {
    file.need_next();
    const std::vector<double> row = file.row(3);
    const Bond bond = std::minmax({body_of(file, row[1], run.bodies), body_of(file, row[2], run.bodies)});
    if (!run.bonds.contains(bond)) file.fail("has a link that the scene has not");
    if (!bonds.insert(bond).second) file.fail("has a link again");
  }
  return bonds;
}

std::map<int, StepSpan> links_of(const fs::path& path, int refine, const DeckRun& run) {
  EngineFile file(path, refine);
  std::map<int, StepSpan> links;
  for (const auto& [bond, link] : run.bonds) links[link] = {static_cast<double>(run.last_row()), infinity};
  for (long step = 0; step <= run.last_row(); step += run.every) {
    file.expect("ITEM: TIMESTEP");
    const std::set<Bond> whole = whole_bonds(file, step * refine, run);
    for (const auto& [bond, link] : run.bonds) {
      StepSpan& torn = links[link];
      if (whole.contains(bond) == (torn.by == infinity)) continue;
      if (torn.by < infinity)
        file.fail_whole("has a link again that was torn, at step " + std::to_string(step * refine));
      if (step == 0) file.fail_whole("has fewer links at the start than the scene");
      torn = {static_cast<double>(step - run.every), static_cast<double>(step)};
    }
  }
  if (file.next()) file.fail("is more than the run has");
  return links;
}

std::vector<double> tears_of(const fs::path& path, int refine, const DeckRun& run, const std::string& scene_hash) {
  Series series(path, refine, scene_hash);
  std::vector<double> tears;
  for (const auto& row : series.rows(2, refine, run.steps + 1)) {
    const auto before = static_cast<double>(tears.size());
    if (row[1] < before || row[1] > static_cast<double>(run.bonds.size()))
      series.file().fail_whole("has " + shortest(row[1]) + " torn links at step " + shortest(row[0]));
    while (static_cast<double>(tears.size()) < row[1]) tears.push_back(row[0] / refine);
  }
  return tears;
}

EngineOutput read(const fs::path& directory, int refine, const DeckRun& run, const std::string& scene_hash) {
  EngineOutput out;
  out.refine = refine;
  out.end = bodies_at_end(directory / ends_file(refine), refine, run);
  if (run.parts > 0)
    out.forces = Series(directory / forces_file(refine), refine, scene_hash)
                     .rows(1 + 2 * run.parts, run.every * refine, run.rows());
  if (run.tears) out.tears = tears_of(directory / tears_file(refine), refine, run, scene_hash);
  if (!run.bonds.empty()) out.links = links_of(directory / links_file(refine), refine, run);
  return out;
}

}  // namespace

std::vector<EngineOutput> engine_outputs(const fs::path& directory, const DeckRun& run, const std::string& scene_hash) {
  std::set<int> refines;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (const int refine = refine_of(entry.path().filename()); refine > 0) refines.insert(refine);
  }
  if (refines.empty())
    throw FileError(directory.string() + ": the engine has left no end.1.txt; run it there: lmp -in in.lammps");
  std::vector<EngineOutput> all;
  for (const int refine : refines) all.push_back(read(directory, refine, run, scene_hash));
  return all;
}

}  // namespace furrow
