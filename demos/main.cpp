#include "demos/program.h"

int main(int argc, char** argv) { return kinescope::run_program(argc, argv); }
