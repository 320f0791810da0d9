#include "verification/check.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace furrow::verification {
namespace {

// One file a test: ctest runs every test in a process of its own.
class Records : public testing::EmptyTestEventListener {
 public:
  static Records& instance() {
    static auto* records = [] {
      auto* made = new Records;  // owned by GoogleTest
      testing::UnitTest::GetInstance()->listeners().Append(made);
      return made;
    }();
    return *records;
  }

  void OnTestStart(const testing::TestInfo& test) override { begin(test); }

  void OnTestEnd(const testing::TestInfo& /*test*/) override {
    if (count_ == 0) ADD_FAILURE() << "a verification test must check something by expect()";
    file_.close();
  }

  void begin(const testing::TestInfo& test) {
    test_ = std::string(test.test_suite_name()) + "." + test.name();
    requirement_.clear();
    count_ = 0;
    const char* elsewhere = std::getenv("FURROW_RECORDS_IN");  // the fault study's
    const std::filesystem::path directory = elsewhere != nullptr ? elsewhere : FURROW_RECORDS;
    std::filesystem::create_directories(directory);
    file_.open(directory / (test_ + ".jsonl"), std::ios::trunc);
  }

  void write(nlohmann::ordered_json record) {
    if (requirement_.empty()) ADD_FAILURE() << "state the requirement() before the first check";
    record["test"] = test_;
    record["requirement"] = requirement_;
    file_ << record.dump() << std::endl;  // flushed: a crash keeps what was checked before it
    ++count_;
  }

  std::string requirement_;

 private:
  std::string test_;
  std::ofstream file_;
  int count_ = 0;
};

// Listeners must be known before the first test starts.
[[maybe_unused]] const bool registered = (Records::instance(), true);

// JSON has no NaN and no infinity; as text they survive.
nlohmann::ordered_json json_number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

}  // namespace

void requirement(const std::string& id) { Records::instance().requirement_ = id; }

void expect(const std::string& name, double got, double want, const Tolerance& tolerance, const char* file, int line) {
  const bool is_relative = tolerance.kind == Tolerance::Kind::relative;
  const double error = got == want ? 0 : std::fabs(got - want) / (is_relative ? std::fabs(want) : 1);
  // What is not finite is nothing to compare with, and no tolerance that lets everything pass is one.
  const bool good = std::isfinite(want) && std::isfinite(tolerance.value) && error <= tolerance.value;
  nlohmann::ordered_json record;
  record["name"] = name;
  record["want"] = json_number(want);
  record["got"] = json_number(got);
  record["error"] = json_number(error);
  record["kind"] = is_relative ? "relative" : "absolute";
  record["tolerance"] = json_number(tolerance.value);
  record["of_limit"] = json_number(error == 0 ? 0 : error / tolerance.value);
  record["reason"] = tolerance.reason;
  record["file"] = std::filesystem::path(file).filename().string();
  record["line"] = line;
  record["good"] = good;
  Records::instance().write(record);
  if (tolerance.reason.empty()) ADD_FAILURE_AT(file, line) << name << ": a tolerance needs a reason";
  if (!good) {
    ADD_FAILURE_AT(file, line) << name << ": got " << record["got"] << ", expected " << record["want"] << "; "
                               << (is_relative ? "relative" : "absolute") << " error " << error << " is beyond "
                               << tolerance.value << " (" << tolerance.reason << ")";
  }
}

void expect_true(const std::string& name, bool holds, const std::string& reason, const char* file, int line) {
  expect(name, holds ? 1 : 0, 1, exact(reason), file, line);
}

}  // namespace furrow::verification
