#include "ui/views/simulation_panel/yarn_run_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <utility>

namespace knittsim::ui {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::ui", text);
}

QString millimetres(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

QString placeOf(const document::YarnShape& shape, machine::LoopIndex loop) {
    if (loop < 0) {
        return tr("a loose end");
    }
    const auto i = static_cast<std::size_t>(loop);
    return tr("%1 in course %2")
        .arg(QString::fromStdString(toString(shape.fabric->made.loops[i].needle)))
        .arg(shape.fabric->loops[i].course);
}

/// Whether yarn went through yarn, and where first.
QString passedText(const document::YarnShape& shape) {
    const simulation::YarnAudit& audit = shape.audit;
    if (audit.passThroughs() == 0) {
        return tr("No yarn went through another on the way");
    }
    const auto [loop, other] = audit.laidWrong.empty()
                                   ? std::pair(audit.passages.front().loop, audit.passages.front().other)
                                   : std::pair(audit.laidWrong.front().loop, audit.laidWrong.front().parent);
    return tr("%1 times yarn went through yarn, first at %2 and %3")
        .arg(audit.passThroughs())
        .arg(placeOf(shape, loop), placeOf(shape, other));
}

} // namespace

bool isAtRest(const document::YarnRun& run) {
    const auto shape = run.shape();
    return shape && shape->finished && physics::isAtRest(shape->verdict);
}

bool isBalanced(const document::YarnRun& run) {
    return isAtRest(run) && run.shape()->verdict == physics::StopRule::Verdict::ResidualReached;
}

QString yarnRunText(const document::YarnRun& run) {
    const auto shape = run.shape();
    if (!run.problem().isEmpty()) {
        return run.problem();
    }
    if (run.running()) {
        return !shape           ? tr("Laying the yarn")
               : shape->growing ? tr("The yarn grows")
                                : tr("Settling, step %1").arg(shape->steps);
    }
    if (!shape) {
        return {};
    }
    if (!isAtRest(run)) {
        return tr("Stopped");
    }
    return tr("%1 \u00d7 %2 mm a stitch")
        .arg(millimetres(shape->measured.waleSpacingMm, 2), millimetres(shape->measured.courseSpacingMm, 2));
}

QString yarnRunDetails(const document::YarnRun& run) {
    const auto shape = run.shape();
    if (run.running() || !shape || !shape->finished) {
        return {};
    }
    const geometry::Measurement& size = shape->measured;
    QString text = tr("At rest: wale spacing %1 mm, course spacing %2 mm, %3 \u00d7 %4 mm")
                       .arg(millimetres(size.waleSpacingMm, 3), millimetres(size.courseSpacingMm, 3),
                            millimetres(size.widthMm, 1), millimetres(size.heightMm, 1));
    const simulation::YarnAudit& audit = shape->audit;
    text += u'\n' + (audit.coreOverlaps == 0 ? tr("No yarn is inside another")
                                             : tr("%1 places where yarns overlap").arg(audit.coreOverlaps));
    text += u'\n' + passedText(*shape);
    return text;
}

QString settleYarnText(const document::YarnRun& run) {
    const bool stopped = run.exists() && !run.running() && run.shape() && !run.shape()->finished;
    return run.running() ? tr("Stop the yarn") : stopped ? tr("Go on as yarn") : tr("Settle as yarn");
}

QString surroundingsName(const simulation::SurroundingsInfo& info) {
    return QCoreApplication::translate("surroundings", info.name);
}

QString surroundingsPurpose(const simulation::SurroundingsInfo& info) {
    return QCoreApplication::translate("surroundings", info.purpose);
}

QString settleYarnHelp() {
    return tr(
        "Settle the whole fabric as real yarn, with thickness, bending and friction; up to a minute for a "
        "thousand stitches");
}

} // namespace knittsim::ui
