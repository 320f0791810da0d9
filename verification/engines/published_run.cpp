#include "verification/engines/published_run.h"

#include <stdexcept>

#include "verification/engines/asked.h"
#include "verification/engines/furrow_engine.h"

namespace furrow::verification {

Json case_of_problem(const Json& problem) {
  if (problem.contains("case")) return case_named(problem["case"]);
  Json c = problem;
  for (const char* other : {"row", "of", "source", "cannot", "page"}) c.erase(other);
  c["unit"] = problem.at("end");
  c["steps"] = Json::array({problem.at("steps")});
  c.emplace("body", Json::array());
  c["observe"] = problem.at("row");
  for (Json& seen : c["observe"]) {
    seen["text"] = seen["name"];
    for (const char* other : {"said", "factor", "offset", "printed", "got", "tolerance", "known_off"})
      seen.erase(other);
  }
  return made_of_lattices(c);
}

std::map<std::string, double> furrows_numbers(const Json& problem) {
  const Json whole = case_of_problem(problem);
  const Json answer = furrow_answer(request_of(whole, whole["steps"].back()), "rk4");
  const std::string name = problem.at("name");
  if (answer.contains("cannot")) throw std::invalid_argument(name + ": " + answer["cannot"].get<std::string>());
  std::map<std::string, double> all;
  for (const Json& row : problem.at("row")) all[row["name"]] = value_of(answer, row["name"]);
  return all;
}

}  // namespace furrow::verification
