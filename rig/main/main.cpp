#include "rig/program.h"

int main(int argc, char** argv) {
    return foverig::run_program(argc, argv);
}
