#include "output/tell.h"

#include <mutex>
#include <utility>
#include <vector>

namespace furrow {
namespace {

std::mutex watchers_mutex;
std::vector<const FileWatch::Hear*> watchers;

}  // namespace

void tell(const std::filesystem::path& file, const FileNews& news) {
  const std::scoped_lock lock(watchers_mutex);
  for (const FileWatch::Hear* hear : watchers) (*hear)(file, news);
}

FileWatch::FileWatch(Hear hear) : hear_(std::move(hear)) {
  const std::scoped_lock lock(watchers_mutex);
  watchers.push_back(&hear_);
}

FileWatch::~FileWatch() {
  const std::scoped_lock lock(watchers_mutex);
  std::erase(watchers, &hear_);
}

}  // namespace furrow
