#include "studies/engine/extrapolated.hpp"

#include <algorithm>

namespace ordo::studies {

std::vector<SeriesExtrapolation> extrapolations_of(const Result& result) {
    std::vector<SeriesExtrapolation> all;
    for (const auto& fit : result.fits) {
        const auto& quantities = result.study.measure.quantities;
        const auto quantity = std::ranges::find(quantities, fit.quantity, &Quantity::key);
        if (quantity == quantities.end() || quantity->against != Against::itself) continue;
        std::vector<GridValue> grids;
        for (const int id : fit.used) {
            const Run& run = result.runs[static_cast<std::size_t>(id)];
            grids.push_back({run.at(fit.abscissa), run.error(fit.quantity)});
        }
        all.push_back({fit.series, fit.abscissa, fit.quantity, fit.used, extrapolations(std::move(grids))});
    }
    return all;
}

}  // namespace ordo::studies
