#pragma once
// What each point touches: the rows of the sparse matrices S_ip and grad S_ip. Everything between points and grid goes
// through them, whatever basis filled them.
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "solvers/scene.hpp"

namespace ordo::solvers::mpm {

/// Row p holds the nodes that point p touches, with S_ip [-] and grad S_ip [1/m]. A node may stand in a row twice:
/// every use is a sum. Rows are appended; memory is kept from one filling to the next.
template <int dim>
class Stencils {
public:
    std::size_t points() const { return end_.size(); }
    void clear() {
        end_.clear();
        count_ = 0;
    }
    void add(int node, double w, const Vec<dim>& grad_w) {
        if (count_ == node_.size()) grow();
        node_[count_] = node;
        w_[count_] = w;
        grad_[count_] = grad_w;
        ++count_;
    }
    void close_row() { end_.push_back(count_); }

    /// Every node is replaced by `image` of it.
    template <class Image>
    void rename(Image&& image) {
        for (int& node : node_) node = image(node);
    }

    /// visit(node, w, grad_w) for each entry of row p; grad_w may be changed by a visitor that takes it by reference.
    template <class Visit>
    void row(std::size_t p, Visit&& visit) const {
        for (std::size_t k = begin(p); k < end_[p]; ++k) visit(node_[k], w_[k], grad_[k]);
    }
    template <class Visit>
    void row(std::size_t p, Visit&& visit) {
        for (std::size_t k = begin(p); k < end_[p]; ++k) visit(node_[k], w_[k], grad_[k]);
    }

    std::span<const int> nodes(std::size_t p) const { return std::span(node_).subspan(begin(p), end_[p] - begin(p)); }
    std::span<const double> weights(std::size_t p) const { return std::span(w_).subspan(begin(p), end_[p] - begin(p)); }

    /// From the same rows on cells of width 1: S_ip is the same, grad S_ip goes with 1/h.
    void take_gradients(const Stencils& of_unit_cells, double h) {
        const double factor = 1 / h;
        for (std::size_t k = 0; k < count_; ++k) grad_[k] = factor * of_unit_cells.grad_[k];
    }

private:
    std::size_t begin(std::size_t p) const { return p == 0 ? 0 : end_[p - 1]; }
    void grow() {
        const std::size_t room = std::max<std::size_t>(64, 2 * count_);
        node_.resize(room);
        w_.resize(room);
        grad_.resize(room);
    }

    std::vector<std::size_t> end_;
    std::size_t count_ = 0;  ///< of the entries; behind them is room for more
    std::vector<int> node_;
    std::vector<double> w_;
    std::vector<Vec<dim>> grad_;
};

}  // namespace ordo::solvers::mpm
