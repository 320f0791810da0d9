// What is wrong with a command line, in one line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace furrow {

// Ends the help of a command with lines that can be copied, to be run in the source tree, and with the exit codes.
void show_examples(CLI::App* command, const std::vector<std::string>& lines);

// The first word that is not UTF-8; empty if all are. Names of files stand in JSON, which is nothing else.
std::string unreadable(int argc, char** argv);

// The first word that is no command, or the first option that its command does not have, and the nearest that there is;
// empty if all are known.
std::string misspelt(const CLI::App& app, int argc, char** argv);

// The first option that was given an empty text, which a variable of a shell that is not set leaves; empty if none was.
std::string without_value(const CLI::App& app);

// What CLI11 found wrong.
std::string usage_fault(const CLI::App& app, const CLI::ParseError& error);

// Accepts whole numbers from `low` to `high`.
CLI::Validator whole_number(long low, long high);

// Accepts numbers (s) that are finite and not negative.
CLI::Validator moment();

}  // namespace furrow
