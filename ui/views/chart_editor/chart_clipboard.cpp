#include "ui/views/chart_editor/chart_clipboard.h"

#include "core/pattern/project.h"

#include <QClipboard>
#include <QGuiApplication>

namespace knittsim::ui {

void copyToClipboard(const pattern::Chart& part) {
    const std::string text = pattern::writeProject({.chart = part, .machine = {}});
    QGuiApplication::clipboard()->setText(QString::fromStdString(text));
}

std::optional<pattern::Chart> partOnClipboard() {
    const QString text = QGuiApplication::clipboard()->text();
    if (!text.startsWith(QStringLiteral("{\n\"knitt\""))) {
        return std::nullopt;
    }
    auto project = pattern::readProject(text.toStdString(), {});
    if (!project) {
        return std::nullopt;
    }
    return std::move(project).value().chart;
}

} // namespace knittsim::ui
