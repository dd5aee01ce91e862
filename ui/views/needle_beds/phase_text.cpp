#include "ui/views/needle_beds/phase_text.h"

#include "core/machine/needle_stroke.h"

#include <QCoreApplication>

namespace knittsim::ui {

namespace {

using machine::OperationKind;
using namespace machine::phase;

QString tr(const char* text) {
    return QCoreApplication::translate("phases", text);
}

QString stitchText(OperationKind kind, double t) {
    const bool tuck = kind == OperationKind::Tuck;
    if (t < kArrived) {
        return tr("The carriage comes");
    }
    if (t < kRisen) {
        return tuck ? tr("The needle rises half: the old loop stays on the latch")
                    : tr("The needle rises: the old loop slides behind the latch");
    }
    if (t < kSinks) {
        return tr("The carrier lays the yarn into the hook");
    }
    if (t < kKnockOver) {
        return tuck ? tr("The needle sinks: both loops lie in the hook")
                    : tr("The needle sinks: the old loop shuts the latch");
    }
    return tuck ? tr("Tuck: the old loop is kept") : tr("Knock-over: the old loop hangs in the new one");
}

QString transferText(bool split, double t) {
    if (t < kArrived) {
        return tr("The carriage comes");
    }
    if (t < kRisen) {
        return tr("The needle lifts its loop high");
    }
    if (t < kHandOver) {
        return split && t < kSinks ? tr("The other needle enters the loop, the yarn is laid")
                                   : tr("The other needle enters the loop");
    }
    return t < kHandedOver ? tr("The first needle sinks and leaves the loop to the other")
                           : tr("The loop hangs on the other bed");
}

QString dropText(double t) {
    if (t < kSinks) {
        return tr("The needle rises and gets no yarn");
    }
    return t < kKnockOver ? tr("The needle sinks: the loop shuts the latch") : tr("The loop falls off");
}

} // namespace

QString phaseText(const machine::Operation& operation, double phase) {
    if (phase <= 0 || phase >= 1) {
        return {};
    }
    switch (operation.kind) {
    case OperationKind::Knit:
    case OperationKind::Tuck:
        return stitchText(operation.kind, phase);
    case OperationKind::Xfer:
    case OperationKind::Split:
        return transferText(operation.kind == OperationKind::Split, phase);
    case OperationKind::Drop:
        return dropText(phase);
    case OperationKind::Miss:
        return tr("The carrier passes, the needle stays down");
    case OperationKind::Rack:
        return tr("The rear bed moves");
    default:
        return {};
    }
}

} // namespace knittsim::ui
