// What the beds can do: racking, needles, sliders and the stitch table.

#include "core/machine/checks/groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace knittsim::machine {

namespace {

constexpr double kRackTolerance = 1e-6; // pitches

bool hasNeedle(OperationKind kind) {
    return carriesYarn(kind) || kind == OperationKind::Drop || kind == OperationKind::Xfer;
}

bool hasTarget(OperationKind kind) {
    return kind == OperationKind::Xfer || kind == OperationKind::Split;
}

class NeedleCheck : public CheckGroup {
public:
    NeedleCheck(const Timeline& timeline, Findings& findings)
        : CheckGroup(timeline, findings), m_width(m_program.header.width.value_or(m_profile.needlesPerBed)),
          m_keep(m_program.header.position == "Keep") {}

    void before(const Operation& op, const MachineState& state) override {
        if (op.kind == OperationKind::Rack) {
            checkRack(op.value);
        } else if (op.kind == OperationKind::StitchNumber || op.kind == OperationKind::StitchSize) {
            checkSize(op.value);
        } else if (hasNeedle(op.kind)) {
            checkPlace(op.needle);
            if (hasTarget(op.kind)) {
                checkPlace(op.target);
            }
            checkSliders(op);
            checkEmpty(op, state);
        }
    }

    void loopsMoved(Needle from, Needle to, std::span<const LoopIndex> loops) override {
        m_onSliders -= isSlider(from.bed) ? loops.size() : 0;
        m_onSliders += isSlider(to.bed) ? loops.size() : 0;
        m_toldSliders = m_toldSliders && m_onSliders > 0;
    }

    void loopsDropped(Needle from, std::span<const LoopIndex> loops) override {
        m_onSliders -= isSlider(from.bed) ? loops.size() : 0;
        m_toldSliders = m_toldSliders && m_onSliders > 0;
    }

private:
    void checkRack(double rack) {
        if (rack < m_profile.minRack || rack > m_profile.maxRack) {
            m_findings.report("KS0218",
                              {fmt::format("{}", rack), m_profile.name, fmt::format("{}", m_profile.minRack),
                               fmt::format("{}", m_profile.maxRack)});
        }
        const double part = rack - std::floor(rack);
        const bool allowed = std::ranges::any_of(m_profile.rackFractions, [&](double fraction) {
            return std::abs(part - fraction) < kRackTolerance ||
                   std::abs(part - fraction - 1) < kRackTolerance;
        });
        if (!allowed) {
            m_findings.report("KS0219", {fmt::format("{}", rack), m_profile.name,
                                         fmt::format("{}", fmt::join(m_profile.rackFractions, ", "))});
        }
    }

    void checkSize(double size) {
        const auto& table = m_profile.stitchTable;
        if (!table.empty() && (size < table.front().first || size > table.back().first)) {
            m_findings.report("KS0239", {fmt::format("{}", size), m_profile.name,
                                         fmt::format("{}", table.front().first),
                                         fmt::format("{}", table.back().first)});
        }
    }

    /// Needle numbers count only with ';;Position: Keep'; else the piece is moved to where it fits. Machines
    /// count from 0 or from 1.
    void checkPlace(Needle needle) {
        if (m_keep) {
            if (needle.index < 0 || needle.index > m_width) {
                m_findings.report("KS0220",
                                  {toString(needle), fmt::format("the piece stays where it is written and "
                                                                 "there are {} needles",
                                                                 m_width)},
                                  needle);
            }
            return;
        }
        if (!m_any) {
            m_any = true;
            m_least = m_most = needle.index;
        }
        const bool wider = needle.index < m_least || needle.index > m_most;
        m_least = std::min(m_least, needle.index);
        m_most = std::max(m_most, needle.index);
        if (wider && m_most - m_least >= m_width) {
            m_findings.report("KS0220",
                              {toString(needle), fmt::format("the piece is {} needles wide, there are {}",
                                                             m_most - m_least + 1, m_width)},
                              needle);
        }
    }

    void checkSliders(const Operation& op) {
        const bool two = hasTarget(op.kind);
        if (!m_profile.sliders && (isSlider(op.needle.bed) || (two && isSlider(op.target.bed)))) {
            const Needle slider = isSlider(op.needle.bed) ? op.needle : op.target;
            m_findings.report("KS0221", {toString(slider), m_profile.name}, slider);
        } else if (two && isSlider(op.needle.bed) && isSlider(op.target.bed)) {
            m_findings.report("KS0222", {toString(op.needle), toString(op.target)}, op.needle);
        }
        if (makesLoop(op.kind) && m_onSliders > 0 && !m_toldSliders) {
            m_toldSliders = true; // until they are free again
            m_findings.report("KS0223", {toString(op.needle), loopsText(m_onSliders)}, op.needle);
        }
    }

    void checkEmpty(const Operation& op, const MachineState& state) {
        const bool takes = op.kind == OperationKind::Drop || op.kind == OperationKind::Xfer;
        if (takes && state.loopsOn(op.needle).empty()) {
            m_findings.reportRun("KS0224", {toString(op.needle)}, op.needle);
        }
    }

    std::int32_t m_width;
    bool m_keep;
    bool m_any = false;
    std::int32_t m_least = 0;
    std::int32_t m_most = 0;
    std::size_t m_onSliders = 0;
    bool m_toldSliders = false;
};

} // namespace

std::unique_ptr<CheckGroup> makeNeedleCheck(const Timeline& timeline, Findings& findings) {
    return std::make_unique<NeedleCheck>(timeline, findings);
}

} // namespace knittsim::machine
