#include "bench/reference/floor.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "bench/reference/walls.hpp"

namespace ordo::bench {
namespace {

constexpr std::size_t page = std::size_t{2} << 20;

SlotSteps loops_of(const std::string& set) {
    if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") && (set.empty() || set == "avx512"))
        return slots_avx512();
    if (__builtin_cpu_supports("avx2") && (set.empty() || set == "avx2")) return slots_avx2();
    if (set.empty() || set == "baseline") return slots_baseline();
    throw std::invalid_argument("this machine has no instruction set '" + set + "'");
}

std::size_t slot_values(const Wave& wave) {
    const int fields = 2 * wave.dim + wave.dim * (wave.dim + 1) / 2 + 2;
    return static_cast<std::size_t>(wave.particles()) * static_cast<std::size_t>(fields);
}

std::size_t node_values(const Wave& wave, int lanes) {
    int count = 1 + 2 * wave.dim;
    for (int a = 0; a < wave.dim; ++a)
        count *= a == wave.dim - 1 ? wave.cells[a] + lanes * wave.degree : wave.cells[a] + wave.degree;
    return static_cast<std::size_t>(count);
}

/// Doubles from the nodes of a step to those of the next: half a small page off, since a load waits for an earlier
/// store to the same place of another page.
std::size_t apart(std::size_t values) { return (values / 512 + 1) * 512 + 256; }

SlotRun run_of(const Wave& wave, int lanes, double* slots, double* nodes) {
    SlotRun run{.slots = slots,
                .nodes = nodes,
                .next = nodes + apart(node_values(wave, lanes)),
                .cells = {wave.cells[0], wave.cells[1], wave.cells[2]},
                .h = wave.h,
                .dt = wave.dt(),
                .lambda = wave.lambda,
                .mu = wave.mu};
    int& across = run.cells[wave.dim - 1];
    if (across % lanes != 0 || across < lanes * wave.degree)
        throw std::invalid_argument("the last axis has no whole number of cells a strip");
    across /= lanes;
    return run;
}

}  // namespace

Pages::Pages(std::size_t count)
    : data_(static_cast<double*>(std::aligned_alloc(page, (count * sizeof(double) / page + 1) * page))), count_(count) {
    if (!data_) throw std::bad_alloc();
    madvise(data_.get(), (count * sizeof(double) / page + 1) * page, MADV_HUGEPAGE);
    std::fill_n(data_.get(), count, 0.0);
}

void Pages::Free::operator()(double* data) const { std::free(data); }

Floor::Floor(const Wave& wave, const std::string& set)
    : wave_(wave),
      loops_(loops_of(set)),
      slots_(slot_values(wave)),
      nodes_(2 * apart(node_values(wave, loops_.lanes))),
      run_(run_of(wave, loops_.lanes, slots_.begin(), nodes_.begin())) {
    Particles p = seeded(wave);
    each_value(p, [](double& slot, double value) { slot = value; });
    loops_.begin[wave.dim - 1][wave.degree - 1](run_);
    close();
}

void Floor::step() {
    loops_.step[wave_.dim - 1][wave_.degree - 1](run_);
    close();
}

Particles Floor::particles() const {
    Particles p = seeded(wave_);
    each_value(p, [](double slot, double& value) { value = slot; });
    return p;
}

/// visit(in a slot, in `p`) for each value of each particle.
template <class Visit>
void Floor::each_value(Particles& p, Visit&& visit) const {
    const int dim = wave_.dim;
    std::vector<double*> fields;
    for (int a = 0; a < dim; ++a) fields.push_back(p.x[a].data());
    for (int a = 0; a < dim; ++a) fields.push_back(p.v[a].data());
    for (int k = 0; k < dim * (dim + 1) / 2; ++k) fields.push_back(p.sigma[k].data());
    fields.push_back(p.volume.data());
    fields.push_back(p.m.data());
    const std::size_t rows = run_.cells[dim - 1];
    const std::size_t in_row = p.size() / static_cast<std::size_t>(wave_.cells[dim - 1]);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const std::size_t row = i / in_row;
        const std::size_t vector = row % rows * in_row + i % in_row;
        for (std::size_t f = 0; f < fields.size(); ++f)
            visit(run_.slots[(vector * fields.size() + f) * loops_.lanes + row / rows], fields[f][i]);
    }
}

void Floor::close() {
    const int dim = wave_.dim;
    const int degree = wave_.degree;
    const int lanes = loops_.lanes;
    const int values = (1 + 2 * dim) * lanes;
    const int wide = run_.cells[0] + degree;
    const int slab = dim == 1 ? 1 : dim == 2 ? wide : wide * (run_.cells[1] + degree);
    const int rows = run_.cells[dim - 1];
    const auto node = [&](int i) { return run_.next + static_cast<std::ptrdiff_t>(i) * values; };
    for (int i = 0; i < degree * slab; ++i) {
        double* high = node(rows * slab + i);
        double* low = node(i);
        for (int k = 0; k < values; ++k) {
            if (k % lanes != lanes - 1) low[k + 1] = high[k] += low[k + 1];
        }
    }
    const Wall first{dim, lanes, dim - 1, 0, 1};
    const Wall last{dim, lanes, dim - 1, lanes - 1, lanes};
    for (int i = 0; i < slab; ++i) {
        first(node(i), node((degree - 1) * slab + i));
        if (!wave_.free_end) last(node(rows * slab + i), node((rows + degree - 1) * slab + i));
    }
    const auto walls = [&](int axis, int stride, int line) {
        const Wall wall{dim, lanes, axis, 0, lanes};
        for (const int edge : {line, line + run_.cells[axis] * stride})
            wall(node(edge), node(edge + (degree - 1) * stride));
    };
    for (int i = 0; dim > 1 && i < slab * (rows + degree); i += wide) walls(0, 1, i);
    for (int row = 0; dim > 2 && row < rows + degree; ++row) {
        for (int i = 0; i < wide; ++i) walls(1, wide, row * slab + i);
    }
    std::swap(run_.nodes, run_.next);
}

double Floor::bytes_per_particle() const {
    return static_cast<double>(sizeof(double) * (slots_.size() + nodes_.size())) /
           static_cast<double>(wave_.particles());
}

}  // namespace ordo::bench
