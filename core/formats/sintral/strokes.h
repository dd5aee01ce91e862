#pragma once

#include "core/formats/program_sink.h"
#include "core/formats/sintral/command.h"
#include "core/formats/sintral/jacquard.h"

#include <map>
#include <optional>
#include <set>

namespace knittsim::formats::sintral {

/// What one line asks of the carriage.
struct Stroke {
    bool wanted = false; ///< the line is a stroke
    bool empty = false;  ///< S0
    bool named = false;  ///< systems are named
    int systems = 0;
    std::optional<machine::Direction> direction;
    int rack = 0; ///< needles to the right
    double fraction = 0.25;
};

/// The knitting machine while a program runs: cycles of systems and carriers, jacquard row, needle range.
/// Turns strokes into operations. Reports KS0108, KS0152, KS0154, KS0155 to KS0159.
class StrokeWriter {
public:
    /// All must outlive the writer.
    StrokeWriter(const Jacquard& jacquard, ProgramSink& sink, Problems& problems)
        : m_jacquard(jacquard), m_sink(sink), m_problems(problems) {}

    void setSystems(const SystemList& systems);
    void setCarriers(std::vector<int> numbers);
    void setHomes(const Command& homes);
    void setRange(int first, int last) { m_range = {first, last}; }
    void setField(int first, int last) { m_field = {first, last}; }
    void placeField(int needle) { m_fieldNeedle = needle; }
    void setStitchValue(int entry, double value) { m_stitchValues[entry] = value; }
    bool startJacquard(int which, int line, Spot spot);
    bool useJacquard(int which, Spot spot);

    /// False when it cannot be carried out.
    bool carryOut(const Stroke& stroke, Spot spot);

    /// Takes out the carriers that are in.
    void finish();

    /// Numbers of the carriers that were used.
    const std::set<int>& usedCarriers() const { return m_used; }
    bool parksRight(int carrier) const { return m_rightHomes.count(carrier) != 0; }

private:
    struct Span {
        int first = 1;
        int last = 0;
    };

    bool turn(const Stroke& stroke, Spot spot);
    bool goToRow(Spot spot);
    bool prepare(const SystemEntry& entry, Spot spot);
    bool workSystem(const SystemEntry& entry, int carrier, const Stroke& stroke, Spot spot);
    void stitches(const SystemEntry& entry, int carrier, const Stroke& stroke);
    bool transfers(const SystemEntry& entry, const Stroke& stroke, Spot spot);
    void workNeedle(const Selection& selection, bool front, int index, int carrier,
                    machine::Direction direction);
    void setStitch(const Selection& selection);
    bool comeIn(int carrier, Spot spot);
    Need need(const Selection& selection, int needle) const;
    char symbolAt(int needle) const;

    const Jacquard& m_jacquard;
    ProgramSink& m_sink;
    Problems& m_problems;

    std::vector<SystemEntry> m_systems;
    std::size_t m_nextSystem = 0;
    int m_rowStep = 0;
    std::vector<int> m_carriers;
    std::size_t m_nextCarrier = 0;
    std::set<int> m_homes;
    std::set<int> m_rightHomes;
    bool m_knowsHomes = false;
    std::set<int> m_in;
    std::set<int> m_used;
    std::optional<Span> m_range;
    std::optional<Span> m_field;
    std::optional<int> m_fieldNeedle;
    std::map<int, double> m_stitchValues;
    std::set<int> m_saidStitches;
    std::map<int, int> m_starts; ///< rows of the jacquards
    int m_which = 1;
    int m_row = -1; ///< -1: before the start row
    machine::Direction m_next = machine::Direction::Left;
    long long m_passed = 0; ///< needles
    Span m_area;            ///< needles of the present stroke
};

} // namespace knittsim::formats::sintral
