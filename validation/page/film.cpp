#include "validation/page/film.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "validation/page/film_frames.h"
#include "validation/page/gnuplot.h"
#include "validation/page/packed.h"
#include "validation/page/template.h"

namespace furrow::validation {
namespace {

using Json = nlohmann::ordered_json;

constexpr double most_bins = 900;  // of the force curve: more than the pixels that show it

template <class Integer>
void append(std::string& bytes, const std::vector<Integer>& values) {
  for (const Integer value : values) {
    const auto bits = static_cast<std::uint32_t>(value);
    for (std::size_t k = 0; k < sizeof(Integer); ++k) bytes += static_cast<char>(bits >> (8 * k) & 255U);
  }
}

// Each frame but the first as the difference to the one before, which wraps around.
template <class Integer>
std::vector<Integer> differences(const std::vector<Integer>& values, std::size_t width) {
  std::vector<Integer> result = values;
  for (std::size_t k = values.size(); k-- > width;)
    result[k] =
        static_cast<Integer>(static_cast<std::uint32_t>(values[k]) - static_cast<std::uint32_t>(values[k - width]));
  return result;
}

// Least and largest force in equal stretches of the way.
struct Bins {
  std::vector<double> low, high;  // N
  double step = 0, peak = 0;      // mm, N
};

Bins bins_of(const std::vector<double>& force, const std::vector<double>& at, double end) {
  Bins bins;
  const auto count = static_cast<std::size_t>(std::min(most_bins, static_cast<double>(force.size())));
  if (count == 0 || !(end > 0)) return bins;
  bins.step = end / static_cast<double>(count);
  bins.low.assign(count, NAN), bins.high.assign(count, NAN);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto bin = std::min(count - 1, static_cast<std::size_t>(std::max(0.0, at[k] / bins.step)));
    bins.low[bin] = std::fmin(bins.low[bin], force[k]), bins.high[bin] = std::fmax(bins.high[bin], force[k]);
    bins.peak = std::fmax(bins.peak, force[k]);
  }
  for (std::size_t k = 0; k < count; ++k) {  // a stretch without a row goes on with the last one
    if (std::isnan(bins.low[k])) bins.low[k] = bins.high[k] = k > 0 ? bins.high[k - 1] : 0;
  }
  return bins;
}

std::vector<std::int16_t> in_units(const std::vector<double>& values, double unit) {
  std::vector<std::int16_t> result;
  for (const double v : values)
    result.push_back(static_cast<std::int16_t>(std::lround(std::clamp(v / unit, -32767.0, 32767.0))));
  return result;
}

double overlap_top(const RunRecord& run) {
  const Fact* fact = run.fact("greatest_relative_overlap");
  const double worst = fact && !fact->texts.empty() ? std::strtod(fact->texts[0].c_str(), nullptr) : 0;
  return worst > 0 ? worst : 1;
}

}  // namespace

std::string film_of(const RunRecord& run, const std::filesystem::path& directory, const std::vector<double>& stills) {
  if (run.frames.empty())
    throw std::runtime_error(directory.string() + ": the run has no pictures; run it again with --frames 150");
  const FilmFrames frames(run, directory);
  const Bins bins = bins_of(frames.force(), frames.force_at(), frames.at().back());
  const double unit = bins.peak > 0 ? bins.peak / 32000 : 1;
  Json walls = Json::array(), links = Json::array(), plates = Json::array();
  for (const Wall& w : run.scene.wall) walls.push_back({w.point.x, w.point.y, w.normal.x, w.normal.y});
  for (int k = 0; k < run.lattices.link.count(); ++k)
    links.push_back({run.lattices.link.a[k], run.lattices.link.b[k], static_cast<int>(run.lattices.link.kind[k])});
  for (const auto& [width, height] : frames.plates()) plates.push_back({width, height});
  Json torn = Json::array();
  for (const auto& [at, link] : frames.torn()) torn.push_back({at, link});
  const Json header{{"title", run.scene.title},
                    {"axis", frames.by_way() ? "mm" : "ms"},
                    {"tool", frames.driven() ? "driven nodes" : "plate"},
                    {"mm", frames.at()},
                    {"box", {frames.box().x0, frames.box().y0, frames.box().x1, frames.box().y1}},
                    {"unit", frames.box().unit()},
                    {"radius", frames.radii()},
                    {"nodes", run.lattices.node.count()},
                    {"links", links},
                    {"walls", walls},
                    {"plates", plates},
                    {"torn", torn},
                    {"stills", stills},
                    {"tops",
                     {{"stress", frames.stress_top()},
                      {"speed", frames.speed_top()},
                      {"overlap", overlap_top(run)},
                      {"link", frames.link_top()}}},
                    {"curve", {{"count", bins.low.size()}, {"step", bins.step}, {"unit", unit}, {"peak", bins.peak}}}};
  const std::string words = header.dump();
  std::string bytes;
  append(bytes, std::vector<std::uint32_t>{static_cast<std::uint32_t>(words.size())});
  bytes += words;
  const std::size_t discs = frames.radii().size(), nodes = run.lattices.node.row.size();
  append(bytes, differences(frames.disc_places(), 2 * discs));
  append(bytes, differences(frames.stresses(), discs));
  append(bytes, differences(frames.speeds(), discs));
  append(bytes, differences(frames.node_places(), 2 * nodes));
  append(bytes, differences(frames.link_forces(), links.size()));
  append(bytes, differences(frames.plate_places(), 2 * plates.size()));
  append(bytes, in_units(bins.low, unit));
  append(bytes, in_units(bins.high, unit));
  return bytes;
}

std::string player_element(const std::vector<Film>& films) {
  if (films.empty()) return {};
  Json choices = Json::array();
  for (const Film& film : films) choices.push_back({{"id", film.id}, {"label", film.label}});
  return "<div class=\"player\" data-films=\"" + escaped(choices.dump()) + "\"></div>\n";
}

std::string film_elements(const std::vector<Film>& films) {
  std::string html;
  for (const Film& film : films) html += packed_element(film.id, film.data);
  return html;
}

std::string view_page(const RunRecord& run, const std::filesystem::path& directory) {
  constexpr std::size_t few = 12;  // pictures: each is marked
  const FilmFrames frames(run, directory);
  const std::vector<Film> films{
      {"film", run.scene.title,
       film_of(run, directory, frames.at().size() <= few ? frames.at() : std::vector<double>{})}};
  const auto said = [&](const char* key) {
    const Fact* fact = run.fact(key);
    return fact && !fact->texts.empty() ? escaped(fact->texts[0]) : std::string("unknown");
  };
  return filled(page_file("view.html"), {{"title", escaped(run.scene.title)},
                                         {"made", "Run by furrow, commit " + said("commit") + ", " + said("method") +
                                                      " with steps of " + said("step") + " s; " + said("ended") + "; " +
                                                      std::to_string(run.frames.size()) + " pictures."},
                                         {"style", page_file("player.css")},
                                         {"player", player_element(films)},
                                         {"films", film_elements(films)},
                                         {"script", page_file("player.js")}});
}

}  // namespace furrow::validation
