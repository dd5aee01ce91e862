#include "core/formats/kcode/carriage.h"

#include "core/formats/kcode/sizes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::formats::kcode {

using machine::Direction;
using passes::Cell;
using passes::Gripper;
using passes::Pass;
using passes::PassKind;
using passes::Work;

namespace {

constexpr double kEmptySpeed = 300;
constexpr int kNoSize = 0; ///< on a bed where no needle works

const char* nameOf(Work work) {
    return work == Work::Knit ? "Kn" : "Tu";
}

/// "Tr" for the bed that gives, "Rl" or "Rr" for the one that receives.
std::string transferType(bool fromFront, Direction direction) {
    const std::string receives = direction == Direction::Right ? "Rr" : "Rl";
    return fromFront ? "Tr-" + receives : receives + "-Tr";
}

std::string typeOf(const Pass& pass, Direction direction) {
    if (pass.frontWork == Work::Split || pass.rearWork == Work::Split) {
        return transferType(pass.frontWork == Work::Split, direction);
    }
    const Work front = pass.frontWork == Work::None ? pass.rearWork : pass.frontWork;
    const Work rear = pass.rearWork == Work::None ? pass.frontWork : pass.rearWork;
    return std::string(nameOf(front)) + '-' + nameOf(rear);
}

} // namespace

int Carriage::rearNeedle(int slot, double rack) const {
    return slot - static_cast<int>(std::floor(rack)) + m_offset;
}

void Carriage::add(const Pass& pass, int carrier) {
    if (pass.kind == PassKind::Transfer) {
        addTransfers(pass);
    } else {
        addStitches(pass, carrier);
    }
}

/// An empty stroke when the carriage is on the wrong side.
void Carriage::turn(Direction direction) {
    if (m_next == direction) {
        return;
    }
    Stroke stroke;
    stroke.front = stroke.rear = std::string(kNeedles, kRests);
    stroke.frontSizes = stroke.rearSizes = std::string(kNeedles + 2 * kMargin, signOf(0));
    stroke.rack = m_rack;
    stroke.direction = m_next;
    stroke.carriageLeft = m_left;
    stroke.carriageRight = m_right;
    stroke.speed = kEmptySpeed;
    stroke.comment = "automatically inserted carriage move";
    push(std::move(stroke));
}

void Carriage::push(Stroke stroke) {
    m_next = opposite(stroke.direction);
    m_strokes.push_back(std::move(stroke));
}

/// The stroke begins where the one before ended, or further out, which then ends there too. It ends where its
/// own work does.
void Carriage::setStops(Stroke& stroke, double left, double right) {
    if (stroke.direction == Direction::Left) {
        m_right = std::max(m_right, right);
        if (!m_strokes.empty()) {
            m_strokes.back().carriageRight = m_right;
        }
        m_left = left;
    } else {
        m_left = std::min(m_left, left);
        if (!m_strokes.empty()) {
            m_strokes.back().carriageLeft = m_left;
        }
        m_right = right;
    }
    stroke.carriageLeft = m_left;
    stroke.carriageRight = m_right;
}

/// `stop`, or the next place beyond it where no other carrier stands.
double Carriage::freeStop(int carrier, double stop, double step) const {
    const auto taken = [&] {
        for (int other = 1; other <= kCarriers; ++other) {
            if (other != carrier && m_carriers[static_cast<std::size_t>(other - 1)] == stop) {
                return true;
            }
        }
        return false;
    };
    while (taken()) {
        stop += step;
    }
    return stop;
}

void Carriage::placeCarrier(Stroke& stroke, const Pass& pass, int carrier) {
    const auto index = static_cast<std::size_t>(carrier - 1);
    stroke.carrier = carrier;
    if (stroke.direction == Direction::Left) {
        stroke.carrierRight = m_carriers[index];
        const double stop = frontNeedle(pass.firstSlot()) - m_spacing.distance;
        stroke.carrierLeft =
            pass.gripper == Gripper::Out ? kParking[index] : freeStop(carrier, stop, -m_spacing.carriers);
        m_carriers[index] = stroke.carrierLeft;
    } else {
        stroke.carrierLeft = m_carriers[index];
        const double stop = frontNeedle(pass.lastSlot()) + m_spacing.distance;
        stroke.carrierRight = freeStop(carrier, stop, m_spacing.carriers);
        m_carriers[index] = stroke.carrierRight;
    }
}

void Carriage::addStitches(const Pass& pass, int carrier) {
    Stroke stroke;
    m_rack = stroke.rack = pass.rack;
    stroke.speed = pass.speed;
    stroke.roller = pass.roller;
    stroke.message = pass.message;
    stroke.direction = pass.direction.value_or(m_next);
    stroke.type = typeOf(pass, stroke.direction);
    if (pass.frontWork == Work::None && pass.rearWork == Work::None) {
        stroke.comment = "(decayed from a SOFT_MISS)";
    }
    if (pass.gripper == Gripper::Out) {
        stroke.comment += kCarrierOut;
    }
    double left = frontNeedle(pass.firstSlot()) - m_spacing.distance;
    double right = frontNeedle(pass.lastSlot()) + m_spacing.distance;
    if (carrier != 0) {
        placeCarrier(stroke, pass, carrier);
        left = std::min(left, stroke.carrierLeft);
        right = std::max(right, stroke.carrierRight);
    }
    turn(stroke.direction);
    setStops(stroke, left, right);
    SizeLine front;
    SizeLine rear;
    for (const auto& [slot, cell] : pass.cells) {
        const bool splits = cell.front == Work::Split || cell.rear == Work::Split;
        if (cell.front != Work::None || splits) {
            stroke.front[static_cast<std::size_t>(frontNeedle(slot))] = kWorks;
        }
        if (cell.rear != Work::None || splits) {
            stroke.rear[static_cast<std::size_t>(rearNeedle(slot, pass.rack))] = kWorks;
        }
    }
    for (const auto& [slot, sizes] : pass.sizes) {
        front.set(frontNeedle(slot), sizes.front);
        rear.set(rearNeedle(slot, pass.rack), sizes.rear);
    }
    stroke.frontSizes = front.text(stroke.direction, kNoSize);
    stroke.rearSizes = rear.text(stroke.direction, kNoSize);
    push(std::move(stroke));
}

void Carriage::addTransfers(const Pass& pass) {
    m_message = pass.message;
    for (const bool fromFront : {true, false}) {
        std::vector<int> all;
        std::vector<int> even;
        std::vector<int> odd;
        for (const auto& [slot, cell] : pass.cells) {
            if ((fromFront ? cell.front : cell.rear) == Work::Transfer) {
                (all.size() % 2 == 0 ? even : odd).push_back(slot);
                all.push_back(slot);
            }
        }
        if (!pass.fourPasses) {
            transferStroke(pass, fromFront, all, fromFront ? "[front-to-back]" : "[back-to-front]");
            continue;
        }
        transferStroke(pass, fromFront, even, fromFront ? "[front-to-back, even]" : "[back-to-front, even]");
        transferStroke(pass, fromFront, odd, fromFront ? "[front-to-back, odd]" : "[back-to-front, odd]");
    }
}

void Carriage::transferStroke(const Pass& pass, bool fromFront, const std::vector<int>& slots,
                              const char* comment) {
    if (slots.empty()) {
        return;
    }
    Stroke stroke;
    stroke.rack = pass.rack;
    stroke.speed = pass.speed;
    stroke.roller = pass.roller;
    stroke.message = std::exchange(m_message, {});
    stroke.direction = m_next;
    stroke.type = transferType(fromFront, m_next);
    stroke.comment = comment;
    SizeLine front;
    SizeLine rear;
    for (const int slot : slots) {
        stroke.front[static_cast<std::size_t>(frontNeedle(slot))] = kWorks;
        stroke.rear[static_cast<std::size_t>(rearNeedle(slot, pass.rack))] = kWorks;
        front.set(frontNeedle(slot), pass.sizes.at(slot).front);
        rear.set(rearNeedle(slot, pass.rack), pass.sizes.at(slot).rear);
    }
    stroke.frontSizes = front.text(stroke.direction, kNoSize);
    stroke.rearSizes = rear.text(stroke.direction, kNoSize);
    const auto needle = [&](int slot) { return fromFront ? frontNeedle(slot) : rearNeedle(slot, pass.rack); };
    setStops(stroke, needle(slots.front()) - m_spacing.distance, needle(slots.back()) + m_spacing.distance);
    push(std::move(stroke));
}

} // namespace knittsim::formats::kcode
