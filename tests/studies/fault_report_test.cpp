// What the fault study writes down: each verdict names what made it, those of an earlier report too.
#include <gtest/gtest.h>

#include "verification/fault_study/verdicts.h"

namespace furrow::verification {
namespace {

using Json = nlohmann::ordered_json;

Maker by(const std::string& commit, const std::string& when) {
  Maker maker = this_maker({{"src/run/run.cpp", commit}});
  maker.commit = commit, maker.when = when;
  return maker;
}

Tried tried_by(const std::string& commit, std::vector<Json> results) {
  return {by(commit, "2026-01-31T12:00:00Z"), {"one", "two"}, {}, {}, std::move(results)};
}

Json verdict(const std::string& name) {
  return {{"name", name}, {"file", "src/kernel/a.cpp"}, {"failed", Json::array({"A.B"})}};
}

std::string commit_of(const Json& report, int place, const char* key = "maker") {
  return report["makers"][report["results"][place][key].get<std::size_t>()]["commit"];
}

TEST(FaultReport, KeepsWhoTriedEach) {
  const Json first = report_of(tried_by("aaaaaaa", {verdict("one"), verdict("two")}), Json::object());
  EXPECT_EQ(first["makers"].size(), 1u);
  const Json second = report_of(tried_by("bbbbbbb", {verdict("two")}), first);
  EXPECT_EQ(commit_of(second, 0), "aaaaaaa");
  EXPECT_EQ(commit_of(second, 1), "bbbbbbb");
  EXPECT_EQ(second["makers"][second["results"][0]["maker"].get<std::size_t>()], first["makers"][0]);
  const Json third = report_of(tried_by("ccccccc", {verdict("one"), verdict("two")}), second);
  EXPECT_EQ(third["makers"].size(), 1u) << "who made nothing of what is there is not named";
}

TEST(FaultReport, OfAnEarlierFormKeepsItsCommitAndSaysNoSources) {
  Json earlier{{"commit", "ddddddd"}, {"groups", Json::object()}, {"results", Json::array({verdict("one")})}};
  earlier["results"][0]["by_property"] = Json::array({"C.D"});
  earlier["results"][0]["property_commit"] = "eeeeeee";
  const Json report = report_of(tried_by("aaaaaaa", {verdict("two")}), earlier);
  EXPECT_EQ(commit_of(report, 0), "ddddddd");
  EXPECT_EQ(commit_of(report, 0, "property_maker"), "eeeeeee");
  EXPECT_FALSE(report["results"][0].contains("commit") || report["results"][0].contains("property_commit"));
  EXPECT_TRUE(maker_in(report, report["results"][0]).sources.empty());
  EXPECT_FALSE(maker_in(report, report["results"][1]).sources.empty());
}

TEST(FaultReport, OfThePropertyNamesWhoTriedItBesideThePages) {
  const Json first = report_of(tried_by("aaaaaaa", {verdict("one"), verdict("two")}), Json::object());
  Json noticed = verdict("two");
  noticed["by_property"] = Json::array({"C.D"});
  const Json second = with_property(tried_by("bbbbbbb", {noticed}), first);
  EXPECT_EQ(commit_of(second, 1), "aaaaaaa");
  EXPECT_EQ(commit_of(second, 1, "property_maker"), "bbbbbbb");
  EXPECT_FALSE(second["results"][0].contains("property_maker"));
}

}  // namespace
}  // namespace furrow::verification
