#include "core/physics/yarn_model/yarn_model.h"

#include "core/physics/yarn_model/yarn_preconditioner.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {
/// Stiffness to the ground relative to the bending of one segment: gives loose yarn a place.
constexpr double kGround = 1e-6;
} // namespace

YarnModel::YarnModel(const YarnChains& chains, int threads)
    : m_chains(chains.chains), m_nodeCount(chains.nodeCount()), m_cell(chains.cellEntry()),
      m_threads(threads), m_stretch(chains), m_bend(chains), m_contact(chains), m_cores(chains),
      m_guard(chains), m_restLength(chains.restLength) {
    m_thickest = thickestYarn(chains.yarns);
    const std::vector<double> yarn = nodeLengths(chains);
    m_mass.resize(m_nodeCount + (m_cell >= 0 ? 1 : 0));
    double total = 0;
    double stiffness = 0;
    for (const Chain& c : m_chains) {
        for (Entry e = c.first; e < c.first + c.count; ++e) {
            m_mass[e] = yarn[static_cast<std::size_t>(e)];
            total += m_mass[e];
            stiffness += chains.yarns[static_cast<std::size_t>(c.yarn)].bendingStiffness;
        }
    }
    if (m_cell >= 0) {
        m_mass[m_cell] = std::max(total, 1e-12);
    }
    m_pinned.assign(static_cast<std::size_t>(m_mass.size()), 0);
    if (m_nodeCount > 0) {
        m_lengthScale = total / m_nodeCount;
        m_stiffnessScale = stiffness / m_nodeCount / std::pow(m_lengthScale, 3);
    }
    m_ground = kGround * m_stiffnessScale;
}

template<class Visit> void YarnModel::forTerms(Visit visit) const {
    visit(static_cast<const EnergyTerm&>(m_stretch));
    visit(static_cast<const EnergyTerm&>(m_bend));
    m_interrupt.check();
    visit(static_cast<const EnergyTerm&>(m_contact));
    visit(static_cast<const EnergyTerm&>(m_cores));
    for (const auto& term : m_others) {
        m_interrupt.check();
        visit(static_cast<const EnergyTerm&>(*term));
    }
}

void YarnModel::setThickness(double share) {
    m_contact.setThickness(share);
    m_cores.setThickness(share);
}

void YarnModel::setPinned(Entry entry, bool pinned) {
    m_pinned[static_cast<std::size_t>(entry)] = pinned ? 1 : 0;
    std::erase(m_pinnedEntries, entry);
    if (pinned) {
        m_pinnedEntries.push_back(entry);
    }
}

double YarnModel::evaluate(const Vector& x, Vector* gradient) const {
    if (gradient != nullptr) {
        gradient->setZero(size());
    }
    double energy = 0;
    forTerms([&](const EnergyTerm& term) { energy += term.evaluate(x, gradient); });
    if (gradient != nullptr) {
        mask(*gradient);
    }
    return energy;
}

void YarnModel::linearise(const Vector& x) {
    m_linearisedAt = x;
    m_stretch.linearise(x);
    m_bend.linearise(x);
    m_interrupt.check();
    m_contact.linearise(x);
    m_cores.linearise(x);
    for (const auto& term : m_others) {
        term->linearise(x);
    }
}

void YarnModel::multiply(const Vector& v, Vector& y) const {
    y = m_ground * v;
    if (m_pinnedEntries.empty()) {
        forTerms([&](const EnergyTerm& term) { term.multiply(v, y); });
        return;
    }
    Vector moving = v;
    mask(moving);
    forTerms([&](const EnergyTerm& term) { term.multiply(moving, y); });
    for (const Entry e : m_pinnedEntries) {
        at(y, e) = m_stiffnessScale * at(v, e);
    }
}

void YarnModel::mask(Vector& v) const {
    for (const Entry e : m_pinnedEntries) {
        at(v, e).setZero();
    }
}

double YarnModel::allowedStep(const Vector& x, const Vector& move, double distortion) const {
    double largest = 0;
    for (const Chain& c : m_chains) {
        for (Entry i = 0; i < c.segmentCount(); ++i) {
            const Eigen::Vector3d change = position(move, m_cell, c.place(i + 1)) - at(move, c.first + i);
            const double rest = m_restLength[static_cast<std::size_t>(c.first + i)];
            largest = std::max(largest, change.squaredNorm() / (rest * rest));
        }
    }
    if (m_cell >= 0) {
        const auto change = at(move, m_cell).head<2>().cwiseQuotient(at(x, m_cell).head<2>());
        largest = std::max(largest, change.squaredNorm());
    }
    const double whole = std::sqrt(largest);
    const double guarded = m_guard.allowed(x, move);
    return whole > distortion ? std::min(guarded, distortion / whole) : guarded;
}

void YarnModel::shorten(const Vector& x, Vector& move, double distortion) const {
    constexpr int kRounds = 3;
    if (m_cell < 0 && x.allFinite() && move.allFinite()) {
        for (int round = 0; round < kRounds; ++round) {
            std::vector<double> share(static_cast<std::size_t>(m_nodeCount), 1);
            for (const Chain& c : m_chains) {
                for (Entry e = c.first; e < c.first + c.segmentCount(); ++e) {
                    const double change = (at(move, c.place(e - c.first + 1).node) - at(move, e)).norm();
                    const double most = distortion * m_restLength[static_cast<std::size_t>(e)];
                    if (change > most) {
                        StrandGuard::lower(share, {e, c.place(e - c.first + 1).node}, most / change);
                    }
                }
            }
            m_guard.lowerShares(x, move, share);
            if (std::ranges::all_of(share, [](double s) { return s == 1; })) {
                break;
            }
            spread(share);
            for (Entry e = 0; e < m_nodeCount; ++e) {
                at(move, e) *= share[static_cast<std::size_t>(e)];
            }
        }
    }
    move *= allowedStep(x, move, distortion);
}

/// What is shortened at one node is shortened a little less at the next ones.
void YarnModel::spread(std::vector<double>& share) const {
    constexpr double kRise = 1.25; ///< from node to node
    for (const Chain& c : m_chains) {
        for (Entry e = c.first + 1; e < c.first + c.count; ++e) {
            const auto i = static_cast<std::size_t>(e);
            share[i] = std::min(share[i], kRise * share[i - 1]);
        }
        for (Entry e = c.first + c.count - 1; e > c.first; --e) {
            const auto i = static_cast<std::size_t>(e);
            share[i - 1] = std::min(share[i - 1], kRise * share[i]);
        }
    }
}

std::unique_ptr<Metric> YarnModel::makeMetric() const {
    return std::make_unique<YarnPreconditioner>(*this);
}

std::unique_ptr<Preconditioner> YarnModel::makePreconditioner() const {
    return std::make_unique<YarnPreconditioner>(*this);
}

} // namespace knittsim::physics
