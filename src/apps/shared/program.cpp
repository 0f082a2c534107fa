#include "apps/shared/shared_command_line.h"

int main(int argc, char** argv) { return ajar_command_line(argc, argv); }
