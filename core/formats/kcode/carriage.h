#pragma once

#include "core/formats/kcode/layout.h"
#include "core/formats/passes/pass.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace knittsim::formats::kcode {

/// One stroke of the carriage. Stops are in needles from the first one of the front bed, always at a half.
struct Stroke {
    std::string front = std::string(kWrittenNeedles, kRests);
    std::string rear = std::string(kWrittenNeedles, kRests);
    std::string frontSizes;
    std::string rearSizes;
    double rack = 0;
    machine::Direction direction = machine::Direction::Right;
    std::string type = "Kn-Kn";
    int carrier = 0; ///< 1 to 6, 0 for none
    double carrierLeft = 0;
    double carrierRight = 0;
    double carriageLeft = 0;
    double carriageRight = 0;
    double speed = 0;
    double roller = 0;
    std::string comment;
    std::string message;
};

/// How far from the last needle a carrier stops and how far from each other carriers stand.
struct Spacing {
    double distance = 2.5;
    double carriers = 2;
};

/// Turns passes into strokes: every other one goes left, carriers stop beside their last needle and not where
/// another one stands, the carriage goes at least as far as its carrier.
class Carriage {
public:
    /// `offset` makes needles of slots: needle = slot + offset, counted from 0.
    Carriage(int offset, const Spacing& spacing) : m_offset(offset), m_spacing(spacing) {}

    /// `carrier` is 1 to 6, or 0 for a pass without yarn.
    void add(const passes::Pass& pass, int carrier);

    const std::vector<Stroke>& strokes() const { return m_strokes; }

private:
    void addStitches(const passes::Pass& pass, int carrier);
    void addTransfers(const passes::Pass& pass);
    void transferStroke(const passes::Pass& pass, bool fromFront, const std::vector<int>& slots,
                        const char* comment);
    void placeCarrier(Stroke& stroke, const passes::Pass& pass, int carrier);
    double freeStop(int carrier, double stop, double step) const;
    void turn(machine::Direction direction);
    void setStops(Stroke& stroke, double left, double right);
    void push(Stroke stroke);

    int frontNeedle(int slot) const { return slot + m_offset; }
    int rearNeedle(int slot, double rack) const;

    int m_offset;
    Spacing m_spacing;
    std::vector<Stroke> m_strokes;
    std::array<double, kCarriers> m_carriers = kParking; ///< where they stand
    machine::Direction m_next = machine::Direction::Right;
    double m_left = -11.5; ///< where the carriage stops
    double m_right = kNeedles - 1 + 11.5;
    std::string m_message; ///< shown before the next stroke of transfers
    double m_rack = 0;     ///< of the last stroke with stitches
};

} // namespace knittsim::formats::kcode
