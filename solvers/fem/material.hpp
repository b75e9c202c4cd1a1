#pragma once
// The law of a bar, one Gauss point an element. In 1D the area stays, so that nominal and Cauchy stress are one.
#include <cmath>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "solvers/materials/law.hpp"
#include "solvers/stretches.hpp"

namespace ordo::solvers::fem {

/// A law in closed form: it has no memory.
template <class L>
struct ClosedMaterial {
    L law;

    ClosedMaterial(const L& given, std::size_t) : law(given) {}

    /// P[e] [Pa] of F[e] > 0 [-] in these elements.
    void stress(std::span<const double> F, std::span<double> P, Stretch elements) {
        for (std::size_t e = elements.from; e < elements.to; ++e) P[e] = law.template cauchy<1>(Tensor<1>(F[e]))(0, 0);
    }
};

/// A law in increments with a history. The increment of a stretch from F to F' is taken as ln(F'/F), which is exact:
/// the strain rate v_x integrates to it on any way from F to F'.
template <class L>
struct HistoryMaterial {
    struct Point {
        typename L::History history;
        double F = 1;  ///< where the history stands
    };
    L law;
    std::vector<Point> points;

    HistoryMaterial(const L& given, std::size_t elements) : law(given), points(elements) {}

    /// P[e] [Pa] after the way to F[e] > 0 [-] in one increment; it stays where F does.
    void stress(std::span<const double> F, std::span<double> P, Stretch elements) {
        for (std::size_t e = elements.from; e < elements.to; ++e) {
            if (F[e] == points[e].F) continue;
            const Tensor<1> dL(std::log(F[e] / points[e].F));
            P[e] = law.template updated<1>(points[e].history, dL)(0, 0);
            points[e].F = F[e];
        }
    }
};

template <class AnyLaw>
struct MaterialsOf;
template <class... L>
struct MaterialsOf<std::variant<L...>> {
    static_assert(((ClosedLaw<L, 1> || HistoryLaw<L, 1>)&&...));
    using type = std::variant<std::conditional_t<ClosedLaw<L, 1>, ClosedMaterial<L>, HistoryMaterial<L>>...>;
};

/// One of the above for each law; visited once a pass.
using Material = MaterialsOf<Law>::type;

inline Material material_of(const Law& law, std::size_t elements) {
    return std::visit(
        [&]<class L>(const L& kind) -> Material {
            return std::conditional_t<ClosedLaw<L, 1>, ClosedMaterial<L>, HistoryMaterial<L>>(kind, elements);
        },
        law);
}

}  // namespace ordo::solvers::fem
