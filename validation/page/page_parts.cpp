#include "validation/page/page_parts.h"

namespace furrow::validation {

const std::vector<PagePart>& page_parts() {
  static const std::vector<PagePart> all{
      {"finding",
       "The finding",
       "Which of the paper's numbers are its model's, and which its time step's?",
       {"convergence"}},
      {"scenes", "The three scenes", "What happens in them, and what the paper reports of each.", {}},
      {"right",
       "Are the equations solved right?",
       "By checks against closed forms, by the order of each method, by faults put into the source. Whether soil "
       "behaves "
       "like this model is another question: nothing here is compared with measured soil.",
       {"responses", "order", "published"}},
      {"accurate", "How accurate is it?", "What an error costs, by each method.", {"work_precision", "need"}},
      {"breaks", "Where does it break?", "How long a step may be, and what happens beyond.", {"stability"}},
      {"fast",
       "How fast is it, and how do other engines do?",
       "Beside other programs on the same scene, beside the machine's limit, and from commit to commit.",
       {"speed"}},
      {"paper",
       "What of the paper stands?",
       "Its statements one by one, over many packings of the bed.",
       {"statements", "readings", "ensemble", "geometry", "outlook"}},
      {"made", "How it was made", "By which program, on which machine, and when.", {}}};
  return all;
}

}  // namespace furrow::validation
