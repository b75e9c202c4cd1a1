#include "oracles/oracle.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles {

std::size_t Exact::width() const {
    int sum = 0;
    for (const auto& field : fields) sum += components_of(field.rank, dim);
    return static_cast<std::size_t>(sum);
}

std::optional<std::size_t> Exact::offset(const std::string& field) const {
    int sum = 0;
    for (const auto& known : fields) {
        if (known.name == field) return static_cast<std::size_t>(sum);
        sum += components_of(known.rank, dim);
    }
    return std::nullopt;
}

void Exact::check(std::span<const double> x, double t, const std::string& where) const {
    if (!times.contains(t)) throw InputError(where, "t = " + shortest(t) + " s, but must be " + times.text());
    for (std::size_t k = 0; k < x.size(); ++k) {
        const std::size_t axis = k % lower.size();
        if (x[k] >= lower[axis] && x[k] <= upper[axis]) continue;
        throw InputError(where, "x = " + shortest(x[k]) + " lies outside [" + shortest(lower[axis]) + ", " +
                                    shortest(upper[axis]) + "]");
    }
}

}  // namespace ordo::oracles
