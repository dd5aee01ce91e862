#include "ui/views/diagnostics/diagnostics_list.h"

#include "core/base/message_table.h"
#include "core/machine/checks/rules.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QStringList>

#include <algorithm>

namespace knittsim::ui {

DiagnosticsList::DiagnosticsList(QWidget* parent) : QTreeView(parent) {
    setObjectName(QStringLiteral("diagnosticsList"));
    setAccessibleName(tr("Problems"));
    m_filter.setSourceModel(&m_model);
    setModel(&m_filter);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setFrameShape(QFrame::NoFrame);
    setTextElideMode(Qt::ElideRight);
    header()->setStretchLastSection(true);
    header()->setSectionsMovable(false);
    header()->setSortIndicatorClearable(true);
    setSortingEnabled(true);
    sortByColumn(-1, Qt::AscendingOrder);
    setToolTip(tr("Double click or Enter shows the place (F8 next, Shift+F8 previous)"));
    connect(this, &QTreeView::doubleClicked, this, &DiagnosticsList::showPlace);
}

void DiagnosticsList::setProblems(const Diagnostics& problems, const std::vector<machine::Waived>& waived) {
    m_model.setProblems(problems, waived);
    for (const int column : {DiagnosticsModel::Kind, DiagnosticsModel::Where}) {
        resizeColumnToContents(column);
        setColumnWidth(column, columnWidth(column) + 12);
    }
}

void DiagnosticsList::showPlace(const QModelIndex& index) {
    if (index.isValid()) {
        emit placeWanted(m_filter.problemAt(index));
    }
}

void DiagnosticsList::walk(int direction) {
    const int count = problemCount();
    if (count == 0) {
        return;
    }
    const int row = currentIndex().isValid() ? currentIndex().row() + direction
                    : direction > 0          ? 0
                                             : count - 1;
    const QModelIndex next = m_filter.index((row + count) % count, 0);
    setCurrentIndex(next);
    showPlace(next);
}

QString DiagnosticsList::asText() const {
    QModelIndexList rows = selectionModel()->selectedRows();
    if (rows.isEmpty()) {
        for (int row = 0; row < problemCount(); ++row) {
            rows << m_filter.index(row, 0);
        }
    }
    std::sort(rows.begin(), rows.end());
    QStringList lines;
    for (const QModelIndex& row : rows) {
        const QString reason = m_filter.offReason(row);
        lines << QString::fromStdString(toLine(m_filter.problemAt(row))) +
                     (reason.isEmpty() ? QString()
                                       : QStringLiteral(" (") + tr("turned off: %1").arg(reason) + u')');
    }
    return lines.join(u'\n');
}

void DiagnosticsList::copy() const {
    QGuiApplication::clipboard()->setText(asText());
}

void DiagnosticsList::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    const QModelIndex at = indexAt(event->pos());
    QAction* show = menu.addAction(tr("Show the &place"));
    show->setEnabled(at.isValid());
    QAction* copyText = menu.addAction(tr("&Copy as text"));
    copyText->setEnabled(problemCount() > 0);
    const QString rule = at.isValid() ? QString::fromStdString(m_filter.problemAt(at).id) : QString();
    const bool off = at.isValid() && !m_filter.offReason(at).isEmpty();
    menu.addSeparator();
    QAction* turn =
        menu.addAction(off ? tr("Turn rule %1 &on again").arg(rule) : tr("Turn &off this rule\u2026"));
    turn->setObjectName(QStringLiteral("actionTurnRule"));
    turn->setEnabled(at.isValid() && machine::findRule(rule.toStdString()) != nullptr);
    const QAction* chosen = menu.exec(event->globalPos());
    if (chosen == show) {
        showPlace(at);
    } else if (chosen == copyText) {
        copy();
    } else if (chosen == turn) {
        off ? emit onWanted(rule) : emit offWanted(rule);
    }
}

void DiagnosticsList::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        showPlace(currentIndex());
    } else if (event->matches(QKeySequence::Copy)) {
        copy();
    } else {
        QTreeView::keyPressEvent(event);
    }
}

} // namespace knittsim::ui
