#include "devices/hardware/first_line.h"

#include <fstream>

namespace foverig::hardware {

std::string first_line_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

}  // namespace foverig::hardware
