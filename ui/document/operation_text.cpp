#include "ui/document/operation_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <cmath>

namespace knittsim::document {

namespace {

using machine::Operation;
using machine::OperationKind;

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::document", text);
}

QString directionText(machine::Direction direction) {
    return direction == machine::Direction::Right ? tr("to the right") : tr("to the left");
}

QString capital(QString text) {
    if (!text.isEmpty()) {
        text[0] = text[0].toUpper();
    }
    return text;
}

QString textOf(const machine::Program& program, const Operation& op) {
    const auto index = static_cast<std::size_t>(op.text);
    return op.text >= 0 && index < program.texts.size() ? QString::fromStdString(program.texts[index])
                                                        : QString();
}

QString stitchPattern(OperationKind kind) {
    switch (kind) {
    case OperationKind::Knit:
        return tr("Knit on %1 with carrier %2, %3");
    case OperationKind::Tuck:
        return tr("Tuck on %1 with carrier %2, %3");
    case OperationKind::Miss:
        return tr("Miss %1 with carrier %2, %3");
    case OperationKind::YarnIn:
        return tr("Carrier %2 starts at %1, %3");
    case OperationKind::YarnOut:
        return tr("Carrier %2 ends at %1, %3");
    default:
        return tr("Split on %1 with carrier %2, %3");
    }
}

QString carrierPattern(OperationKind kind) {
    switch (kind) {
    case OperationKind::In:
        return tr("Bring in carrier %1");
    case OperationKind::InHook:
        return tr("Bring in carrier %1 with the hook");
    case OperationKind::ReleaseHook:
        return tr("Release carrier %1 from the hook");
    case OperationKind::Out:
        return tr("Take out carrier %1");
    default:
        return tr("Take out carrier %1 with the hook");
    }
}

QString markText(const StitchMark& mark) {
    QStringList parts;
    switch (mark.kind) {
    case StitchKind::CastOn:
        parts << tr("hung on an empty needle");
        break;
    case StitchKind::Knit:
        parts << (mark.rear ? tr("knit (purl on the face)") : tr("knit"));
        break;
    case StitchKind::Tuck:
        parts << tr("tuck");
        break;
    case StitchKind::Split:
        parts << tr("split");
        break;
    }
    if (mark.parents > 1) {
        parts << tr("through %1 loops").arg(mark.parents);
    }
    if (mark.moved != 0) {
        parts << (mark.moved > 0 ? tr("moved %1 to the right") : tr("moved %1 to the left"))
                     .arg(std::abs(mark.moved));
    }
    if (mark.otherBed) {
        parts << (mark.rear ? tr("moved to the front bed") : tr("moved to the rear bed"));
    }
    if (mark.dropped) {
        parts << tr("dropped");
    }
    return parts.join(QStringLiteral(", "));
}

} // namespace

QString needleText(machine::Needle needle) {
    switch (needle.bed) {
    case machine::Bed::Front:
        return tr("front needle %1").arg(needle.index);
    case machine::Bed::Rear:
        return tr("rear needle %1").arg(needle.index);
    case machine::Bed::FrontSlider:
        return tr("front slider %1").arg(needle.index);
    case machine::Bed::RearSlider:
        break;
    }
    return tr("rear slider %1").arg(needle.index);
}

QString carrierText(const machine::Program& program, const machine::CarrierSet& carriers) {
    QStringList names;
    for (const machine::CarrierIndex carrier : carriers) {
        names << (carrier < program.header.carriers.size()
                      ? QString::fromStdString(program.header.carriers[carrier].name)
                      : QString::number(carrier + 1));
    }
    return names.join(QStringLiteral(" + "));
}

QString rackText(double rack) {
    if (rack == 0) {
        return QStringLiteral("0");
    }
    const QString size = QLocale().toString(std::abs(rack), 'g', 4);
    return (rack > 0 ? QStringLiteral("+") : QStringLiteral("\u2212")) + size;
}

QString operationText(const machine::Program& program, machine::OperationIndex operation) {
    if (operation < 0 || operation >= static_cast<machine::OperationIndex>(program.operations.size())) {
        return {};
    }
    const Operation& op = program.operations[static_cast<std::size_t>(operation)];
    const QString carriers = carrierText(program, op.carriers);
    switch (op.kind) {
    case OperationKind::In:
    case OperationKind::InHook:
    case OperationKind::ReleaseHook:
    case OperationKind::Out:
    case OperationKind::OutHook:
        return carrierPattern(op.kind).arg(carriers);
    case OperationKind::StitchSize:
        return tr("Stitch size %1, tension %2").arg(op.value).arg(op.value2);
    case OperationKind::StitchNumber:
        return tr("Stitch number %1").arg(op.value);
    case OperationKind::Rack:
        return tr("Rack the rear bed to %1").arg(rackText(op.value));
    case OperationKind::Drop:
        return tr("Drop the loops of %1").arg(needleText(op.needle));
    case OperationKind::Amiss:
        return tr("Activate %1 without yarn").arg(needleText(op.needle));
    case OperationKind::Xfer:
        return tr("Transfer from %1 to %2").arg(needleText(op.needle), needleText(op.target));
    case OperationKind::Split:
        return tr("Split on %1 to %2 with carrier %3, %4")
            .arg(needleText(op.needle), needleText(op.target), carriers, directionText(op.direction));
    case OperationKind::Pause:
        return tr("Pause");
    case OperationKind::Colour:
        return tr("Show carrier %1 in colour %2").arg(carriers, textOf(program, op));
    case OperationKind::Extension:
        return textOf(program, op);
    default:
        return stitchPattern(op.kind).arg(needleText(op.needle), carriers, directionText(op.direction));
    }
}

QString operationSentence(const machine::Program& program, machine::OperationIndex operation) {
    if (operation < 0 || operation >= static_cast<machine::OperationIndex>(program.operations.size())) {
        return {};
    }
    const Operation& op = program.operations[static_cast<std::size_t>(operation)];
    const QString needle = needleText(op.needle);
    const QString carriers = carrierText(program, op.carriers);
    switch (op.kind) {
    case OperationKind::Knit:
        return tr("Knit: %1 draws yarn of carrier %2 through its loop.").arg(needle, carriers);
    case OperationKind::Tuck:
        return tr("Tuck: %1 takes yarn of carrier %2 and keeps what it holds.").arg(needle, carriers);
    case OperationKind::Miss:
        return tr("Miss: carrier %2 passes %1, which stays down.").arg(needle, carriers);
    case OperationKind::Split:
        return tr("Split: the loop on %1 moves to %2, and %1 takes yarn of carrier %3.")
            .arg(needle, needleText(op.target), carriers);
    case OperationKind::Xfer:
        return tr("Transfer: the loop on %1 moves to %2.").arg(needle, needleText(op.target));
    case OperationKind::Drop:
        return tr("Drop: the loop falls off %1.").arg(needle);
    case OperationKind::Amiss:
        return tr("%1 moves without yarn.").arg(capital(needle));
    case OperationKind::Rack:
        return tr("Rack: the rear bed moves to %1.").arg(rackText(op.value));
    case OperationKind::In:
        return tr("Carrier %1 comes in.").arg(carriers);
    case OperationKind::InHook:
        return tr("Carrier %1 comes in, the hook holds its yarn.").arg(carriers);
    case OperationKind::ReleaseHook:
        return tr("The hook lets go of the yarn of carrier %1.").arg(carriers);
    case OperationKind::Out:
    case OperationKind::OutHook:
        return tr("Carrier %1 goes out, its yarn is cut.").arg(carriers);
    default:
        return operationText(program, operation) + u'.';
    }
}

QString operationSentence(const machine::Timeline& timeline, machine::OperationIndex operation) {
    const machine::Program& program = timeline.program();
    if (operation >= 0 && operation < timeline.operationCount()) {
        const Operation& op = program.operations[static_cast<std::size_t>(operation)];
        const bool loops = op.kind == OperationKind::Knit || op.kind == OperationKind::Tuck;
        if (loops && !op.carriers.empty() && timeline.stateAfter(operation).loopsOn(op.needle).empty()) {
            const QString pattern =
                op.kind == OperationKind::Knit
                    ? tr("Knit: %1 is empty and takes yarn of carrier %2 as its first loop.")
                    : tr("Tuck: %1 is empty and takes yarn of carrier %2 as its first loop.");
            return pattern.arg(needleText(op.needle), carrierText(program, op.carriers));
        }
    }
    return operationSentence(program, operation);
}

QString stitchText(const machine::Program& program, const machine::LoopTable& loops, const StitchGrid& grid,
                   machine::LoopIndex loop) {
    const machine::Loop& made = loops.loops[static_cast<std::size_t>(loop)];
    const QString text = tr("%1, course %2: %3 with carrier %4")
                             .arg(capital(needleText(made.needle)))
                             .arg(grid.placeOf(loop).course + 1)
                             .arg(markText(grid.markOf(loop)), carrierText(program, {made.carrier}));
    const int line = program.operations[static_cast<std::size_t>(made.operation)].line;
    return line > 0 ? tr("%1, line %2").arg(text).arg(line) : text;
}

} // namespace knittsim::document
