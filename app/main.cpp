// The command `ordo`.
#include "app/command.hpp"

int main(int argc, char** argv) { return ordo::app::run_ordo(std::vector<std::string>(argv + 1, argv + argc)); }
