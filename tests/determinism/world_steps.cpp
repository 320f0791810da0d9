// Writes a world's state after its start and after each step to standard output, for a process that compares: the width
// of the vectors is chosen once a process. Each snapshot is its length, 8 bytes, and its history.
//   usage: world_steps full|elastic METHOD STEPS THREADS SKIN CELL_SIZE
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "output/checkpoint.h"
#include "worlds.h"

int main(int argc, char** argv) {
  using namespace furrow;
  if (argc != 7) {
    std::fprintf(stderr, "usage: world_steps full|elastic METHOD STEPS THREADS SKIN CELL_SIZE\n");
    return 2;
  }
  const auto kind = std::string(argv[1]) == "full" ? test::BedKind::full : test::BedKind::elastic;
  test::World world(kind, {std::atoi(argv[4]), std::atof(argv[5]), std::atof(argv[6])}, argv[2]);
  for (int left = std::atoi(argv[3]);; --left) {
    HistoryWriter writer;
    test::Snapshot at = world.now();
    at.history(writer);
    const std::uint64_t length = writer.bytes().size();
    if (std::fwrite(&length, sizeof length, 1, stdout) != 1 ||
        std::fwrite(writer.bytes().data(), length, 1, stdout) != 1)
      return 4;
    if (left == 0) return std::fflush(stdout) == 0 ? 0 : 4;
    world.step();
  }
}
