// Says of scene files all that is wrong with them.
#include <algorithm>
#include <iostream>

#include "program/commands.h"
#include "scene/interrupt.h"
#include "scene/read.h"

namespace furrow {

int check_command(const std::vector<std::string>& scenes) {
  bool bad = false, unread = false;
  Progress progress;
  for (const std::string& file : scenes) {
    try {
      progress.begin("furrow", "checking " + file);
      const std::vector<std::string> warnings = checked_warnings(file);
      progress.end();
      for (const std::string& text : warnings) std::cerr << file << ": warning: " << text << "\n";
      std::cout << file << ": ok\n";
    } catch (const SceneError& error) {
      bad = true;
      progress.end();
      std::cerr << error.what() << "\n";
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {  // cannot be read; the others are still checked
      unread = true;
      progress.end();
      std::cerr << "furrow: error: " << error.what() << "\n";
    }
  }
  return bad ? bad_input : unread ? io_failed : good;
}

}  // namespace furrow
