#pragma once
// Named fields: what solvers return and exact solutions evaluate, under the same names and units.
#include <string>
#include <vector>

namespace ordo {

/// A field's name and unit; rank 0 is a scalar, 1 a vector of dim, 2 a tensor of dim x dim (row by row).
struct FieldInfo {
    std::string name;
    std::string unit;
    int rank = 0;
};

/// The fields every room speaks of. u is displacement, v velocity; a sign says tension is positive.
inline const std::vector<FieldInfo>& standard_fields() {
    static const std::vector<FieldInfo> fields{
        {"displacement", "m", 1}, {"velocity", "m/s", 1}, {"stress", "Pa", 2}, {"strain", "-", 2}};
    return fields;
}

/// Values of one field at n points: values[point * components + component].
struct Field {
    std::string name;
    int components = 1;
    std::vector<double> values;
};

constexpr int components_of(int rank, int dim) { return rank == 0 ? 1 : rank == 1 ? dim : dim * dim; }

}  // namespace ordo
