#include "ui/views/simulation_panel/activity_text.h"

#include "ui/views/simulation_panel/yarn_run_text.h"
#include "ui/views/style/appearance.h"

#include <QCoreApplication>

namespace knittsim::ui {

namespace {

using document::Activity;
using simulation::StopReason;

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::ui", text);
}

QString reasonText(StopReason reason) {
    switch (reason) {
    case StopReason::ResidualReached:
        return tr("forces are balanced");
    case StopReason::Stagnation:
        return tr("energy and shape no longer change");
    case StopReason::StepLimit:
        return tr("the limit of steps is reached");
    case StopReason::Diverged:
        return tr("the numbers became useless; the last good shape is kept");
    case StopReason::SolverFailed:
        return tr("the integrator gave up; try another one");
    default:
        return {};
    }
}

/// Of the yarn where it runs or is shown.
bool ofYarn(const document::Document& document) {
    return document.yarnRun().running() || document.showsYarn();
}

Activity shownActivity(const document::Document& document) {
    if (!ofYarn(document)) {
        return document.activity();
    }
    const document::YarnRun& run = document.yarnRun();
    return run.running() ? Activity::Settling : isAtRest(run) ? Activity::AtRest : Activity::Paused;
}

QString wordOf(Activity activity) {
    switch (activity) {
    case Activity::Empty:
        return tr("Nothing open");
    case Activity::Opening:
        return tr("Opening");
    case Activity::Machine:
        return tr("As the machine leaves it");
    case Activity::Settling:
        return tr("Settling");
    case Activity::Paused:
        return tr("Paused");
    case Activity::AtRest:
        return tr("At rest");
    case Activity::Failed:
        break;
    }
    return tr("Stopped");
}

} // namespace

QString activityWord(const document::Document& document) {
    if (!ofYarn(document)) {
        return wordOf(document.activity());
    }
    const document::YarnRun& run = document.yarnRun();
    return run.running()     ? tr("Settling as yarn")
           : !isAtRest(run)  ? tr("Yarn stopped")
           : isBalanced(run) ? tr("Yarn at rest")
                             : tr("Yarn hardly moves any more");
}

QString activityText(const document::Document& document) {
    const Activity activity = document.activity();
    const bool ended =
        activity == Activity::AtRest || activity == Activity::Failed || activity == Activity::Paused;
    const QString reason = ended && !ofYarn(document) ? reasonText(document.stopReason()) : QString();
    return reason.isEmpty() ? activityWord(document) : tr("%1: %2").arg(activityWord(document), reason);
}

QColor activityColour(const document::Document& document, const QPalette& palette) {
    const Accents accents = accentsOf(palette);
    switch (shownActivity(document)) {
    case Activity::Settling:
    case Activity::Opening:
        return accents.busy;
    case Activity::AtRest:
        return accents.good;
    case Activity::Failed:
        return accents.error;
    default:
        return accents.faintText;
    }
}

} // namespace knittsim::ui
