// The same problem seen in a mirror, from a train, and elsewhere.
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm;
using namespace ordo::solvers::rrm::test;

namespace {

const std::vector<std::string> keeps{"nothing", "contacts", "waves"};

/// The scene for x -> -x.
LineScene mirrored(const LineScene& scene) {
    LineScene image = scene;
    std::ranges::reverse(image.edges);
    for (double& x : image.edges) x = -x;
    std::ranges::reverse(image.pieces);
    for (Contents& q : image.pieces) q.momentum = -q.momentum;
    std::swap(image.ends[0], image.ends[1]);
    for (LineEnd& end : image.ends) {
        end.velocity = -end.velocity;
        end.outside.momentum = -end.outside.momentum;
    }
    return image;
}

/// Whether two snapshots are each other's image, bit by bit.
bool are_images(const Snapshot& shot, const Snapshot& image) {
    const std::size_t n = shot.points();
    bool same = image.points() == n;
    for (std::size_t i = 0; same && i <= n; ++i) same = shot.edges[i] == -image.edges[n - i];
    for (std::size_t k = 0; same && k < shot.fields.size(); ++k) {
        const auto& name = shot.fields[k].name;
        const double sign = name == "velocity" || name == "momentum" ? -1 : 1;
        for (std::size_t i = 0; same && i < n; ++i) {
            same = shot.fields[k].values[i] == sign * image.fields[k].values[n - 1 - i] &&
                   (shot.slopes.empty() || shot.slopes[k].values[i] == -sign * image.slopes[k].values[n - 1 - i]);
        }
    }
    return same;
}

/// The problem seen by an observer that moves with -V, with its origin at `shift`.
Problem moved(const Problem& problem, double V, double shift) {
    Problem other = problem;
    for (double& x : other.scene.edges) x += shift;
    for (Contents& q : other.scene.pieces) {
        const double v = q.momentum / q.mass;
        q.energy += 0.5 * q.mass * ((v + V) * (v + V) - v * v);
        q.momentum += q.mass * V;
    }
    const double way = shift + V * problem.t;
    other.exact = [problem, V, way](double x) {
        Row row = problem.exact(x - way);
        row[1] += V;
        return row;
    };
    for (double& x : other.places) x += way;
    return other;
}

/// Errors over the stretch that the waves of a problem cross, with a tenth of it on both sides.
Row errors_about_waves(const Snapshot& shot, const Problem& problem) {
    const double margin = 0.1 * (problem.places.back() - problem.places.front());
    Row found{};
    for (std::size_t k = 0; k < problem.watched(); ++k) {
        const auto exact = [&](double x) { return problem.exact(x)[k]; };
        found[k] = l1(shot, k, exact, problem.places, problem.places.front() - margin, problem.places.back() + margin);
    }
    return found;
}

}  // namespace

TEST_CASE("rrm: mirror images are images to the bit", "[property]") {
    // Not where several events have one time, as in Toro's second problem or in linear elasticity: who goes first then
    // depends on the order of storage.
    for (const auto& keep : keeps) {
        for (const Problem& problem : {sod, toro[0], toro[2], toro[4], rubber(0), rubber(3)}) {
            CAPTURE(keep, problem.scene.medium.index(), problem.t);
            const Given options = problem.watching({{"keep", keep}});
            CHECK(are_images(at(problem.t, problem.scene, options, 1e-3),
                             at(problem.t, mirrored(problem.scene), options, 1e-3)));
        }
    }
}

TEST_CASE("rrm: mirror images err alike", "[property]") {
    for (const Problem& problem :
         {sod, toro[0], toro[1], toro[4], rubber(0), rubber(2), rubber(3), linear(0), linear(3)}) {
        Problem image = problem;
        image.scene = mirrored(problem.scene);
        image.exact = [problem](double x) {
            Row row = problem.exact(-x);
            row[1] = -row[1];
            return row;
        };
        std::ranges::reverse(image.places);
        for (double& x : image.places) x = -x;
        const Given options = problem.watching({{"keep", std::string("waves")}});
        const Row here = errors(at(problem.t, problem.scene, options, 1e-3), problem);
        const Row there = errors(at(problem.t, image.scene, options, 1e-3), image);
        for (std::size_t k = 0; k < problem.watched(); ++k) {
            CAPTURE(problem.scene.medium.index(), problem.t, k, here[k], there[k]);
            CHECK(std::abs(there[k] - here[k]) <= 1e-12 * (here[k] + problem.length() * problem.range(k)));
        }
    }
}

TEST_CASE("rrm: mirrored ends act as their images", "[property]") {
    using Kind = LineEnd::Kind;
    const ElasticMedium<RubberEnergy> rubber{.k = 1};
    const std::vector<Contents> pieces{rubber.contents(1, 0.1, 1), rubber.contents(0.8, -0.1, 1.2)};
    const std::vector<LineEnd> kinds{{Kind::wall},
                                     {Kind::wall, 0.2},
                                     {Kind::wall, -0.2},
                                     {Kind::free},
                                     {Kind::prescribed, 0, rubber.contents(0.9, 0.2, 0.8)}};
    for (const LineEnd& left : kinds) {
        for (const LineEnd& right : kinds) {
            const LineScene scene{rubber, {-0.5, -0.125, 0.5}, pieces, {left, right}};
            const auto shot = at(0.15, scene, {}, 1e-3);
            const auto image = at(0.15, mirrored(scene), {}, 1e-3);
            CAPTURE(int(left.kind), left.velocity, int(right.kind), right.velocity);
            CHECK(are_images(shot, image));
        }
    }
}

TEST_CASE("rrm: errors do not depend on who looks and from where", "[property]") {
    // Roundings move event times by 1e-16 of them; a union that costs as much as is allowed may then go the other way,
    // and errors of flattening change by a few of its intervals' share. Kept waves have no such choice.
    for (const auto& keep : keeps) {
        for (const Problem& problem : {sod, toro[0], rubber(0), rubber(3)}) {
            const Given options = problem.watching({{"keep", keep}});
            const Row here = errors_about_waves(at(problem.t, problem.scene, options, 1e-3), problem);
            const double V = 0.1 * problem.length() / problem.t;
            for (const auto& [boost, shift] : {std::pair{0.0, 7.3}, {V, 0.0}, {-V, 0.0}}) {
                const Problem other = moved(problem, boost, shift);
                const Row there = errors_about_waves(at(other.t, other.scene, options, 1e-3), other);
                for (std::size_t k = 0; k < problem.watched(); ++k) {
                    CAPTURE(keep, problem.scene.medium.index(), boost, shift, k, here[k], there[k]);
                    const double close = keep == "waves" ? 1e-6 * here[k] + 1e-12 : 0.1 * here[k];
                    CHECK(std::abs(there[k] - here[k]) < close);
                }
            }
        }
    }
}
