#pragma once

#include "core/base/diagnostic.h"
#include "core/machine/profile.h"
#include "core/pattern/course_works.h"

#include <vector>

namespace knittsim::pattern {

/// The yarns of a chart on their carriers: they come in with their first pass, which goes to the left, and
/// every later pass goes away from the side where the carrier stands.
class Feeds {
public:
    /// Errors go to `problems`: KS0008 for a carrier that the machine has not, KS0505 for one given to two
    /// yarns.
    Feeds(const Chart& chart, const machine::MachineProfile& machine, Diagnostics& problems);

    machine::CarrierIndex carrier(int yarn) const { return at(yarn).carrier; }
    /// Direction of the yarn's next pass.
    machine::Direction next(int yarn) const { return at(yarn).next; }

    /// One pass; `works` from left to right whatever way it goes.
    void pass(int yarn, std::vector<Work> works, ProgramBuilder& builder);
    /// Frees the inserting hook where the yarn still hangs in it.
    void release(int yarn, ProgramBuilder& builder);
    /// Takes out the yarns whose last course this was, but for `kept`.
    void takeOut(int course, ProgramBuilder& builder, const std::vector<int>& kept = {});

    /// Remembers what an operation does; its carriers are yarns of the chart.
    void follow(const machine::Operation& operation);
    bool isIn(int yarn) const { return at(yarn).in; }
    /// Takes a yarn in or out where it is not so already.
    void bring(int yarn, bool in, ProgramBuilder& builder);
    int count() const { return static_cast<int>(m_feeds.size()); }
    /// Carriers of the machine for yarns of the chart.
    machine::CarrierSet carriersOf(const machine::CarrierSet& yarns) const;

private:
    struct Feed {
        machine::CarrierIndex carrier = 0;
        int lastCourse = -1;
        bool in = false;
        bool onHook = false;
        machine::Direction next = machine::Direction::Left;
    };

    Feed& at(int yarn) { return m_feeds[static_cast<std::size_t>(yarn)]; }
    const Feed& at(int yarn) const { return m_feeds[static_cast<std::size_t>(yarn)]; }

    bool m_hook;               ///< the machine has an inserting hook
    std::vector<Feed> m_feeds; ///< by chart yarn
};

} // namespace knittsim::pattern
