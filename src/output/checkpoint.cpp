#include "output/checkpoint.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "scene/hash.h"

namespace furrow {
namespace {

constexpr std::string_view magic =
    "\x89"
    "FURROW\n";
constexpr std::uint32_t format = 1;
constexpr std::size_t head = 8 + 4 + 8, tail = 8;  // bytes

template <class T>
void put(std::string& bytes, T value) {
  for (std::size_t k = 0; k < sizeof value; ++k, value = static_cast<T>(value >> 8))
    bytes.push_back(static_cast<char>(value & 0xff));
}

template <class T>
T get(std::string_view bytes) {
  T value = 0;
  for (std::size_t k = sizeof value; k-- > 0;)
    value = static_cast<T>(value << 8 | static_cast<unsigned char>(bytes[k]));
  return value;
}

std::string all_of(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream in = regular_file(file);
  if (!in)
    throw FileError("cannot read " + file.string() + ": " +
                    (errno != 0 ? std::strerror(errno) : "it is no regular file"));
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw FileError("cannot read all of " + file.string());
  return bytes;
}

}  // namespace

void HistoryWriter::begin(char type, std::string_view name) {
  bytes_.push_back(type);
  put(bytes_, static_cast<std::uint32_t>(name.size()));
  bytes_ += name;
}

void HistoryWriter::number(std::string_view name, double& value) {
  begin('d', name);
  put(bytes_, std::bit_cast<std::uint64_t>(value));
}

void HistoryWriter::integer(std::string_view name, std::int64_t& value) {
  begin('i', name);
  put(bytes_, static_cast<std::uint64_t>(value));
}

void HistoryWriter::text(std::string_view name, std::string& value) {
  begin('t', name);
  put(bytes_, std::uint64_t{value.size()});
  bytes_ += value;
}

void HistoryWriter::integers(std::string_view name, std::vector<std::int64_t>& values) {
  begin('I', name);
  put(bytes_, std::uint64_t{values.size()});
  for (const std::int64_t v : values) put(bytes_, static_cast<std::uint64_t>(v));
}

void HistoryWriter::state(std::string_view name, State& values) {
  begin('D', name);
  put(bytes_, std::uint64_t{values.size()});
  for (const double v : values) put(bytes_, std::bit_cast<std::uint64_t>(v));
}

std::string_view HistoryReader::take(std::size_t count) {
  if (count > bytes_.size()) throw FileError("it ends too soon");
  const std::string_view taken = bytes_.substr(0, count);
  bytes_.remove_prefix(count);
  return taken;
}

std::uint64_t HistoryReader::word() { return get<std::uint64_t>(take(8)); }

std::size_t HistoryReader::count(std::size_t bytes_each) {
  const std::uint64_t count = word();
  if (count > bytes_.size() / bytes_each) throw FileError("it ends too soon");
  return count;
}

void HistoryReader::begin(char type, std::string_view name) {
  const char found = take(1)[0];
  const std::string_view called = take(get<std::uint32_t>(take(4)));
  if (found != type || called != name)
    throw FileError("it holds '" + std::string(called) + "' where '" + std::string(name) + "' is looked for");
}

void HistoryReader::number(std::string_view name, double& value) {
  begin('d', name);
  value = std::bit_cast<double>(word());
}

void HistoryReader::integer(std::string_view name, std::int64_t& value) {
  begin('i', name);
  value = static_cast<std::int64_t>(word());
}

void HistoryReader::text(std::string_view name, std::string& value) {
  begin('t', name);
  value = take(count(1));
}

void HistoryReader::integers(std::string_view name, std::vector<std::int64_t>& values) {
  begin('I', name);
  values.resize(count(8));
  for (std::int64_t& v : values) v = static_cast<std::int64_t>(word());
}

void HistoryReader::state(std::string_view name, State& values) {
  begin('D', name);
  values.resize(count(8));
  for (double& v : values) v = std::bit_cast<double>(word());
}

void write_checkpoint(const std::filesystem::path& file, const std::vector<CheckpointPart>& parts) {
  std::string bytes(magic);
  put(bytes, format);
  put(bytes, std::uint64_t{0});
  for (const CheckpointPart& part : parts) {
    HistoryWriter writer;
    part.visit(writer);
    put(bytes, static_cast<std::uint32_t>(part.name.size()));
    bytes += part.name;
    put(bytes, std::uint64_t{writer.bytes().size()});
    bytes += writer.bytes();
  }
  std::string length;
  put(length, std::uint64_t{bytes.size() + tail});
  bytes.replace(magic.size() + 4, length.size(), length);
  put(bytes, Fnv1a().add(bytes).value());
  OutputFile out = OutputFile::rewriting(file);
  out << bytes;
  out.finish();
}

Checkpoint::Checkpoint(const std::filesystem::path& file) : file_(file), bytes_(all_of(file)) {
  const auto refuse = [&](const std::string& why) { throw FileError(file.string() + " " + why); };
  const std::string_view all = bytes_;
  if (all.size() < head + tail || !all.starts_with(magic)) refuse("is not a checkpoint of a run");
  const auto made_by = get<std::uint32_t>(all.substr(8));
  if (made_by != format)
    refuse("is a checkpoint of format " + std::to_string(made_by) + ", this program reads format " +
           std::to_string(format));
  const auto length = get<std::uint64_t>(all.substr(12));
  if (all.size() < length)
    refuse("is cut short: " + std::to_string(all.size()) + " of " + std::to_string(length) + " bytes");
  if (all.size() > length ||
      get<std::uint64_t>(all.substr(all.size() - tail)) != Fnv1a().add(all.substr(0, all.size() - tail)).value())
    refuse("is damaged: its checksum is not that of its bytes");
  std::string_view rest = all.substr(head, all.size() - head - tail);
  const auto take = [&](std::size_t count) {
    if (count > rest.size()) refuse("is damaged: a part of it is longer than the file");
    const std::string_view taken = rest.substr(0, count);
    rest.remove_prefix(count);
    return taken;
  };
  while (!rest.empty()) {
    const std::string name(take(get<std::uint32_t>(take(4))));
    part_[name] = take(get<std::uint64_t>(take(8)));
  }
}

void Checkpoint::read(const CheckpointPart& part) const {
  const auto found = part_.find(part.name);
  const std::string where = file_.string() + " cannot be read, its part '" + part.name + "': ";
  if (found == part_.end()) throw FileError(where + "there is none");
  HistoryReader reader(found->second);
  try {
    part.visit(reader);
  } catch (const FileError& error) {
    throw FileError(where + error.what());
  }
  if (!reader.at_end()) throw FileError(where + "it holds more than this program knows");
}

}  // namespace furrow
