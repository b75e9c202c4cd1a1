#pragma once
// What each point touches: the rows of the sparse matrices S_ip and grad S_ip. Everything between points and grid goes
// through them, whatever basis filled them.
#include <cstddef>
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
        node_.clear();
        w_.clear();
        grad_.clear();
    }
    void add(int node, double w, const Vec<dim>& grad_w) {
        node_.push_back(node);
        w_.push_back(w);
        grad_.push_back(grad_w);
    }
    void close_row() { end_.push_back(node_.size()); }

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

private:
    std::size_t begin(std::size_t p) const { return p == 0 ? 0 : end_[p - 1]; }

    std::vector<std::size_t> end_;
    std::vector<int> node_;
    std::vector<double> w_;
    std::vector<Vec<dim>> grad_;
};

}  // namespace ordo::solvers::mpm
