// A request that does not follow the protocol is refused by the key that is wrong.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "system/ode.h"
#include "verification/engines/furrow_engine.h"

namespace furrow::test {
namespace {

using verification::Json;

std::string fault_of(const std::string& name, const std::function<void(Json&)>& change) {
  Json request = verification::request_of(verification::case_named(name), 100);
  change(request["case"]);
  try {
    verification::furrow_answer(request, "verlet");
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "none";
}

void expect_fault(const std::string& name, const std::function<void(Json&)>& change, const std::string& words) {
  const std::string fault = fault_of(name, change);
  EXPECT_NE(fault.find("the request does not follow the protocol: case." + words), std::string::npos) << fault;
}

TEST(Requests, IntegersThatDoNotFitAreRefusedByTheirKey) {
  for (const Json& wrong : {Json(3000000000), Json(1e308), Json(-1), Json(1.5), Json("two"), Json()}) {
    expect_fault(
        "cantilever", [&](Json& c) { c["lattice"][0]["columns"] = wrong; },
        "lattice[0].columns must be an integer from 1 to 100000, not ");
    expect_fault(
        "cantilever", [&](Json& c) { c["lattice"][0]["node"][0]["column"] = wrong; },
        "lattice[0].node[0].column must be an integer from 0 to 5, not ");
  }
  expect_fault(
      "cantilever", [](Json& c) { c["lattice"][0]["rows"] = 4; }, "lattice has 24 nodes, but case.body has 18");
}

TEST(Requests, NamesOfNothingAreRefusedByTheirKey) {
  expect_fault(
      "hertz_wall",
      [](Json& c) {
        c["observe"][0]["of"] = {"nobody", "nowhere"};
      },
      "observe[0].of[0] names \"nobody\", which is none of ");
  expect_fault(
      "hertz_wall", [](Json& c) { c["observe"][0]["what"] = "colour"; }, "observe[0].what names \"colour\"");
  expect_fault(
      "hertz_wall", [](Json& c) { c["body"][0]["material"] = "cheese"; }, "body[0].material names \"cheese\"");
  expect_fault(
      "spring", [](Json& c) { c["spring"][0]["a"] = "nobody"; }, "spring[0].a names \"nobody\"");
}

TEST(Requests, WrongTypesAndMissingKeysAreSaidInWordsOfTheProtocol) {
  expect_fault(
      "hertz_wall", [](Json& c) { c["body"][0]["position"] = "left"; },
      "body[0].position must be two numbers, not \"left\"");
  expect_fault(
      "hertz_wall", [](Json& c) { c["body"][0].erase("mass"); }, "body[0].mass is missing");
  expect_fault(
      "hertz_wall", [](Json& c) { c["contact"] = 3; }, "contact must be an object, not 3");
  expect_fault(
      "hertz_wall", [](Json& c) { c["needs"] = {1}; }, "needs[0] must be a text, not 1");
  expect_fault(
      "hertz_wall", [](Json& c) { c.erase("wall"); }, "wall is missing");
  for (const Json& wrong : {Json::array({1, 2, 3}), Json("x"), Json()})
    expect_fault(
        "spring", [&](Json& c) { c["spring"][0]["stiffness"] = wrong; }, "spring[0].stiffness must be a number, not ");
}

TEST(Requests, OfEveryCaseFollowTheProtocol) {
  for (const std::string& name : verification::case_names())
    EXPECT_NO_THROW(verification::lacking(verification::request_of(verification::case_named(name), 100)["case"]))
        << name;
}

// A case says some things twice, for engines with lattices and for others: what a scene cannot say is not passed over.
TEST(Requests, WhatASceneCannotSayIsNotPassedOver) {
  const auto lacking = [](const std::string& name, const std::function<void(Json&)>& change) {
    Json c = verification::request_of(verification::case_named(name), 100)["case"];
    change(c);
    return verification::lacking(c);
  };
  EXPECT_EQ(lacking("hertz_wall", [](Json& c) { c["body"][0]["load"] = {0, 3000}; }), "a load on a disc");
  EXPECT_EQ(lacking("hertz_wall", [](Json& c) { c["body"][0]["fixed"] = true; }), "a disc that is held");
  const std::string other = " other than its lattices and materials say";
  EXPECT_EQ(lacking("hertz_wall", [](Json& c) { c["pair"][0]["modulus"] = 2 * c["pair"][0]["modulus"].get<double>(); }),
            "pair[0].modulus" + other);
  EXPECT_EQ(lacking("cantilever", [](Json& c) { c["spring"][3]["stiffness"] = 1.0; }), "spring[3].stiffness" + other);
  EXPECT_EQ(lacking("cantilever", [](Json& c) { c["spring"][3]["strength"] = 1.0; }), "spring[3].strength" + other);
  EXPECT_EQ(lacking("cantilever", [](Json& c) { c["body"][4]["load"] = {0, 1}; }), "body[4].load[1]" + other);
  EXPECT_EQ(lacking("cantilever", [](Json& c) { c["spring"].erase(0); }), "spring" + other);
  EXPECT_EQ(lacking("cantilever", [](Json&) {}), "");
}

TEST(Requests, ARunThatDivergesIsADivergence) {
  Json request = verification::request_of(verification::case_named("spring"), 100);
  request["step"] = 1e6 * request["step"].get<double>();
  EXPECT_THROW(verification::furrow_answer(request, "verlet"), Divergence);
}

}  // namespace
}  // namespace furrow::test
