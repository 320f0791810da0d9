// A text file that an engine has left, line by line. What is wrong with it is said with the line, and what to do.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

class EngineFile {
 public:
  // Throws FileError unless the file is there. `refine`: the engine's number of steps to one of the scene.
  EngineFile(const std::filesystem::path& file, int refine);

  bool next();       // goes to the next line; false: there is none
  void need_next();  // throws FileError if there is none
  const std::string& line() const { return line_; }

  // Throws FileError: with the line, or of the whole file.
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_whole(const std::string& what) const;

  // The line is nothing but so many finite numbers.
  std::vector<double> row(std::size_t columns) const;

  // The next line begins so; it is this one number; it is a whole number.
  void expect(std::string_view beginning);
  void expect_number(long value, const std::string& what);
  long count();

 private:
  const std::filesystem::path file_;
  const int refine_;
  std::ifstream stream_;
  std::string line_;
  long number_ = 0;
};

}  // namespace furrow
