// The list of faults that the fault study puts into the source: what is misspelt in it is an error, not left out.
#include <gtest/gtest.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <fstream>

#include "verification/fault_study/faults.h"

namespace furrow::verification {
namespace {

namespace fs = std::filesystem;

const std::string others =
    "[methods]\npages = [\"a\"]\nfiles = [\"src/\"]\n[costly]\ntests = [\"A.B\"]\n[silent]\n\"C.D\" = \"why\"\n";
const std::string fault = "[[fault]]\nname = \"one\"\nsays = \"it\"\nfile = \"src/f.cpp\"\nold = \"a\"\nnew = \"\"\n";
const std::string of_header = "[[fault]]\nname = \"one\"\nsays = \"it\"\nfile = \"src/f.h\"\nold = \"a\"\nnew = \"\"\n";
const std::string constant =
    "[[constant]]\nname = \"two\"\nsays = \"it\"\nfile = \"f\"\nold = \"1\"\nnew = \"1 + CHANGE\"\n";

Faults read(const std::string& text) {
  const fs::path file = fs::temp_directory_path() / ("furrow_faults_" + std::to_string(getpid()) + ".toml");
  std::ofstream(file) << text;
  try {
    Faults faults = faults_in(file);
    fs::remove(file);
    return faults;
  } catch (...) {
    fs::remove(file);
    throw;
  }
}

TEST(FaultFile, ASoundOneIsReadWhole) {
  const Faults faults = read(others + fault + "quick = \"page\"\nrebuild = true\non_all = true\n" + constant);
  ASSERT_EQ(faults.all.size(), 2U);
  EXPECT_TRUE(faults.all[0].rebuild && faults.all[0].on_all && !faults.all[0].constant);
  EXPECT_EQ(faults.all[0].quick, "page");
  EXPECT_TRUE(faults.all[1].constant && !faults.all[1].rebuild && !faults.all[1].on_all);
  EXPECT_EQ(faults.methods_pages, std::set<std::string>{"a"});
  EXPECT_EQ(faults.costly_tests, std::set<std::string>{"A.B"});
  EXPECT_EQ(faults.silent.at("C.D"), "why");
}

TEST(FaultFile, WhatIsMisspeltOrMissingIsAnError) {
  for (const auto& [text, why] :
       {std::pair{others + fault + "on_al = true\n", "fault 1: on_al is no key of a fault"},
        {others + fault + "on_all = 1\n", "fault 1: on_all must be true or false"},
        {others + fault + "quick = 1\n", "fault 1: quick must be a text"},
        {others + of_header + "quick = \"page\"\n", "one is in no source of src"},
        {others + "[[fault]]\nname = \"one\"\n", "fault 1 has no says"},
        {others + "fault = 3\n", "silent.fault must be a text"},
        {"fault = 3\n" + others, "fault must be a list of tables"},
        {others + "[[fualt]]\n", "nothing is called fualt"},
        {others + fault + fault, "two faults are called one"},
        {others + constant.substr(0, constant.find("CHANGE")) + "\"\n", "two does not say where its CHANGE goes"},
        {others.substr(0, others.find("[costly]")) + fault, "there is no [costly]"},
        {others.substr(0, others.find("files")) + "[costly]\ntests = []\n[silent]\n",
         "methods.files must be a list"}}) {
    try {
      read(text);
      ADD_FAILURE() << text;
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find(std::string("faults.toml: ") + why), std::string::npos)
          << error.what() << "\n"
          << text;
    }
  }
}

TEST(FaultFile, TheOneInTheTreeIsSound) {
  EXPECT_GT(faults_in(FURROW_SOURCE_DIR "/verification/faults.toml").all.size(), 50U);
}

}  // namespace
}  // namespace furrow::verification
