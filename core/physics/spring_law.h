#pragma once

#include <vector>

namespace knittsim::physics {

/// How a spring's force grows with its length d beyond its rest length d0.
enum class PullLaw {
    Quadratic, ///< energy 1/2 C (d - d0)^2: the preview
    Quartic, ///< energy C_p (d - d0)^4, equation 8; shorter than d0 the energy is C_r (d - d0)^2, equation 7
    Power,   ///< force C_k (d - d0)^a, a = 1, 3 or 5, equation 2
    Table,   ///< measured force-strain table of the yarn
};

/// Force of a yarn by strain (d - d0) / d0: mN at ascending strains, straight lines between, the last slope
/// beyond. Starts at strain 0 with force 0.
struct ForceStrainTable {
    std::vector<double> strain;
    std::vector<double> force;
};

struct SpringLaw {
    PullLaw pull = PullLaw::Quadratic;
    int exponent = 1;         ///< a of equation 2, for PullLaw::Power
    ForceStrainTable table{}; ///< for PullLaw::Table
};

/// Energy and its first two derivatives by the distance.
struct SpringValue {
    double energy = 0;
    double force = 0; ///< > 0 pulls the ends together
    double stiffness = 0;
};

/// The spring between two neighbours on a yarn.
struct Spring {
    int a = 0;
    int b = 0;
    double rest = 0; ///< d0, mm
    double pull =
        0; ///< constant for d > d0: mN/mm (Quadratic), mN/mm^3 (Quartic), mN/mm^a (Power); unused (Table)
    double push = 0; ///< constant for d < d0: mN/mm; 0 for a yarn that hangs slack. Unused by Power
};

SpringValue evaluateSpring(const SpringLaw& law, const Spring& spring, double distance);

} // namespace knittsim::physics
