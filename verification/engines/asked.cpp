#include "verification/engines/asked.h"

#include <cmath>
#include <stdexcept>

#include "scene/utf8.h"
#include "scene/wording.h"

namespace furrow::verification {
namespace {

std::string text_of(const Json& answer, const char* name, const std::string& otherwise) {
  if (!answer.contains(name)) return otherwise;
  if (!answer[name].is_string())
    throw std::runtime_error("the answer's " + in_quotes(name) + " is not a text but " +
                             visible(answer[name].dump().substr(0, 40)));
  return answer[name];
}

bool says_nothing(const std::string& text) { return text.find_first_not_of(" \t\r\n") == std::string::npos; }

double claimed_order(const Json& answer) {
  const Json order = answer.value("order", Json(1));
  if (!order.is_number() || !(order.get<double>() >= 1) || order.get<double>() > 20)
    throw std::runtime_error("order is not that of a method, a number from 1 to 20");
  return order;
}

}  // namespace

double value_of(const Json& answer, const std::string& name) {
  const Json& all = answer.at("observables");
  if (!all.contains(name)) throw std::runtime_error("no observable " + in_quotes(name) + " in the answer");
  const Json& value = all[name];
  if (!value.is_number() || !std::isfinite(value.get<double>())) throw std::runtime_error(name + " is not a number");
  return value;
}

Asked ask(const Json& whole, const Engine& engine, Judgement& j) {
  Asked all;
  for (const int steps : j.steps) {
    all.answers.push_back(engine(request_of(whole, steps)));
    const Json& answer = all.answers.back();
    const bool first = all.answers.size() == 1;
    j.engine = text_of(answer, "engine", "unnamed");
    j.method = text_of(answer, "method", "");
    if (answer.contains("cannot")) {
      all.cannot = text_of(answer, "cannot", "");
      if (says_nothing(*all.cannot)) throw std::runtime_error("the answer has cannot, and no word why");
      if (!first) throw std::runtime_error("it answered, and then could not with shorter steps: " + *all.cannot);
      return all;
    }
    if (!answer.contains("observables")) throw std::runtime_error("the answer has neither observables nor cannot");
    if (!answer["observables"].is_object())
      throw std::runtime_error("the answer's observables are not an object of names and numbers");
    const double order = claimed_order(answer);
    if (!first && order != j.claimed)
      throw std::runtime_error("the order that it claims changes from " + rounded(j.claimed, 3) + " to " +
                               rounded(order, 3));
    j.claimed = order;
  }
  return all;
}

}  // namespace furrow::verification
