// A file from which a run goes on by the same bits, and the two visitors that fill and read it.
//
//   8 bytes  magic        4  version of the format        8  length of the whole file
//   then each part: 4  length of its name, name, 8  length of its bytes, bytes
//   8 bytes  64-bit FNV-1a of all before
//
// Integers and doubles are little-endian. The bytes of a part are what a HistoryVisitor saw: each item a letter for its
// type, its name and its value, so that a program of another version finds a name that it does not know, not numbers
// of another meaning.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "output/files.h"
#include "system/history.h"

namespace furrow {

class HistoryWriter final : public HistoryVisitor {
 public:
  const std::string& bytes() const { return bytes_; }
  void number(std::string_view name, double& value) override;
  void integer(std::string_view name, std::int64_t& value) override;
  void text(std::string_view name, std::string& value) override;
  void integers(std::string_view name, std::vector<std::int64_t>& values) override;
  void state(std::string_view name, State& values) override;

 private:
  void begin(char type, std::string_view name);
  std::string bytes_;
};

// Throws FileError where the bytes hold something else than what is visited.
class HistoryReader final : public HistoryVisitor {
 public:
  explicit HistoryReader(std::string_view bytes) : bytes_(bytes) {}
  void number(std::string_view name, double& value) override;
  void integer(std::string_view name, std::int64_t& value) override;
  void text(std::string_view name, std::string& value) override;
  void integers(std::string_view name, std::vector<std::int64_t>& values) override;
  void state(std::string_view name, State& values) override;
  bool at_end() const { return bytes_.empty(); }

 private:
  void begin(char type, std::string_view name);
  std::size_t count(std::size_t bytes_each);
  std::string_view take(std::size_t count);
  std::uint64_t word();
  std::string_view bytes_;
};

// What is visited under a name of its own.
struct CheckpointPart {
  std::string name;
  std::function<void(HistoryVisitor&)> visit;
};

// Replaces the file only when all of the new one is written, under its own name. Throws FileError.
void write_checkpoint(const std::filesystem::path& file, const std::vector<CheckpointPart>& parts);

class Checkpoint {
 public:
  // Throws FileError, with the reason in one line: no such file, not a checkpoint, of another format, cut short, or not
  // what was written.
  explicit Checkpoint(const std::filesystem::path& file);
  ~Checkpoint() = default;
  Checkpoint(const Checkpoint&) = delete;
  Checkpoint& operator=(const Checkpoint&) = delete;

  // Throws FileError if there is no such part, or it holds other things than what is visited.
  void read(const CheckpointPart& part) const;

 private:
  std::filesystem::path file_;
  std::string bytes_;
  std::map<std::string, std::string_view> part_;  // of the bytes
};

}  // namespace furrow
