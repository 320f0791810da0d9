// Why the ensemble does not bear out a statement of the paper.
#pragma once

#include <optional>
#include <string>

#include "report/study.h"
#include "validation/studies/members.h"
#include "validation/studies/observed_run.h"
#include "validation/studies/reading_search.h"

namespace furrow::validation {

// What decided, whether the number depends on the step, and how near another reading of the paper comes; the last two
// where these studies are kept. Empty for what is reproduced or not testable.
class Reasons {
 public:
  explicit Reasons(const Shelf& shelf);
  // ": the method makes ..."; empty where the study of convergence is not kept.
  std::string spheres_at_the_papers_step() const;
  std::string why(const Statement& statement, const Sample& sample, const std::string& group,
                  const std::string& verdict) const;

 private:
  std::string step(const Statement& statement, const std::string& group) const;
  std::string other_reading(const Statement& statement) const;

  const Numbers* convergence_ = nullptr;
  std::optional<ReadingsFound> found_;
};

// Cells of a table: the statement, with an id to link to and a link to what shows it; what the paper says, and where.
Json statement_cell(const Statement& statement, const std::string& group);
Json paper_cell(const Statement& statement, const std::string& said);

}  // namespace furrow::validation
