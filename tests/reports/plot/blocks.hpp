#pragma once
// The data blocks of a gnuplot script, read back.
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace ordo::samples {

/// The lines of a data block, "" where there is no such block.
inline std::string block_of(const std::string& script, const std::string& name) {
    const std::string head = "$" + name + " << EOD\n";
    const auto begin = script.find(head);
    if (begin == std::string::npos) return "";
    return script.substr(begin + head.size(), script.find("EOD\n", begin + head.size()) - begin - head.size());
}

/// The numbers of a block, line by line; an empty line has none.
inline std::vector<std::vector<double>> numbers_of(const std::string& block) {
    std::vector<std::vector<double>> rows;
    std::istringstream stream(block);
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        rows.push_back({std::istream_iterator<double>(words), {}});
    }
    return rows;
}

}  // namespace ordo::samples
