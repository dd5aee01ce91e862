#pragma once

#include "core/pattern/feeds.h"
#include "core/pattern/held_loops.h"
#include "core/pattern/program_course.h"

namespace knittsim::pattern {

/// Knits a course by its program (ProgramCourse), with the cells that were changed in their places.
class ProgramWorks {
public:
    ProgramWorks(const Chart& chart, int course, Feeds& feeds, HeldLoops& held, ProgramBuilder& builder);

    /// Brings loops to the beds, yarns in or out and the racking to what the program begins with: nothing to
    /// do unless courses below were changed.
    void meetProgram();
    void knit();

private:
    /// Operations [first, end) of one yarn in one direction.
    struct Pass {
        std::size_t first = 0;
        std::size_t end = 0;
        machine::Direction direction = machine::Direction::Right;
        std::vector<int> added; ///< wales that were changed and are knitted in this pass
    };

    bool isChanged(int wale) const;
    std::vector<Pass> passesOf(int yarn) const;
    Pass* passFor(std::vector<Pass>& passes, int wale) const;
    void placeChanged();
    void prepare(int wale);
    void work(int wale, machine::Direction direction);
    void append(const machine::Operation& operation);
    void takeStitchNumber();
    void carryOut(std::size_t index);
    void knitAlone();

    const Chart& m_chart;
    int m_course;
    const ProgramCourse& m_program;
    Feeds& m_feeds;
    HeldLoops& m_held;
    ProgramBuilder& m_builder;
    double m_rack = 0;                         ///< of the program
    std::size_t m_ownNumber = 0;               ///< operation that sets the stitch number, or their count
    std::vector<std::vector<int>> m_prepareAt; ///< by operation: wales whose loops change beds before it
    std::vector<std::vector<int>> m_workAt;    ///< by operation: wales worked before it, its way
    std::vector<std::vector<int>> m_endAt;     ///< the same, the way of the operation before
    std::vector<int> m_alone;                  ///< wales whose yarn has no pass in the program
};

} // namespace knittsim::pattern
