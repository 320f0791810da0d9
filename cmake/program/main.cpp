// The program with all commands: those of the solver, of verification and of validation, and the studies of all.
#include "program_with_all.h"
#include "validation/commands.h"
#include "validation/page/chapters/chapters.h"
#include "verification/commands.h"

int main(int argc, char** argv) {
  return furrow::run_program(
      argc, argv,
      {furrow::add_solver_commands, furrow::verification::add_stability_command,
       furrow::verification::add_judge_commands,
       [](CLI::App& app, std::vector<furrow::Command>& all) {
         furrow::validation::add_report_command(app, all, furrow::validation::catalogue());
       },
       furrow::validation::add_view_command, furrow::add_study_commands, furrow::validation::add_calibrate_command});
}
