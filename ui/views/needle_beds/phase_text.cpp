#include "ui/views/needle_beds/phase_text.h"

#include "core/machine/needle_stroke.h"

#include <QCoreApplication>

namespace knittsim::ui {

namespace {

using machine::OperationKind;
using namespace machine::phase;

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::ui", text);
}

/// On an empty needle the yarn is just hung up.
QString hangText(double t) {
    if (t < kArrived) {
        return tr("The carriage comes");
    }
    if (t < kRisen) {
        return tr("The empty needle rises");
    }
    return t < kSinks ? tr("The carrier lays the yarn into the hook")
                      : tr("The needle sinks with its first loop");
}

QString knitText(double t) {
    if (t < kArrived) {
        return tr("The carriage comes");
    }
    if (t < kRisen) {
        return tr("The needle rises: the old loop slides behind the latch");
    }
    if (t < kSinks) {
        return tr("The carrier lays the yarn into the hook");
    }
    return t < kKnockOver ? tr("The needle sinks: the old loop shuts the latch")
                          : tr("Knock-over: the old loop hangs in the new one");
}

QString tuckText(double t) {
    if (t < kArrived) {
        return tr("The carriage comes");
    }
    if (t < kRisen) {
        return tr("The needle rises half: the old loop stays on the latch");
    }
    if (t < kSinks) {
        return tr("The carrier lays the yarn into the hook");
    }
    return t < kKnockOver ? tr("The needle sinks: both loops lie in the hook")
                          : tr("Tuck: the old loop is kept");
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
    if (t < kHandedOver) {
        return tr("The first needle sinks and leaves the loop to the other");
    }
    return split ? tr("The old loop hangs on the other bed, the new one on its own")
                 : tr("The loop hangs on the other bed");
}

QString dropText(double t) {
    if (t < kArrived) {
        return tr("The carriage comes");
    }
    if (t < kSinks) {
        return tr("The needle rises and gets no yarn");
    }
    return t < kKnockOver ? tr("The needle sinks: the loop shuts the latch") : tr("The loop falls off");
}

QString emptyText(OperationKind kind, double t) {
    switch (kind) {
    case OperationKind::Knit:
    case OperationKind::Tuck:
    case OperationKind::Split:
        return hangText(t);
    default:
        return tr("The needle holds no loop");
    }
}

} // namespace

QString phaseText(const machine::Operation& operation, double phase, bool holdsLoop) {
    if (phase <= 0 || phase >= 1) {
        return {};
    }
    switch (operation.kind) {
    case OperationKind::Miss:
        return tr("The carrier passes, the needle stays down");
    case OperationKind::Rack:
        return tr("The rear bed moves");
    case OperationKind::Knit:
        return holdsLoop ? knitText(phase) : emptyText(operation.kind, phase);
    case OperationKind::Tuck:
        return holdsLoop ? tuckText(phase) : emptyText(operation.kind, phase);
    case OperationKind::Xfer:
    case OperationKind::Split:
        return holdsLoop ? transferText(operation.kind == OperationKind::Split, phase)
                         : emptyText(operation.kind, phase);
    case OperationKind::Drop:
        return holdsLoop ? dropText(phase) : emptyText(operation.kind, phase);
    default:
        return {};
    }
}

} // namespace knittsim::ui
