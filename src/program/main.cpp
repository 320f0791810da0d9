// The program of the solver alone; with all commands: cmake/program/main.cpp.
#include "program/program.h"

int main(int argc, char** argv) { return furrow::run_program(argc, argv, {furrow::add_solver_commands}); }
