#include "reports/cache/build.hpp"

#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>

#include "build_facts.hpp"
#include "reports/report.hpp"

namespace ordo::reports {
namespace {

std::string c_library() {
    std::array<char, 64> text{};
    return confstr(_CS_GNU_LIBC_VERSION, text.data(), text.size()) > 0 ? text.data() : "unknown";
}

}  // namespace

std::string build_of_figures() {
    using namespace build_facts;
    const Provenance here = provenance_here(0, 0);
    const nlohmann::json json{{"compiler", here.compiler},
                              {"flags", here.flags},
                              {"libraries", here.libraries},
                              {"c_library", c_library()},
                              {"processor", here.cpu},
                              {"sources",
                               {{"build", sources_build},
                                {"core", sources_core},
                                {"solvers", sources_solvers},
                                {"oracles", sources_oracles},
                                {"engine", sources_engine},
                                {"scenes", sources_scenes},
                                {"amplification", sources_amplification}}}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace ordo::reports
