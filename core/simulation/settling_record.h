#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/yarn_curve.h"
#include "core/simulation/surroundings.h"
#include "core/yarn/yarn.h"

#include <memory>
#include <span>
#include <vector>

namespace knittsim::simulation {

/// A moment of the settling.
struct SettlingShape {
    std::vector<float> positions; ///< 3 per entry of the bonding point table, mm
    std::shared_ptr<const geometry::YarnCurves> curves = nullptr; ///< of the yarn model; null without it
};

/// Keeps shapes that follow each other evenly: a new one each time the fabric has moved by about the same
/// way, so that the slow end does not fill the sequence. Never more than twice `most`: then every second one
/// goes.
class SettlingRecord {
public:
    /// `stepMm`: root mean square way of the bonding points from one shape to the next; grows with the
    /// length.
    SettlingRecord(double stepMm, std::size_t most);

    /// Whether add() would keep a shape at these places; the first one always.
    bool wants(std::span<const float> positions) const;
    void add(SettlingShape shape);

    const std::vector<SettlingShape>& shapes() const { return m_shapes; }
    std::vector<SettlingShape> takeShapes() { return std::move(m_shapes); }

private:
    double m_stepMm;
    std::size_t m_most;
    std::vector<SettlingShape> m_shapes;
};

struct RecordOptions {
    bool yarn = false;                              ///< the yarn model instead of bonding points
    Surroundings surroundings = Surroundings::Flat; ///< of the yarn model
    double maxSeconds = 60;
    std::size_t most = 120; ///< shapes; at most twice as many are kept
};

/// Settles a fabric from where the machine leaves it, and keeps the way there; the first shape is the
/// machine's, the last one that at rest. `progress` tells about how far it has come. Errors: KS0009
/// (cancelled), KS0406 (the yarn cannot be settled).
Result<std::vector<SettlingShape>> recordSettling(const std::shared_ptr<const fabric::Fabric>& fabric,
                                                  const std::vector<yarn::Yarn>& yarns,
                                                  const RecordOptions& options,
                                                  const Progress& progress = {});

} // namespace knittsim::simulation
