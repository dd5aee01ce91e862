#include "ui/views/diagnostics/diagnostics_list.h"

#include "core/base/message_table.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>

namespace knittsim::ui {

DiagnosticsList::DiagnosticsList(document::Document& document, QWidget* parent)
    : QTreeView(parent), m_document(document) {
    setObjectName(QStringLiteral("diagnosticsList"));
    setAccessibleName(tr("Problems"));
    setModel(&m_model);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setFrameShape(QFrame::NoFrame);
    setTextElideMode(Qt::ElideRight);
    header()->setStretchLastSection(true);
    header()->setSectionsMovable(false);
    setToolTip(tr("Double click or Enter shows the place (F8 next, Shift+F8 previous)"));
    connect(this, &QTreeView::doubleClicked, this, &DiagnosticsList::showPlace);
    connect(&m_document, &document::Document::problemsChanged, this, &DiagnosticsList::takeProblems);
    takeProblems();
}

void DiagnosticsList::takeProblems() {
    m_model.setProblems(m_document.problems());
    resizeColumnToContents(DiagnosticsModel::Kind);
    resizeColumnToContents(DiagnosticsModel::Where);
    setColumnWidth(DiagnosticsModel::Kind, columnWidth(DiagnosticsModel::Kind) + 12);
    setColumnWidth(DiagnosticsModel::Where, columnWidth(DiagnosticsModel::Where) + 12);
}

void DiagnosticsList::showPlace(const QModelIndex& index) {
    if (index.isValid()) {
        emit placeWanted(m_model.problems()[static_cast<std::size_t>(index.row())]);
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
    const QModelIndex next = m_model.index((row + count) % count, 0);
    setCurrentIndex(next);
    showPlace(next);
}

void DiagnosticsList::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        showPlace(currentIndex());
    } else if (event->matches(QKeySequence::Copy) && currentIndex().isValid()) {
        const Diagnostic& problem = m_model.problems()[static_cast<std::size_t>(currentIndex().row())];
        QGuiApplication::clipboard()->setText(QString::fromStdString(toLine(problem)));
    } else {
        QTreeView::keyPressEvent(event);
    }
}

} // namespace knittsim::ui
