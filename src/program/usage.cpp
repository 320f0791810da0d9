#include "program/usage.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "scene/utf8.h"
#include "scene/wording.h"

namespace furrow {
namespace {

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

// "-x", but not "-1".
bool is_flag(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && word.find_first_of("0123456789.") != 1;
}

bool known(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string shown(const std::string& word) { return in_quotes(visible(word)); }

const CLI::App* command_of(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? nullptr : parsed.front();
}

std::string whole(const CLI::App& app) {
  const CLI::App* command = command_of(app);
  return command ? "furrow " + command->get_name() : "furrow";
}

std::string unknown_option(const std::string& name, const std::string& of, const CLI::App& command) {
  const std::vector<std::string> names = names_of_options(command);
  if (known(name, names)) return {};
  return of + " has no option " + shown(name) + did_you_mean(name, names) + "; see " + of + " --help";
}

template <class Number>
bool reads(const std::string& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

void show_examples(CLI::App* command, const std::vector<std::string>& lines) {
  std::string text = "Examples, in the source tree:\n";
  for (const std::string& line : lines) text += "  " + line + "\n";
  command->footer(
      text +
      "\nExit codes: 0 good, 1 a check failed, 2 usage or scene, 3 diverged or invalid, 4 input or output (a "
      "scene that\ncannot be read, too), 130 interrupted.");
}

std::string unreadable(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (!is_utf8(argv[i]))
      return shown(argv[i]) + " is not UTF-8, as the names of files that a result tells of must be; rename the file";
  }
  return {};
}

std::string misspelt(const CLI::App& app, int argc, char** argv) {
  const CLI::App* command = nullptr;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--") break;
    if (word.starts_with("--") || is_flag(word)) {
      const std::string of = command ? "furrow " + command->get_name() : "furrow";
      if (word.starts_with("--") && word.find('=') == word.size() - 1)  // CLI11 would take the next word
        return word.substr(0, word.size() - 1) + ": must not be empty";
      std::string fault = unknown_option(word.substr(0, word.find('=')), of, command ? *command : app);
      if (!fault.empty()) return fault;
    } else if (!command && !word.starts_with('-')) {
      const std::vector<std::string> names = names_of_commands(app);
      if (!known(word, names))
        return "there is no command " + shown(word) + nearest_or_all(word, names) + "; see furrow --help";
      command = app.get_subcommand(word);
    }
  }
  return {};
}

std::string without_value(const CLI::App& app) {
  const CLI::App* command = command_of(app);
  if (!command) return {};
  for (const CLI::Option* option : command->get_options()) {
    const auto& given = option->results();
    if (std::find(given.begin(), given.end(), "") != given.end()) return option->get_name() + ": must not be empty";
  }
  return {};
}

std::string usage_fault(const CLI::App& app, const CLI::ParseError& error) {
  const std::string help = "; see " + whole(app) + " --help";
  std::string what = error.what();
  const std::string subject = what.substr(0, what.find(':'));
  if (error.get_name() == "RequiredError") {
    if (!command_of(app)) return "a command is missing" + help;
    return subject.substr(0, subject.find(' ')) + " is missing" + help;
  }
  if (error.get_name() == "ArgumentMismatch") return subject + ": takes one value" + help;
  if (dynamic_cast<const CLI::ExtrasError*>(&error)) {
    const CLI::App* command = command_of(app);
    const auto extra = command ? command->remaining() : app.remaining(true);
    return (extra.empty() ? std::string("a word") : shown(extra.front())) + " is one too many" + help;
  }
  return what;
}

CLI::Validator whole_number(long low, long high) {
  return CLI::Validator(
      [=](std::string& text) {
        long number = 0;
        if (reads(text, number) && number >= low && number <= high) return std::string{};
        return "must be an integer from " + std::to_string(low) + " to " + std::to_string(high) + ", not " +
               shown(text);
      },
      "");
}

CLI::Validator moment() {
  return CLI::Validator(
      [](std::string& text) {
        double number = 0;
        if (reads(text, number) && number >= 0 && std::isfinite(number)) return std::string{};
        return "must be a time of at least 0 [s], not " + shown(text);
      },
      "");
}

}  // namespace furrow
