#include "verification/fault_study/verdicts.h"

#include <set>

#include "report/measured_process.h"

namespace furrow::verification {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string commit_of(const fs::path& tree) {
  const MeasuredEnd git = run_measured({.words = {"git", "-C", tree, "describe", "--always", "--dirty"}});
  const std::string commit = git.output.substr(0, git.output.find('\n'));
  return git.status != 0 || commit.empty() ? "unknown" : commit;
}

ordered_json report_of(const Tried& tried, const ordered_json& earlier) {
  std::map<std::string, ordered_json> kept;
  for (ordered_json result : earlier.value("results", ordered_json::array())) {
    if (!result.contains("commit")) result["commit"] = earlier.at("commit");
    kept[result.at("name")] = result;
  }
  std::map<std::string, std::set<std::string>> groups;
  std::set<std::string> silent;
  for (const Page& page : tried.pages) {
    silent.insert(page.tests.begin(), page.tests.end());
    if (page.turn != Turn::always) groups[turn_names[page.turn]].insert(page.tests.begin(), page.tests.end());
  }
  for (ordered_json result : tried.results) {
    if (result.is_null()) continue;  // the sound tree was not green
    result["commit"] = tried.commit;
    kept[result.at("name")] = result;
  }
  ordered_json all = ordered_json::array();
  for (const std::string& name : tried.names) {
    if (kept.count(name) == 0) continue;
    const ordered_json& result = all.emplace_back(kept[name]);
    for (const char* key : {"failed", "by"}) {
      for (const auto& test : result.value(key, ordered_json::array())) silent.erase(test.get<std::string>());
    }
  }
  ordered_json noticed_nothing = ordered_json::object();
  for (const std::string& test : silent) {
    const auto why = tried.silent.find(test);
    noticed_nothing[test] = why == tried.silent.end() ? "" : why->second;
  }
  return {{"commit", tried.commit}, {"groups", groups}, {"results", all}, {"noticed_nothing", noticed_nothing}};
}

ordered_json with_property(const Tried& tried, ordered_json earlier) {
  for (const ordered_json& result : tried.results) {
    if (result.is_null() || !result.contains("by_property")) continue;
    for (ordered_json& other : earlier.at("results")) {
      if (other.at("name") != result.at("name")) continue;
      other["file"] = result.at("file");
      other["by_property"] = result.at("by_property");
      other["property_commit"] = tried.commit;
    }
  }
  return earlier;
}

}  // namespace furrow::verification
