// Whom the fast kernel serves, and what may be asked of it.
#include "solvers/mpm/fast/fast.hpp"

namespace ordo::solvers::mpm::fast {

template <int dim>
bool serves(const SolidScene<dim>& scene, const Options& o) {
    const bool rates = std::holds_alternative<LogarithmicLaw>(scene.law) ||
                       std::holds_alternative<ReciprocalLaw>(scene.law) ||
                       std::holds_alternative<NominalLaw>(scene.law);
    const bool basis = o.basis == Basis::linear || (o.basis == Basis::quadratic && dim < 3);
    const bool plain = o.mass == Mass::lumped && o.transfer == Transfer::flip &&
                       o.reconstruction == Reconstruction::none && o.beyond_grid == BeyondGrid::extend;
    const bool forces = !o.stress_from_F && !o.last_particle_loaded && o.body_force != BodyForce::nodes &&
                        !(scene.damping && o.stress_update == StressUpdate::usf);
    return o.kernel != Kernel::readable && rates && basis && plain && forces && !o.composed() &&
           o.stress_update != StressUpdate::usavg && !scene.face_velocity && !any_face(scene, Face::periodic);
}

template <int dim>
Particles<dim> FastMpm<dim>::particles() const {
    using R = Row<dim>;
    Particles<dim> p;
    const std::size_t count = X_.size();
    p.X = X_;
    for (auto* vectors : {&p.x, &p.v}) vectors->resize(count);
    for (auto* numbers : {&p.m, &p.volume}) numbers->resize(count);
    p.sigma.resize(count);
    const bool keeps_F = slots_.rows() > R::F;
    if (keeps_F) p.F.resize(count);
    slots_.each([&](Seat seat) {
        const auto k = static_cast<std::size_t>(slots_.id(seat) - 1);
        p.x[k] = where(seat);
        for (int i = 0; i < dim; ++i) {
            p.v[k][i] = slots_.at(seat, R::v + i);
            p.sigma[k](i, i) = slots_.at(seat, R::sigma + i);
            for (int j = i + 1; j < dim; ++j)
                p.sigma[k](i, j) = p.sigma[k](j, i) = slots_.at(seat, R::sigma + dim + i + j - 1);
        }
        p.m[k] = slots_.at(seat, R::m);
        p.volume[k] = slots_.at(seat, R::volume);
        for (int i = 0; keeps_F && i < dim * dim; ++i) p.F[k].data()[i] = slots_.at(seat, R::F + i);
    });
    return p;
}

template <int dim>
Vec<dim> FastMpm<dim>::momentum() const {
    Vec<dim> sum = Vec<dim>::Zero();
    slots_.each([&](Seat seat) {
        for (int c = 0; c < dim; ++c) sum[c] += slots_.at(seat, Row<dim>::m) * slots_.at(seat, Row<dim>::v + c);
    });
    return sum;
}

/// What the nodes hold, and what never came to them because it is at rest, or will with the next sweep.
template <int dim>
double FastMpm<dim>::mass_on_grid() const {
    double sum = total_ ? 0 : joined_;
    for (const auto& run : m_) {
        for (const double m : run.at) sum += m;
    }
    for (const Block& block : slots_.blocks()) {
        if (!total_ && !block.swept) slots_.each_in(block, [&](Seat seat) { sum += slots_.at(seat, Row<dim>::m); });
    }
    return sum;
}

template <int dim>
std::vector<Skipped> FastMpm<dim>::skipped() const {
    std::vector<Skipped> skipped;
    if (due_ > swept_) skipped.push_back({"particle-steps of regions at rest", 1 - swept_ / due_});
    if (total_ && due_ > 0) {
        const double steps = due_ / static_cast<double>(X_.size());
        skipped.push_back({"looking for particles and gathering masses, in the total frame once a run", 1 - 1 / steps});
    }
    return skipped;
}

template bool serves(const SolidScene<1>&, const Options&);
template bool serves(const SolidScene<2>&, const Options&);
template bool serves(const SolidScene<3>&, const Options&);
template class FastMpm<1>;
template class FastMpm<2>;
template class FastMpm<3>;

}  // namespace ordo::solvers::mpm::fast
