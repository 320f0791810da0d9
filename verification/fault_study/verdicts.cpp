#include "verification/fault_study/verdicts.h"

#include <set>

#include "report/measured_process.h"

namespace furrow::verification {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr const char* by_pages = "maker";
constexpr const char* by_property = "property_maker";

// As they are now, in a list that may be another one than where they were.
class Makers {
 public:
  // Of a verdict of a file, of an earlier form too.
  void take_over(ordered_json& verdict, const ordered_json& from) {
    verdict[by_pages] = place_in(all_, maker_in(from, verdict));
    if (verdict.contains("by_property")) verdict[by_property] = place_in(all_, maker_of_property(from, verdict));
    for (const char* earlier : {"commit", "property_commit"}) verdict.erase(earlier);
  }
  // Of a verdict of today.
  void name(ordered_json& verdict, const Maker& maker) {
    verdict[by_pages] = place(maker);
    if (verdict.contains("by_property")) verdict[by_property] = place(maker);
  }
  std::size_t place(const Maker& maker) { return place_in(all_, maker); }
  ordered_json json() const {
    ordered_json list = ordered_json::array();
    for (const Maker& maker : all_) list.push_back(json_of(maker));
    return list;
  }

 private:
  static Maker maker_of_property(const ordered_json& from, const ordered_json& verdict) {
    if (from.contains("makers")) return maker_in(from, verdict, by_property);
    return {.commit = verdict.value("property_commit", maker_in(from, verdict).commit),
            .when = {},
            .compiler = {},
            .flags = {},
            .machine = {},
            .sources = {}};
  }

  std::vector<Maker> all_;
};

}  // namespace

Maker maker_of_verdicts(const fs::path& tree) {
  Maker maker = this_maker(that_decide("faults"));
  const MeasuredEnd git = run_measured({.words = {"git", "-C", tree, "describe", "--always", "--dirty"}});
  const std::string commit = git.output.substr(0, git.output.find('\n'));
  maker.commit = git.status != 0 || commit.empty() ? "unknown" : commit;
  return maker;
}

ordered_json report_of(const Tried& tried, const ordered_json& earlier) {
  std::map<std::string, ordered_json> kept;
  for (const ordered_json& result : earlier.value("results", ordered_json::array())) {
    kept[result.at("name")] = result;
  }
  std::map<std::string, std::set<std::string>> groups;
  std::set<std::string> silent;
  for (const Page& page : tried.pages) {
    silent.insert(page.tests.begin(), page.tests.end());
    if (page.turn != Turn::always) groups[turn_names[page.turn]].insert(page.tests.begin(), page.tests.end());
  }
  std::set<std::string> now;
  for (const ordered_json& result : tried.results) {
    if (result.is_null()) continue;  // the sound tree was not green
    now.insert(result.at("name"));
    kept[result.at("name")] = result;
  }
  Makers makers;
  ordered_json all = ordered_json::array();
  for (const std::string& name : tried.names) {
    if (kept.count(name) == 0) continue;
    ordered_json& result = all.emplace_back(kept[name]);
    if (now.contains(name))
      makers.name(result, tried.maker);
    else
      makers.take_over(result, earlier);
    for (const char* key : {"failed", "by"}) {
      for (const auto& test : result.value(key, ordered_json::array())) silent.erase(test.get<std::string>());
    }
  }
  ordered_json noticed_nothing = ordered_json::object();
  for (const std::string& test : silent) {
    const auto why = tried.silent.find(test);
    noticed_nothing[test] = why == tried.silent.end() ? "" : why->second;
  }
  return {{"makers", makers.json()}, {"groups", groups}, {"results", all}, {"noticed_nothing", noticed_nothing}};
}

ordered_json with_property(const Tried& tried, ordered_json earlier) {
  Makers makers;
  for (ordered_json& verdict : earlier.at("results")) makers.take_over(verdict, earlier);
  for (const ordered_json& result : tried.results) {
    if (result.is_null() || !result.contains("by_property")) continue;
    for (ordered_json& other : earlier.at("results")) {
      if (other.at("name") != result.at("name")) continue;
      other["file"] = result.at("file");
      other["by_property"] = result.at("by_property");
      other[by_property] = makers.place(tried.maker);
    }
  }
  earlier.erase("commit");
  earlier["makers"] = makers.json();
  return earlier;
}

}  // namespace furrow::verification
