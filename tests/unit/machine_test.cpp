#include "output/machine.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace furrow {
namespace {

std::string name_in(const std::string& text) {
  std::istringstream info(text);
  return processor_name(info);
}

TEST(ProcessorName, TellsFamilyAndModelOfTheFirstProcessor) {
  EXPECT_EQ(name_in("processor\t: 0\ncpu family\t: 25\nmodel\t\t: 17\nmodel name\t: AMD EPYC\npower management:\n\n"
                    "processor\t: 1\ncpu family\t: 6\nmodel\t\t: 85\nmodel name\t: another\n"),
            "AMD EPYC (family 25, model 17)");
}

TEST(ProcessorName, IsAsMuchAsTheSystemTells) {
  EXPECT_EQ(name_in("processor : 0\nmodel name : ARMv8\n"), "ARMv8");
  EXPECT_EQ(name_in("processor : 0\nCPU part : 0xd0c\n"), "unknown");
  EXPECT_EQ(name_in(""), "unknown");
}

}  // namespace
}  // namespace furrow
