// Every word reaches its option; what does not go together is refused with the words that tell why.
#include <string>

#include "core/error.hpp"
#include "solvers/mpm/options.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

/// The words of one option in the order of its enumerators, each given with what it needs.
template <class Member>
void check_words(const std::string& option, Member member, const std::vector<std::pair<std::string, Given>>& words) {
    const auto parameters = option_parameters();
    const Parameter* declared = find_parameter(parameters, option);
    REQUIRE(declared != nullptr);
    REQUIRE(declared->words.size() == words.size());
    using Enum = std::decay_t<decltype(Options{}.*member)>;
    for (std::size_t k = 0; k < words.size(); ++k) {
        auto [word, given] = words[k];
        INFO(option << " " << word);
        given[option] = word;
        CHECK(options_of(given).*member == static_cast<Enum>(k));
    }
}

const Given usl{{"stress_update", "usl"}};

struct Refused {
    Given options;
    std::string key;  ///< that the message holds
};

const SolidScene<1> bar = fixed_free_bar(1, 1, 0.1, LogarithmicLaw{{.lambda = 0, .mu = 0.5}});

template <int dim>
void check_refused(const SolidScene<dim>& scene, const Given& given, const std::string& key) {
    INFO(key);
    CHECK_THROWS_WITH(check_fits(scene, options_of(given)), ContainsSubstring(key));
}

}  // namespace

TEST_CASE("choices: each word of an enumeration reaches its own enumerator", "[unit]") {
    check_words("frame", &Options::frame, {{"updated", {}}, {"total", {}}});
    check_words("kernel", &Options::kernel, {{"fast", {}}, {"fast_everywhere", {}}, {"readable", {}}});
    check_words("basis", &Options::basis,
                {{"linear", {}},
                 {"quadratic", {}},
                 {"cubic", {}},
                 {"quartic", {}},
                 {"ugimp", {}},
                 {"cpgimp", {}},
                 {"cpdi", {}},
                 {"cpdi2", {}},
                 {"ddmp", {}}});
    check_words("mass", &Options::mass, {{"lumped", {}}, {"consistent", {}}, {"fmpm", {}}});
    check_words("stress_update", &Options::stress_update, {{"usf", {}}, {"usl", {}}, {"musl", {}}, {"usavg", {}}});
    check_words("time", &Options::time,
                {{"symplectic_euler", {}}, {"leapfrog", {}}, {"yoshida4", {}}, {"yoshida6", {}}});
    check_words("transfer", &Options::transfer,
                {{"flip", {}},
                 {"pic", {}},
                 {"blend", {}},
                 {"xpic", usl},
                 {"fmpm", {{"mass", "fmpm"}, {"stress_update", "usl"}}},
                 {"apic", {{"basis", "cubic"}}},
                 {"tpic", {}},
                 {"mls", {{"basis", "quadratic"}}}});
    check_words("placement", &Options::placement,
                {{"cell_centred", {}}, {"even_interior", {}}, {"gauss", {}}, {"body_centred", {}}});
    check_words("beyond_grid", &Options::beyond_grid, {{"extend", {}}, {"extrapolate", {}}, {"follow", {}}});
    check_words("reconstruction", &Options::reconstruction,
                {{"none", {}}, {"cubic_spline", {}}, {"tls", {}}, {"mls", {}}, {"impm", usl}});
    check_words("body_force", &Options::body_force, {{"particles", {}}, {"nodes", {}}, {"left_out", {}}});
}

TEST_CASE("choices: each switch and number reaches its option", "[unit]") {
    const auto of = [](const Given& given) { return options_of(given); };
    CHECK(of({}).strain_mesh == StrainMesh::undeformed);
    CHECK(of({{"strain_increment", "midpoint_mesh"}}).strain_mesh == StrainMesh::midpoint);
    CHECK(of({{"strain_increment", "moved_mesh"}}).strain_mesh == StrainMesh::moved);
    CHECK(of({}).volume_updated);
    CHECK_FALSE(of({{"volume", "fixed"}}).volume_updated);
    CHECK_FALSE(of({}).stress_from_F);
    CHECK(of({{"stress_from", "F"}}).stress_from_F);
    CHECK(of({}).moved_by_remapped);
    CHECK_FALSE(of({{"position_update", "accelerated"}}).moved_by_remapped);
    CHECK_FALSE(of({{"stress_update", "usl"}}).moved_by_remapped);
    CHECK_FALSE(of({}).last_particle_loaded);
    CHECK(of({{"traction", "last_particle"}}).last_particle_loaded);
    CHECK_FALSE(of({}).cells_span_grid);
    CHECK(of({{"cells_span", "grid"}, {"placement", "body_centred"}}).cells_span_grid);
    CHECK_FALSE(of({}).volume_of_cell);
    CHECK(of({{"particle_volume", "share_of_cell"}, {"placement", "body_centred"}}).volume_of_cell);
    CHECK_FALSE(of({}).conservative);
    CHECK(of({{"conservative", true}, {"reconstruction", "tls"}}).conservative);
    CHECK(of({{"margin", 2.0}}).margin == 2);
    CHECK(of({{"k", 7.0}}).terms == 7);
    CHECK(of({{"degree", 5.0}}).degree == 5);
    CHECK(of({{"flip_share", 0.25}}).flip_share == 0.25);
    for (const auto& [basis, degree] : {std::pair{"linear", 1},
                                        {"quadratic", 2},
                                        {"cubic", 3},
                                        {"quartic", 4},
                                        {"ugimp", 1},
                                        {"cpdi2", 1},
                                        {"ddmp", 1}})
        CHECK(of({{"basis", basis}}).spline_degree() == degree);
}

TEST_CASE("choices: what does not go together is refused", "[unit]") {
    const std::vector<Refused> table{
        {{{"time", "leapfrog"}, {"stress_update", "usf"}}, "leapfrog"},
        {{{"time", "leapfrog"}, {"stress_update", "usavg"}}, "leapfrog"},
        {{{"time", "yoshida4"}, {"stress_update", "usl"}}, "composition"},
        {{{"time", "yoshida6"}, {"position_update", "accelerated"}}, "composition"},
        {{{"time", "yoshida4"}, {"transfer", "pic"}}, "composition"},
        {{{"time", "yoshida6"}, {"transfer", "tpic"}}, "composition"},
        {{{"transfer", "apic"}}, "tpic"},
        {{{"transfer", "mls"}, {"basis", "ddmp"}}, "tpic"},
        {{{"transfer", "xpic"}}, "xpic"},
        {{{"transfer", "xpic"}, {"stress_update", "usl"}, {"mass", "consistent"}}, "xpic"},
        {{{"transfer", "fmpm"}, {"stress_update", "usl"}}, "fmpm"},
        {{{"transfer", "fmpm"}, {"mass", "fmpm"}}, "fmpm"},
        {{{"transfer", "tpic"}, {"mass", "consistent"}}, "affine"},
        {{{"transfer", "apic"}, {"mass", "fmpm"}, {"basis", "cubic"}}, "affine"},
        {{{"frame", "total"}, {"strain_increment", "moved_mesh"}}, "moved_mesh"},
        {{{"frame", "total"}, {"beyond_grid", "follow"}}, "beyond_grid"},
        {{{"frame", "total"}, {"beyond_grid", "extrapolate"}}, "beyond_grid"},
        {{{"beyond_grid", "extrapolate"}, {"basis", "ugimp"}}, "extrapolate"},
        {{{"beyond_grid", "extrapolate"}, {"basis", "ddmp"}}, "extrapolate"},
        {{{"traction", "last_particle"}, {"beyond_grid", "follow"}}, "last_particle"},
        {{{"cells_span", "grid"}}, "cells_span"},
        {{{"cells_span", "grid"}, {"placement", "body_centred"}, {"beyond_grid", "extrapolate"}}, "cells_span"},
        {{{"cells_span", "grid"}, {"placement", "body_centred"}, {"frame", "total"}}, "cells_span"},
        {{{"particle_volume", "share_of_cell"}}, "particle_volume"},
        {{{"conservative", true}}, "conservative"},
        {{{"reconstruction", "mls"}, {"frame", "total"}}, "reconstruction"},
        {{{"reconstruction", "mls"}, {"transfer", "tpic"}}, "reconstruction"},
        {{{"reconstruction", "tls"}, {"mass", "fmpm"}}, "reconstruction"},
        {{{"reconstruction", "tls"}, {"beyond_grid", "extrapolate"}}, "reconstruction"},
        {{{"reconstruction", "tls"}, {"traction", "last_particle"}}, "reconstruction"},
        {{{"reconstruction", "impm"}}, "impm"},
        {{{"reconstruction", "impm"}, {"stress_update", "usl"}, {"basis", "quadratic"}}, "impm"},
        {{{"reconstruction", "impm"}, {"stress_update", "usl"}, {"mass", "consistent"}}, "impm"},
        {{{"reconstruction", "mls"}, {"basis", "cpdi"}}, "reconstruction"},
    };
    for (const auto& [options, key] : table) {
        std::string given;
        for (const auto& [name, value] : options) given += name + " " + text_of(value) + " ";
        INFO(given);
        CHECK_THROWS_AS(options_of(options), InputError);
        CHECK_THROWS_WITH(options_of(options), ContainsSubstring(key));
    }
}

TEST_CASE("choices: what does not fit the scene is refused", "[unit]") {
    const auto plate = box<2>({1, 1}, Face::free, uniform<2>({0, 0}));
    check_refused<2>(plate, {{"reconstruction", "mls"}}, "one dimension");
    check_refused<2>(plate, {{"beyond_grid", "follow"}}, "one dimension");
    check_refused<2>(plate, {{"stress_from", "F"}}, "one dimension");
    CHECK_NOTHROW(check_fits(bar, options_of({{"stress_from", "F"}})));

    auto plastic = bar;
    plastic.law = J2Law{};
    check_refused<1>(plastic, {{"stress_from", "F"}}, "history");
    CHECK_NOTHROW(check_fits(plastic, options_of({{"strain_increment", "moved_mesh"}})));

    auto elastic = bar;
    elastic.law = HenckyLaw{};
    check_refused<1>(elastic, {{"strain_increment", "moved_mesh"}}, "strain_increment");
    check_refused<1>(bar, {{"strain_increment", "midpoint_mesh"}, {"stress_from", "F"}}, "strain_increment");
    CHECK_NOTHROW(check_fits(bar, options_of({{"strain_increment", "moved_mesh"}})));

    const auto bent = [](auto scene) {
        scene.deformed.emplace();
        return scene;
    };
    check_refused<2>(bent(plate), {}, "deformed");
    check_refused<1>(bent(plastic), {}, "deformed");
    CHECK_NOTHROW(check_fits(bent(bar), options_of({})));
    CHECK_NOTHROW(check_fits(bent(elastic), options_of({})));

    auto pushed = bar;
    pushed.face_velocity = uniform<1>(Vec<1>(1));
    check_refused<1>(pushed, {}, "frame 'total'");
    CHECK_NOTHROW(check_fits(pushed, options_of({{"frame", "total"}})));
}
