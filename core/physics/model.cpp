#include "core/physics/model.h"

#include "core/physics/two_level.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::physics {

namespace {
/// Stiffness to the ground relative to a spring: too weak to be seen, enough for a loose end to have a place.
constexpr double kGround = 1e-7;
/// A person's pull relative to a spring: the fabric gives way before the pull does.
constexpr double kPull = 0.5;
} // namespace

Model::Model(std::unique_ptr<SpringTerm> springs, std::vector<std::unique_ptr<EnergyTerm>> others,
             Vector mass, Eigen::Matrix3Xd layout)
    : m_springs(std::move(springs)), m_others(std::move(others)), m_mass(std::move(mass)),
      m_layout(std::move(layout)), m_pinned(static_cast<std::size_t>(m_mass.size()), 0) {
    double stiffness = 0;
    double length = 0;
    for (const Spring& s : m_springs->springs()) {
        stiffness += s.pull;
        length += s.rest;
    }
    if (stiffness > 0 && length > 0) {
        m_stiffnessScale = stiffness / static_cast<double>(m_springs->springs().size());
        m_lengthScale = length / static_cast<double>(m_springs->springs().size());
    }
    m_ground = kGround * m_stiffnessScale;
}

template<class Visit> void Model::forTerms(Visit visit) const {
    visit(static_cast<const EnergyTerm&>(*m_springs));
    for (const auto& term : m_others) {
        m_interrupt.check();
        visit(static_cast<const EnergyTerm&>(*term));
    }
    visit(static_cast<const EnergyTerm&>(m_drag));
}

void Model::pull(Entry entry, const Eigen::Vector3d& target) {
    m_drag.pulls().assign(1, {entry, target, kPull * m_stiffnessScale});
}

void Model::release() {
    m_drag.pulls().clear();
}

void Model::setPinned(Entry entry, bool pinned) {
    m_pinned[static_cast<std::size_t>(entry)] = pinned ? 1 : 0;
    std::erase(m_pinnedEntries, entry);
    if (pinned) {
        m_pinnedEntries.push_back(entry);
    }
}

double Model::evaluate(const Vector& x, Vector* gradient) const {
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

void Model::linearise(const Vector& x) {
    m_springs->linearise(x);
    for (const auto& term : m_others) {
        m_interrupt.check();
        term->linearise(x);
    }
    m_drag.linearise(x);
}

void Model::multiply(const Vector& v, Vector& y) const {
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

Eigen::Matrix3Xd Model::diagonal() const {
    Eigen::Matrix3Xd blocks = Eigen::Matrix3Xd::Zero(3, size());
    forTerms([&](const EnergyTerm& term) { term.addDiagonal(blocks); });
    for (Entry e = 0; e < entryCount(); ++e) {
        auto block = blocks.middleCols<3>(Eigen::Index{3} * e);
        if (isPinned(e)) {
            block = m_stiffnessScale * Matrix3::Identity();
        }
        block.diagonal().array() += m_ground;
    }
    return blocks;
}

void Model::addBlocks(BlockSink& sink) const {
    forTerms([&](const EnergyTerm& term) { term.addBlocks(sink); });
}

void Model::mask(Vector& v) const {
    for (const Entry e : m_pinnedEntries) {
        at(v, e).setZero();
    }
}

double Model::allowedStep(const Vector& x, const Vector& move, double distortion) const {
    const double whole = largestDistortion(x, move);
    if (!std::isfinite(whole)) {
        return 0;
    }
    return whole > distortion ? distortion / whole : 1;
}

std::unique_ptr<Metric> Model::makeMetric() const {
    return std::make_unique<BlockJacobi>(*this);
}

std::unique_ptr<Preconditioner> Model::makePreconditioner() const {
    return std::make_unique<TwoLevel>(*this);
}

double Model::largestDistortion(const Vector& x, const Vector& move) const {
    double largest = 0;
    for (const Spring& s : m_springs->springs()) {
        const double length = std::max({s.rest, (at(x, s.b) - at(x, s.a)).norm(), 0.1 * m_lengthScale});
        largest = std::max(largest, (at(move, s.b) - at(move, s.a)).squaredNorm() / (length * length));
    }
    return std::sqrt(largest);
}

} // namespace knittsim::physics
