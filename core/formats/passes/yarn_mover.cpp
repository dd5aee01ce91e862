#include "core/formats/passes/yarn_mover.h"

#include "core/formats/passes/merge.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::formats::passes {

using machine::CarrierIndex;
using machine::CarrierSet;
using machine::Direction;
using machine::Needle;

int YarnMover::slot(Needle needle) const {
    return isFront(needle.bed) ? needle.index : needle.index + static_cast<int>(std::floor(m_rack));
}

void YarnMover::bringIn(const CarrierSet& carriers, machine::OperationKind how) {
    for (const CarrierIndex c : carriers) {
        m_yarns[c] = {};
        m_yarns[c].in = true;
        m_yarns[c].arrival = Arrival{carriers, how == machine::OperationKind::InHook};
    }
}

std::optional<YarnMover::Arrival> YarnMover::takeArrival(const CarrierSet& carriers) {
    std::optional<Arrival> arrival;
    for (const CarrierIndex c : carriers) {
        if (m_yarns[c].arrival) {
            arrival = std::exchange(m_yarns[c].arrival, std::nullopt);
        }
    }
    return arrival;
}

std::optional<Needle> YarnMover::place(CarrierIndex carrier) const {
    const auto& last = m_yarns[carrier].last;
    return last ? std::optional(last->needle) : std::nullopt;
}

Pass YarnMover::softMiss(int slot, const CarrierSet& carriers, Direction direction, Pass pass) const {
    pass.kind = PassKind::Stitch;
    pass.direction = direction;
    pass.carriers = carriers;
    pass.rack = m_rack;
    pass.cells[slot] = {};
    return pass;
}

/// Which carriers of a new pass may stand on its wrong side, and beside which slot they have to go.
std::vector<YarnMover::Kick> YarnMover::kicksBefore(const Pass& pass) const {
    std::vector<Kick> kicks;
    const int wanted = pass.firstSlot();
    for (const CarrierIndex c : pass.carriers) {
        if (!m_yarns[c].last) {
            continue;
        }
        const Place& parked = *m_yarns[c].parked;
        const int at = slot(parked.needle);
        const bool behind = parked.side == pass.direction;
        const bool beyond = pass.direction == Direction::Right ? at > wanted : at < wanted;
        if (!behind && !beyond) {
            continue;
        }
        const int to = behind ? at : wanted;
        const auto found =
            std::find_if(kicks.begin(), kicks.end(), [&](const Kick& kick) { return kick.slot == to; });
        if (found != kicks.end()) {
            found->carriers.push(c);
        } else {
            kicks.push_back({to, {c}});
        }
    }
    std::sort(kicks.begin(), kicks.end(), [](const Kick& a, const Kick& b) { return a.slot < b.slot; });
    return kicks;
}

void YarnMover::kick(const Kick& kick, Direction direction, Pass pass) {
    add(softMiss(kick.slot, kick.carriers, direction, std::move(pass)));
    for (const CarrierIndex c : kick.carriers) {
        m_yarns[c].parked = Place{{machine::Bed::Front, kick.slot}, direction};
    }
}

void YarnMover::add(Pass pass) {
    if (std::exchange(m_pause, false)) {
        pass.pause = true;
        pass.message = std::exchange(m_message, {});
    }
    const bool end = std::exchange(m_end, false);
    if (!m_passes.empty() && !end && append(m_passes.back(), pass, m_rules)) {
        return;
    }
    const std::vector<Kick> kicks = kicksBefore(pass);
    if (kicks.empty()) {
        m_passes.push_back(std::move(pass));
        return;
    }
    for (const Kick& next : kicks) {
        Pass plain;
        plain.stitch = pass.stitch;
        plain.speed = pass.speed;
        plain.pause = std::exchange(pass.pause, false);
        plain.message = std::exchange(pass.message, {});
        kick(next, opposite(*pass.direction), std::move(plain));
    }
    add(std::move(pass));
}

void YarnMover::clear(Needle needle, const CarrierSet& carriers, const Pass& pass) {
    const int wanted = slot(needle);
    for (std::size_t i = 0; i < m_yarns.size(); ++i) {
        const auto c = static_cast<CarrierIndex>(i);
        const Yarn& yarn = m_yarns[i];
        if (carriers.contains(c) || !yarn.last) {
            continue;
        }
        const int hangs = slot(yarn.last->needle);
        const bool left = hangs < wanted || (hangs == wanted && yarn.last->side == Direction::Left);
        const Direction side = left ? Direction::Left : Direction::Right;
        const int at = slot(yarn.parked->needle);
        const bool aside = yarn.parked->side == side && (left ? at <= wanted : at >= wanted);
        if (!aside) {
            kick({hangs, {c}}, side, pass);
        }
    }
}

void YarnMover::stitched(const CarrierSet& carriers, Needle needle, Direction direction) {
    for (const CarrierIndex c : carriers) {
        m_yarns[c].last = m_yarns[c].parked = Place{needle, direction};
    }
}

void YarnMover::moved(Needle from, Needle to) {
    for (Yarn& yarn : m_yarns) {
        if (yarn.last && yarn.last->needle == from) {
            yarn.last->needle = to;
        }
    }
}

void YarnMover::pause(std::string message) {
    m_pause = true;
    m_message = std::move(message);
}

void YarnMover::takeOut(const CarrierSet& carriers, bool hook, Pass pass) {
    int from = slot(*place(carriers[0]));
    for (const CarrierIndex c : carriers) {
        from = std::max(from, slot(*place(c)));
    }
    pass = softMiss(from, carriers, m_rules.outwards, std::move(pass));
    pass.gripper = Gripper::Out;
    pass.hook = hook ? Hook::Out : Hook::None;
    add(std::move(pass));
    for (const CarrierIndex c : carriers) {
        m_yarns[c] = {};
    }
}

void YarnMover::releaseHook(const CarrierSet& carriers, Direction direction, Pass pass) {
    const int at = slot(*place(carriers[0]));
    pass = softMiss(at, {}, direction, std::move(pass));
    // The release cannot stand in a pass before which the carriage has to move, so another one goes first.
    if (!m_passes.empty() && m_passes.back().direction == direction) {
        Pass before = pass;
        before.direction = opposite(direction);
        m_passes.push_back(std::move(before));
    }
    pass.hook = Hook::Release;
    m_passes.push_back(std::move(pass));
}

bool YarnMover::returnSliders() {
    Pass& pass = m_passes.back();
    const double way = std::abs(m_rack - pass.rack);
    const bool fits = way == 1 || way == 2 || way == 4;
    if (!fits || (pass.returnRack && *pass.returnRack != m_rack)) {
        return false;
    }
    pass.returnRack = m_rack;
    return true;
}

} // namespace knittsim::formats::passes
