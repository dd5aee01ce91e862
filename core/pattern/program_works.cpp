#include "core/pattern/program_works.h"

#include <algorithm>

namespace knittsim::pattern {

using machine::Bed;
using machine::Direction;
using machine::Operation;
using machine::OperationKind;

ProgramWorks::ProgramWorks(const Chart& chart, int course, Feeds& feeds, HeldLoops& held,
                           ProgramBuilder& builder)
    : m_chart(chart), m_course(course), m_program(*chart.course(course).program), m_feeds(feeds),
      m_held(held), m_builder(builder), m_rack(m_program.rack), m_prepareAt(m_program.operations.size() + 1),
      m_workAt(m_program.operations.size() + 1), m_endAt(m_program.operations.size() + 1) {}

bool ProgramWorks::isChanged(int wale) const {
    return m_program.cells[static_cast<std::size_t>(wale)] != m_chart.at(wale, m_course);
}

void ProgramWorks::meetProgram() {
    for (int wale = 0; wale < m_chart.width; ++wale) {
        const unsigned wanted = m_program.loops[static_cast<std::size_t>(wale)];
        const bool front = (wanted & 1U) != 0;
        const bool rear = (wanted & 2U) != 0;
        if (front != rear) {
            m_held.toBed(wale, front ? Bed::Front : Bed::Rear, m_builder);
        }
    }
    for (int yarn = 0; yarn < m_feeds.count(); ++yarn) {
        m_feeds.bring(yarn, std::ranges::binary_search(m_program.in, static_cast<std::uint8_t>(yarn)),
                      m_builder);
    }
    m_builder.rack(m_program.rack);
}

std::vector<ProgramWorks::Pass> ProgramWorks::passesOf(int yarn) const {
    std::vector<Pass> passes;
    const std::vector<Operation>& operations = m_program.operations;
    for (std::size_t i = 0; i < operations.size(); ++i) {
        const Operation& op = operations[i];
        if (!machine::carriesYarn(op.kind) ||
            !op.carriers.contains(static_cast<machine::CarrierIndex>(yarn))) {
            continue;
        }
        if (!passes.empty() && passes.back().end == i && passes.back().direction == op.direction) {
            ++passes.back().end;
        } else {
            passes.push_back({i, i + 1, op.direction, {}});
        }
    }
    return passes;
}

/// The last pass over the wale, else the last one: the first may be a cast-on.
ProgramWorks::Pass* ProgramWorks::passFor(std::vector<Pass>& passes, int wale) const {
    const auto over = [&](const Pass& pass) {
        const int a = m_program.operations[pass.first].needle.index;
        const int b = m_program.operations[pass.end - 1].needle.index;
        return wale >= std::min(a, b) - 1 && wale <= std::max(a, b) + 1;
    };
    const auto found = std::find_if(passes.rbegin(), passes.rend(), over);
    return passes.empty() ? nullptr : found != passes.rend() ? &*found : &passes.back();
}

void ProgramWorks::placeChanged() {
    std::vector<std::vector<Pass>> byYarn(m_chart.yarns.size());
    for (int wale = 0; wale < m_chart.width; ++wale) {
        const Cell& cell = m_chart.at(wale, m_course);
        if (!isChanged(wale) || !isWorked(cell.stitch)) {
            continue;
        }
        std::vector<Pass>& passes = byYarn[cell.yarn];
        if (passes.empty()) {
            passes = passesOf(cell.yarn);
        }
        if (Pass* pass = passFor(passes, wale)) {
            pass->added.push_back(wale);
        } else {
            m_alone.push_back(wale);
        }
    }
    for (std::vector<Pass>& passes : byYarn) {
        for (Pass& pass : passes) {
            const int way = sign(pass.direction);
            std::ranges::sort(pass.added, {}, [&](int wale) { return way * wale; });
            std::size_t at = pass.first;
            for (const int wale : pass.added) {
                m_prepareAt[pass.first].push_back(wale);
                while (at < pass.end && way * m_program.operations[at].needle.index <= way * wale) {
                    ++at;
                }
                (at == pass.end ? m_endAt : m_workAt)[at].push_back(wale);
            }
        }
    }
}

void ProgramWorks::prepare(int wale) {
    const Stitch stitch = m_chart.at(wale, m_course).stitch;
    if (m_chart.beds == BedUse::Single && (stitch == Stitch::Knit || stitch == Stitch::Purl)) {
        m_held.toBed(wale, stitch == Stitch::Purl ? Bed::Rear : Bed::Front, m_builder);
        m_builder.rack(m_rack);
    }
}

void ProgramWorks::work(int wale, Direction direction) {
    const Cell& cell = m_chart.at(wale, m_course);
    std::vector<Work> works = worksOf(cell, wale, loopBedOf(m_chart, m_held, wale));
    if (direction == Direction::Left) {
        std::ranges::reverse(works);
    }
    for (const Work& one : works) {
        m_builder.work(one.kind, direction, one.needle, m_feeds.carrier(cell.yarn));
        if (makesLoop(one.kind)) {
            m_held.add(one.needle);
        }
    }
}

void ProgramWorks::append(const Operation& operation) {
    const std::string text =
        operation.text >= 0 ? m_program.texts[static_cast<std::size_t>(operation.text)] : std::string();
    if (operation.kind == OperationKind::Rack) {
        m_rack = operation.value;
    }
    m_builder.append(operation, m_feeds.carriersOf(operation.carriers), text);
    m_feeds.follow(operation);
    m_held.apply(operation);
}

/// The chart's stitch number takes the place of the program's first.
void ProgramWorks::takeStitchNumber() {
    const std::vector<Operation>& operations = m_program.operations;
    const auto own = std::ranges::find(operations, OperationKind::StitchNumber, &Operation::kind);
    m_ownNumber = static_cast<std::size_t>(own - operations.begin());
    const std::optional<double> number = m_chart.course(m_course).stitchNumber;
    if (number && own == operations.end()) {
        m_builder.stitchNumber(*number);
    }
}

void ProgramWorks::carryOut(std::size_t index) {
    Operation op = m_program.operations[index];
    if (index == m_ownNumber) {
        op.value = m_chart.course(m_course).stitchNumber.value_or(op.value);
    }
    const int wale = op.needle.index;
    if (machine::carriesYarn(op.kind) && wale >= 0 && wale < m_chart.width && isChanged(wale)) {
        m_feeds.follow(op);
    } else {
        append(op);
    }
}

void ProgramWorks::knitAlone() {
    for (int yarn = 0; yarn < m_feeds.count(); ++yarn) {
        std::vector<Work> works;
        for (const int wale : m_alone) {
            if (m_chart.at(wale, m_course).yarn == yarn) {
                prepare(wale);
                const std::vector<Work> own =
                    worksOf(m_chart.at(wale, m_course), wale, loopBedOf(m_chart, m_held, wale));
                works.insert(works.end(), own.begin(), own.end());
            }
        }
        for (const Work& work : works) {
            if (makesLoop(work.kind)) {
                m_held.add(work.needle);
            }
        }
        if (!works.empty()) {
            m_feeds.pass(yarn, std::move(works), m_builder);
            m_feeds.release(yarn, m_builder);
        }
    }
}

void ProgramWorks::knit() {
    placeChanged();
    takeStitchNumber();
    Direction direction = Direction::Right;
    const std::size_t count = m_program.operations.size();
    for (std::size_t i = 0; i <= count; ++i) {
        for (const int wale : m_endAt[i]) {
            work(wale, direction);
        }
        for (const int wale : m_prepareAt[i]) {
            prepare(wale);
        }
        if (i == count) {
            break;
        }
        const Operation& op = m_program.operations[i];
        direction = machine::carriesYarn(op.kind) ? op.direction : direction;
        for (const int wale : m_workAt[i]) {
            work(wale, direction);
        }
        carryOut(i);
    }
    knitAlone();
}

} // namespace knittsim::pattern
