#include "tests/support/fabric_form.h"

#include "tests/support/rewrite_program.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace knittsim::test {

using fabric::Fabric;
using fabric::LoopIndex;
using fabric::Piece;
using fabric::Role;
using fabric::Side;
using machine::Bed;

namespace {

class Former {
public:
    explicit Former(const Fabric& fabric) : m_fabric(fabric) {}

    FabricForm run() {
        nameLoops();
        for (std::size_t y = 0; y < m_fabric.yarns.size(); ++y) {
            const fabric::Yarn& yarn = m_fabric.yarns[m_order[y]];
            for (auto p = yarn.first; p < yarn.first + yarn.count; ++p) {
                m_form.yarns[y].stops.push_back(stopOf(p));
            }
        }
        return std::move(m_form);
    }

private:
    const fabric::BondingPoint& point(fabric::PointIndex p) const {
        return m_fabric.points[static_cast<std::size_t>(p)];
    }
    LoopName nameOf(LoopIndex loop) const { return m_names[static_cast<std::size_t>(loop)]; }

    void nameLoops() {
        m_order.resize(m_fabric.yarns.size());
        std::iota(m_order.begin(), m_order.end(), 0U);
        std::ranges::stable_sort(m_order, {}, [&](std::size_t y) { return m_fabric.yarns[y].carrier; });
        std::map<std::int32_t, int> indexOfYarn; // machine's number -> index in the form
        m_form.yarns.resize(m_order.size());
        for (std::size_t y = 0; y < m_order.size(); ++y) {
            const fabric::Yarn& yarn = m_fabric.yarns[m_order[y]];
            m_form.yarns[y].carrier = yarn.carrier;
            const auto loop = static_cast<std::size_t>(point(yarn.first).loop);
            indexOfYarn[m_fabric.made.loops[loop].yarn] = static_cast<int>(y);
        }
        std::vector<int> count(m_order.size(), 0);
        for (const machine::Loop& loop : m_fabric.made.loops) {
            const int yarn = indexOfYarn.at(loop.yarn);
            m_names.push_back({yarn, count[static_cast<std::size_t>(yarn)]++});
        }
        for (std::size_t i = 0; i < m_names.size(); ++i) {
            m_form.yarns[static_cast<std::size_t>(m_names[i].yarn)].loops.push_back(
                loopOf(static_cast<LoopIndex>(i)));
        }
    }

    FormLoop loopOf(LoopIndex index) const {
        const machine::Loop& made = m_fabric.made.loops[static_cast<std::size_t>(index)];
        const fabric::Loop& loop = m_fabric.loops[static_cast<std::size_t>(index)];
        FormLoop form{.needle = made.needle,
                      .direction = made.direction,
                      .kind = made.kind,
                      .bound = loop.bound,
                      .end = loop.end,
                      .onNeedle = loop.onNeedle,
                      .parents = {},
                      .through = {}};
        for (const LoopIndex parent : m_fabric.made.parentsOf(index)) {
            form.parents.push_back(nameOf(parent));
        }
        for (const LoopIndex child : m_fabric.drawnThrough(index)) {
            form.through.push_back(nameOf(child));
        }
        return form;
    }

    Stop stopOf(fabric::PointIndex p) {
        const fabric::BondingPoint& here = point(p);
        Stop stop{.loop = nameOf(here.loop),
                  .role = here.role,
                  .side = here.side,
                  .piece = here.piece,
                  .entry = -1,
                  .crossed = {},
                  .front = here.front};
        if (here.role == Role::Crossing) {
            const fabric::Crossing& crossing = m_fabric.crossings[static_cast<std::size_t>(here.crossing)];
            const fabric::BondingPoint& other = point(crossing.over == p ? crossing.under : crossing.over);
            stop.crossed = nameOf(other.loop);
            stop.crossedPiece = other.piece;
            stop.sign = crossing.sign;
        } else {
            stop.entry = m_entries.emplace(here.entry, static_cast<int>(m_entries.size())).first->second;
        }
        return stop;
    }

    const Fabric& m_fabric;
    FabricForm m_form;
    std::vector<std::size_t> m_order; ///< form's yarn -> fabric's yarn
    std::vector<LoopName> m_names;
    std::map<fabric::EntryIndex, int> m_entries;
};

Piece otherSide(Piece piece) {
    return piece == Piece::LeftLeg ? Piece::RightLeg : piece == Piece::RightLeg ? Piece::LeftLeg : piece;
}

void swapSides(Stop& stop) {
    if (stop.role != Role::Crossing || stop.piece != Piece::Float) {
        stop.side = stop.side == Side::Left ? Side::Right : Side::Left;
    }
    stop.piece = stop.role == Role::Crossing ? otherSide(stop.piece) : stop.piece;
    stop.crossedPiece = stop.role == Role::Crossing ? otherSide(stop.crossedPiece) : stop.crossedPiece;
}

void swapSides(FormLoop& loop) {
    loop.direction = machine::opposite(loop.direction);
    loop.needle.index = -loop.needle.index;
    loop.bound.index = -loop.bound.index;
}

const char* nameOf(Piece piece) {
    return piece == Piece::LeftLeg ? "left leg" : piece == Piece::RightLeg ? "right leg" : "float";
}

std::string textOf(const FabricForm& form, LoopName name) {
    return "loop " + std::to_string(name.place) + " of carrier " +
           std::to_string(form.yarns[static_cast<std::size_t>(name.yarn)].carrier + 1);
}

std::string textOf(const FabricForm& form, const Stop& stop) {
    const std::string side = stop.side == Side::Left ? "left" : "right";
    if (stop.role != Role::Crossing) {
        return side + (stop.role == Role::Foot ? " foot" : " head") + " in row " + std::to_string(stop.entry);
    }
    return std::string(nameOf(stop.piece)) + (stop.front > 0 ? " in front of " : " behind ") +
           nameOf(stop.crossedPiece) + " of " + textOf(form, stop.crossed) + (stop.sign > 0 ? " +" : " -");
}

std::string textOf(const FabricForm& form, const FormLoop& loop) {
    std::string text = std::string(machine::toString(loop.kind)) +
                       (loop.direction == machine::Direction::Right ? " + " : " - ") +
                       machine::toString(loop.needle) + ", then " + machine::toString(loop.bound) +
                       (loop.onNeedle ? " held" : "") +
                       (loop.end == fabric::Loop::End::Dropped ? " dropped" : "");
    for (const LoopName name : loop.parents) {
        text += ", of " + textOf(form, name);
    }
    for (const LoopName name : loop.through) {
        text += ", through it " + textOf(form, name);
    }
    return text;
}

} // namespace

FabricForm formOf(const Fabric& fabric) {
    return Former(fabric).run();
}

FabricForm mirrored(FabricForm form) {
    for (FormYarn& yarn : form.yarns) {
        std::ranges::for_each(yarn.loops, [](FormLoop& loop) { swapSides(loop); });
        for (Stop& stop : yarn.stops) {
            swapSides(stop);
            stop.sign = -stop.sign;
        }
    }
    return form;
}

FabricForm turnedOver(FabricForm form) {
    for (FormYarn& yarn : form.yarns) {
        for (FormLoop& loop : yarn.loops) {
            swapSides(loop);
            loop.needle.bed = otherBed(loop.needle.bed);
            loop.bound.bed = otherBed(loop.bound.bed);
        }
        for (Stop& stop : yarn.stops) {
            swapSides(stop);
            stop.front = -stop.front;
        }
    }
    return form;
}

FabricForm withoutMachine(FabricForm form) {
    for (FormYarn& yarn : form.yarns) {
        for (FormLoop& loop : yarn.loops) {
            const bool pulled = !loop.parents.empty();
            loop.needle = {pulled ? loop.needle.bed : Bed::Front, 0};
            loop.bound = {};
            loop.kind = machine::OperationKind::Knit;
        }
    }
    return form;
}

FabricForm withoutCrossings(FabricForm form) {
    for (FormYarn& yarn : form.yarns) {
        std::erase_if(yarn.stops, [](const Stop& stop) { return stop.role == Role::Crossing; });
    }
    return form;
}

FabricForm withoutFloats(FabricForm form) {
    for (FormYarn& yarn : form.yarns) {
        std::erase_if(yarn.stops, [](const Stop& stop) {
            return stop.role == Role::Crossing &&
                   (stop.piece == Piece::Float || stop.crossedPiece == Piece::Float);
        });
    }
    return form;
}

FabricForm withSortedCrossings(FabricForm form) {
    for (FormYarn& yarn : form.yarns) {
        auto first = yarn.stops.begin();
        while (first != yarn.stops.end()) {
            const auto last = std::find_if(first, yarn.stops.end(), [&](const Stop& stop) {
                return stop.role != Role::Crossing || stop.piece != first->piece || stop.loop != first->loop;
            });
            std::sort(first, last);
            first = last == first ? first + 1 : last;
        }
    }
    return form;
}

std::string difference(const FabricForm& a, const FabricForm& b) {
    if (a.yarns.size() != b.yarns.size()) {
        return std::to_string(a.yarns.size()) + " and " + std::to_string(b.yarns.size()) + " yarns";
    }
    for (std::size_t y = 0; y < a.yarns.size(); ++y) {
        const FormYarn& one = a.yarns[y];
        const FormYarn& two = b.yarns[y];
        const auto name = [&](int place) { return textOf(a, LoopName{static_cast<int>(y), place}); };
        if (one.carrier != two.carrier || one.loops.size() != two.loops.size()) {
            return "yarn " + std::to_string(y) + " has another carrier or number of loops";
        }
        for (std::size_t i = 0; i < one.loops.size(); ++i) {
            if (one.loops[i] != two.loops[i]) {
                return name(static_cast<int>(i)) + ": " + textOf(a, one.loops[i]) + "; against " +
                       textOf(b, two.loops[i]);
            }
        }
        for (std::size_t i = 0; i < std::max(one.stops.size(), two.stops.size()); ++i) {
            if (i >= one.stops.size() || i >= two.stops.size()) {
                return "yarn " + std::to_string(y) + " has " + std::to_string(one.stops.size()) + " and " +
                       std::to_string(two.stops.size()) + " points";
            }
            if (one.stops[i] != two.stops[i]) {
                return name(one.stops[i].loop.place) + ": " + textOf(a, one.stops[i]) + "; against " +
                       name(two.stops[i].loop.place) + ": " + textOf(b, two.stops[i]);
            }
        }
    }
    return {};
}

} // namespace knittsim::test
