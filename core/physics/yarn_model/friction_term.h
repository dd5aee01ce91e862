#pragma once

#include "core/physics/yarn_model/contact_term.h"
#include "core/physics/yarn_model/hard_core_term.h"

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace knittsim::physics {

/// Coulomb friction between yarns, smoothed and lagged (Li et al. 2020, Incremental Potential Contact,
/// section 5), and a little viscous: per contact the potential mu N (f0(|u|) + |w|^2 / (2 L)), with
///
/// - u, how far the two touching places have moved against each other since the reference shape, without its
///   part along the contact's normal, and what they were strained by then: of the u before, at most e. So a
///   contact that holds goes on holding with the same force from one step to the next;
/// - N and the normal, the force that pressed them together in the lagged shape and the direction it counts
///   in. Neither follows the shape, so that the term is the potential of its forces;
/// - f0(s) = s for s >= e, else -s^3 / (3 e^2) + s^2 / e + e / 3: below the slip threshold e = kThreshold the
///   force rises from 0 to mu N, beyond it stays there;
/// - w, u without that strain, and L, the slip that doubles the force. What jumps then does so in pieces
///   (load_step.h), each from a reference of its own; at rest no slip is left and with it no viscosity.
///
/// The contacts are those of ContactTerm and HardCoreTerm. Between nodes the force leans along the yarns; the
/// normal is its part across both of them (across one where they run side by side), so that a crossing holds
/// mu times what presses it, however the nodes lie. Friction of two yarns is the mean of theirs. The Hessian
/// is exact and positive semi-definite.
class FrictionTerm final : public EnergyTerm {
public:
    static constexpr double kThreshold = 1e-2; ///< e, in outer diameters of the thickest yarn

    explicit FrictionTerm(const YarnChains& chains);

    /// The shape at which a step begins; lag() must follow.
    void holdAt(const Vector& reference);

    /// L, > 0, d; endless at first.
    void setDoublingSlip(double slip) { m_doublingSlip = slip; }

    /// Sum of mu N over all contacts.
    double limit() const;

    /// How far the contact that has moved most has moved since the reference shape.
    double largestSlip(const Vector& x) const;

    /// Takes contacts, normals and forces from shape x, at the terms' present thickness.
    void lag(const ContactTerm& shells, const HardCoreTerm& cores, const Vector& x);

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override;
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override;
    void addBlocks(BlockSink& sink) const override;

private:
    template<std::size_t Count> struct Rub {
        Stencil<Count> apart;
        Eigen::Vector3d start;  ///< at the reference
        Eigen::Vector3d strain; ///< by then
        Eigen::Vector3d normal; ///< unit
        double limit = 0;       ///< mu N
    };
    template<std::size_t Count> using Rubs = std::vector<Rub<Count>>;

    using Strains = std::unordered_map<std::uint64_t, Eigen::Vector3d>; ///< by the nodes of a contact

    template<std::size_t Count>
    void keepStrains(const Rubs<Count>& rubs, const Vector& x, Strains& strains) const;
    template<std::size_t Count>
    void lagOn(const std::vector<Press<Count>>& presses, const Strains& strains, const Vector& x,
               Rubs<Count>& rubs) const;
    template<std::size_t Count> Eigen::Vector3d slipOf(const Rub<Count>& rub, const Vector& x) const {
        const Eigen::Vector3d move = rub.apart.of(x, m_cell) - rub.start + rub.strain;
        return move - rub.normal.dot(move) * rub.normal;
    }
    template<std::size_t Count>
    double evaluateOn(const Rubs<Count>& rubs, const Vector& x, Vector* gradient) const;
    template<std::size_t Count>
    void lineariseOn(const Rubs<Count>& rubs, const Vector& x, StencilHessian<Count>& hessian) const;
    Eigen::Vector3d tangentAt(const Vector& x, Entry node) const;

    std::vector<double> m_friction; ///< by node
    std::vector<Place> m_before;    ///< by node: its neighbours, itself at the end of a yarn
    std::vector<Place> m_after;
    Entry m_cell;
    double m_threshold;
    double m_doublingSlip = std::numeric_limits<double>::infinity();
    Vector m_reference;
    Rubs<2> m_shells;
    Rubs<4> m_cores;
    Strains m_shellStrains;
    Strains m_coreStrains;
    StencilHessian<2> m_shellHessian;
    StencilHessian<4> m_coreHessian;
};

} // namespace knittsim::physics
