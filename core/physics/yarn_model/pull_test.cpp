#include "core/physics/yarn_model/pull_test.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {

/// Of the spring between grip and fabric, by the stress at which it gives way by the size of the cell,
/// EI/d^3.
constexpr double kGrip = 1e5;

class Strip {
public:
    Strip(const CellShape& rest, const PullOptions& options)
        : m_options(options), m_model(rest.chains),
          m_friction(addFriction(m_model, rest.chains)), m_motion{rest.shape, Vector::Zero(rest.shape.size()),
                                                                  0} {
        auto load = std::make_unique<CellLoadTerm>(m_model.cellEntry());
        m_load = load.get();
        m_model.add(std::move(load));
        const auto size = at(rest.shape, m_model.cellEntry());
        m_length = size[options.side];
        m_across = size[1 - options.side];
    }

    StopRule::Verdict drawTo(double strain) {
        m_load->hold(m_options.side, (1 + strain) * m_length, kGrip * m_across / m_length);
        return makeLoadStep(m_model, m_friction, m_motion, {.relax = m_options.relax}).verdict;
    }

    PullPoint point(bool back) const {
        const Vector& x = m_motion.positions;
        const auto size = at(x, m_model.cellEntry());
        return {size[m_options.side] / m_length - 1,
                m_load->force(m_options.side, x) / m_across,
                size.x(),
                size.y(),
                m_model.elasticEnergy(x),
                back};
    }

    const Vector& shape() const { return m_motion.positions; }
    StrandAudit audit() const { return m_model.audit(shape()); }

private:
    const PullOptions& m_options;
    YarnModel m_model;
    FrictionTerm* m_friction;
    CellLoadTerm* m_load = nullptr;
    Motion m_motion;
    double m_length = 0; ///< at rest
    double m_across = 0;
};

} // namespace

double PullResult::work(bool back) const {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].back == back) {
            sum += 0.5 * (points[i].stress + points[i - 1].stress) *
                   std::abs(points[i].strain - points[i - 1].strain);
        }
    }
    return sum;
}

PullResult pullCell(const KnitPurl& pattern, const CellShape& rest, const PullOptions& options) {
    PullResult result;
    Strip strip(rest, options);
    const auto add = [&](bool back) {
        result.points.push_back(strip.point(back));
        if (options.onPoint) {
            options.onPoint(result.points.back());
        }
    };
    add(false);
    const auto advance = [&](int step, bool back) {
        result.verdict = strip.drawTo(options.strain * step / options.steps);
        if (isAtRest(result.verdict)) {
            add(back);
        }
        return isAtRest(result.verdict);
    };
    int step = 1;
    while (step <= options.steps && advance(step, false)) {
        ++step;
    }
    result.audit = strip.audit();
    result.faults = findLoopFaults(pattern, rest.chains, strip.shape(), rest.nodesPerLoop);
    if (step <= options.steps || !options.back) {
        return result;
    }
    for (step = options.steps - 1; step >= 0 && result.points.back().stress > 0; --step) {
        if (!advance(step, true)) {
            break;
        }
    }
    return result;
}

} // namespace knittsim::physics
