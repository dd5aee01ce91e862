#include "ui/document/prefix_builder.h"

#include "ui/document/mailbox.h"

#include <QThreadPool>

#include <map>
#include <tuple>
#include <utility>

namespace knittsim::document {

namespace {

using fabric::BondingPoint;
using fabric::EntryIndex;
using fabric::Fabric;
using fabric::PointIndex;
using fabric::Role;

std::size_t at(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

void pairCorners(const Fabric& prefix, const Fabric& whole, std::vector<EntryIndex>& pairs) {
    const std::size_t count = std::min(prefix.loops.size(), whole.loops.size());
    for (std::size_t i = 0; i < count; ++i) {
        const auto mine = prefix.loops[i].corners();
        const auto theirs = whole.loops[i].corners();
        for (std::size_t corner = 0; corner < mine.size(); ++corner) {
            if (mine[corner] >= 0 && theirs[corner] >= 0) {
                pairs[at(prefix.points[at(mine[corner])].entry)] = whole.points[at(theirs[corner])].entry;
            }
        }
    }
}

/// Crossings by the operation that made them, in the order along the yarns.
void pairCrossings(const Fabric& prefix, const Fabric& whole, std::vector<EntryIndex>& pairs) {
    using Key = std::tuple<machine::OperationIndex, machine::LoopIndex, machine::Needle, int>;
    const auto keyOf = [](const BondingPoint& p) { return Key{p.operation, p.loop, p.needle, p.front}; };
    std::multimap<Key, EntryIndex> known;
    for (const BondingPoint& point : whole.points) {
        if (point.role == Role::Crossing) {
            known.emplace(keyOf(point), point.entry);
        }
    }
    for (const BondingPoint& point : prefix.points) {
        if (point.role != Role::Crossing || pairs[at(point.entry)] >= 0) {
            continue;
        }
        if (const auto found = known.lower_bound(keyOf(point));
            found != known.end() && found->first == keyOf(point)) {
            pairs[at(point.entry)] = found->second;
            known.erase(found);
        }
    }
}

Vec3f wholeAt(std::span<const float> whole, EntryIndex entry) {
    const std::size_t i = 3 * at(entry);
    return {whole[i], whole[i + 1], whole[i + 2]};
}

/// The nearest point on the same yarn, from `start` in steps of `step`, whose place is known; -1 where there
/// is none.
PointIndex nearestKnown(const PrefixFabric& prefix, const fabric::Yarn& yarn, PointIndex start, int step) {
    for (PointIndex p = start + step; p >= yarn.first && p < yarn.first + yarn.count; p += step) {
        if (prefix.wholeEntry[at(prefix.fabric->points[at(p)].entry)] >= 0) {
            return p;
        }
    }
    return -1;
}

/// Machine pitches are wider than the settled fabric; offsets shrink by about this.
constexpr float kOffsetScale = 0.6F;

void placeBeside(const PrefixFabric& prefix, const fabric::Yarn& yarn, PointIndex point,
                 std::span<const float> whole, std::vector<float>& positions) {
    const Fabric& fabric = *prefix.fabric;
    const EntryIndex entry = fabric.points[at(point)].entry;
    Vec3f sum = Vec3f::Zero();
    int found = 0;
    for (const int step : {-1, 1}) {
        const PointIndex other = nearestKnown(prefix, yarn, point, step);
        if (other >= 0) {
            const EntryIndex known = fabric.points[at(other)].entry;
            const Vec3 offset = fabric.machinePositions[at(entry)] - fabric.machinePositions[at(known)];
            sum += wholeAt(whole, prefix.wholeEntry[at(known)]) + kOffsetScale * offset.cast<float>();
            ++found;
        }
    }
    const Vec3f place = found > 0 ? Vec3f(sum / static_cast<float>(found))
                                  : Vec3f(fabric.machinePositions[at(entry)].cast<float>());
    std::copy(place.data(), place.data() + 3, positions.begin() + 3 * entry);
}

} // namespace

std::vector<EntryIndex> pairEntries(const Fabric& prefix, const Fabric& whole) {
    std::vector<EntryIndex> pairs(at(prefix.entryCount), -1);
    pairCorners(prefix, whole, pairs);
    pairCrossings(prefix, whole, pairs);
    return pairs;
}

std::vector<float> prefixPositions(const PrefixFabric& prefix, std::span<const float> whole) {
    std::vector<float> positions(3 * prefix.wholeEntry.size(), 0.0F);
    for (std::size_t entry = 0; entry < prefix.wholeEntry.size(); ++entry) {
        const EntryIndex known = prefix.wholeEntry[entry];
        if (known >= 0 && 3 * at(known) + 2 < whole.size()) {
            const Vec3f place = wholeAt(whole, known);
            std::copy(place.data(), place.data() + 3,
                      positions.begin() + static_cast<std::ptrdiff_t>(3 * entry));
        }
    }
    for (const fabric::Yarn& yarn : prefix.fabric->yarns) {
        for (PointIndex p = yarn.first; p < yarn.first + yarn.count; ++p) {
            if (prefix.wholeEntry[at(prefix.fabric->points[at(p)].entry)] < 0) {
                placeBeside(prefix, yarn, p, whole, positions);
            }
        }
    }
    return positions;
}

PrefixBuilder::PrefixBuilder(QObject* parent) : QObject(parent), m_mailbox(std::make_shared<Mailbox>(this)) {}

PrefixBuilder::~PrefixBuilder() {
    m_mailbox->close();
}

void PrefixBuilder::request(std::shared_ptr<const machine::Timeline> timeline,
                            std::shared_ptr<const fabric::Fabric> whole, machine::OperationIndex count) {
    m_waiting = Request{std::move(timeline), std::move(whole), count};
    startNext();
}

void PrefixBuilder::cancel() {
    m_waiting.reset();
    ++m_generation;
}

void PrefixBuilder::startNext() {
    if (m_busy || !m_waiting) {
        return;
    }
    m_busy = true;
    QThreadPool::globalInstance()->start([this, request = *std::exchange(m_waiting, std::nullopt),
                                          generation = m_generation, mailbox = m_mailbox] {
        auto prefix = std::make_shared<PrefixFabric>();
        prefix->count = request.count;
        prefix->fabric = std::make_shared<Fabric>(fabric::buildFabric(*request.timeline, request.count));
        prefix->held = fabric::heldStacks(request.timeline->stateAfter(request.count));
        prefix->whole = request.whole;
        prefix->wholeEntry = pairEntries(*prefix->fabric, *request.whole);
        mailbox->post([this, prefix, generation] {
            m_busy = false;
            if (generation == m_generation) {
                emit built(prefix);
            }
            startNext();
        });
    });
}

} // namespace knittsim::document
