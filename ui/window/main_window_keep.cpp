// The part of the main window that keeps charts: saving, recovery, files that others change.

#include "ui/document/message_text.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"
#include "ui/window/sample_thumbnail.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>

#include <algorithm>

namespace knittsim::ui {

QString MainWindow::askWhich(const QString& title, const QString& filter) {
    const QString path = QFileDialog::getOpenFileName(this, title, m_session.lastFolder(), filter);
    if (!path.isEmpty()) {
        m_session.setLastFolder(QFileInfo(path).absolutePath());
    }
    return path;
}

/// A file to write, of the kind that was chosen; asks before one that exists. Empty: nowhere.
QString MainWindow::askWhere(const QString& title, const QString& start, const QStringList& kinds) {
    QFileDialog dialog(this, title, start, kinds.join(QStringLiteral(";;")));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    // "Name (*.a *.b)": the first one is appended to a name without extension.
    const auto suffixOf = [](const QString& kind) {
        return kind.section(QStringLiteral("(*."), 1).section(u' ', 0, 0).remove(u')');
    };
    dialog.setDefaultSuffix(suffixOf(kinds.front()));
    connect(&dialog, &QFileDialog::filterSelected, &dialog,
            [&](const QString& kind) { dialog.setDefaultSuffix(suffixOf(kind)); });
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) {
        return {};
    }
    const QString path = dialog.selectedFiles().front();
    const bool known = std::ranges::any_of(kinds, [&](const QString& kind) {
        return kind.contains(QStringLiteral("*.") + QFileInfo(path).suffix());
    });
    const QString whole = known ? path : path + u'.' + dialog.defaultSuffix();
    const bool asked =
        whole == path || !QFileInfo::exists(whole) ||
        QMessageBox::question(this, title, tr("%1 exists. Replace it?").arg(whole)) == QMessageBox::Yes;
    return asked ? whole : QString();
}

bool MainWindow::saveChart() {
    const QString path = m_document.path();
    return pattern::isProjectFile(path.toStdString()) ? saveChartTo(path) : saveChartAs();
}

bool MainWindow::saveChartAs() {
    if (!m_document.project()) {
        return false;
    }
    const QString start =
        m_session.lastFolder() + u'/' + QFileInfo(m_document.title()).baseName() + QStringLiteral(".knitt");
    const QString path = askWhere(tr("Save the chart"), start, {tr("Charts (*.knitt)")});
    return !path.isEmpty() && saveChartTo(path);
}

bool MainWindow::saveChartTo(const QString& path) {
    if (m_watch.hasChanged() && path == m_document.path() &&
        QMessageBox::question(
            this, tr("Save the chart"),
            tr("Another program has changed %1 since it was opened. Replace it with what is here?")
                .arg(QFileInfo(path).fileName())) != QMessageBox::Yes) {
        return false;
    }
    const bool wanted = findChild<QAction*>(QStringLiteral("actionSaveShape"))->isChecked();
    const std::vector<float> shape = wanted ? m_document.shapeAtRest() : std::vector<float>();
    const Diagnostics problems =
        m_document.save(path, {.thumbnail = chartThumbnail(m_document.project()->chart).toStdString(),
                               .view = m_fabric->saveCamera().toBase64().toStdString(),
                               .shape = shape});
    if (hasErrors(problems)) {
        m_banner->showMessage(Banner::Kind::Error,
                              tr("%1 could not be saved. %2")
                                  .arg(QFileInfo(path).fileName(), document::causeText(problems.front())));
        return false;
    }
    m_session.setLastFolder(QFileInfo(path).absolutePath());
    m_session.addRecentFile(path);
    takeRecentFiles();
    statusBar()->showMessage(wanted && shape.empty()
                                 ? tr("Saved %1, without a shape: the fabric is not at rest").arg(path)
                                 : tr("Saved %1").arg(path),
                             5000);
    return true;
}

void MainWindow::offerRecovery() {
    for (const document::Recovery::Leftover& leftover : document::Recovery::leftovers()) {
        auto read = pattern::readProjectFile(std::filesystem::path(leftover.path.toStdString()));
        if (!read) {
            continue;
        }
        const auto project = std::make_shared<const pattern::Project>(std::move(read).value());
        m_banner->ask(
            tr("Unsaved work on %1 of %2 was found.")
                .arg(leftover.title, QLocale().toString(leftover.time, QLocale::ShortFormat)),
            tr("Restore"), [this, leftover, project] { restore(leftover, project); }, tr("Discard"),
            [this, leftover] {
                document::Recovery::discard(leftover);
                offerRecovery(); // the next one
            });
        return;
    }
}

void MainWindow::restore(const document::Recovery::Leftover& leftover,
                         const std::shared_ptr<const pattern::Project>& project) {
    whenLeft([this, leftover, project] {
        m_document.openProject(leftover.title, project, true);
        connect(
            &m_document, &document::Document::opened, this,
            [this, leftover, project] {
                if (m_document.project() == project) { // not something else that was faster
                    m_document.keepCopy();
                    document::Recovery::discard(leftover);
                }
            },
            Qt::SingleShotConnection);
    });
}

void MainWindow::takeForeignChange() {
    const QString name = QFileInfo(m_watch.path()).fileName();
    m_banner->ask(
        m_document.isModified()
            ? tr("Another program has changed %1. Your own changes are not saved yet.").arg(name)
            : tr("Another program has changed %1.").arg(name),
        tr("Reload"), [this] { reload(); }, tr("Keep what is here"), [] {});
}

/// Saving would overwrite the other program's work, so it is not among the answers.
void MainWindow::reload() {
    const QString path = m_watch.path();
    if (m_document.isModified()) {
        QMessageBox question(QMessageBox::Question, tr("Reload the file"),
                             tr("Reloading %1 drops the changes made here.").arg(QFileInfo(path).fileName()),
                             QMessageBox::Cancel, this);
        question.setObjectName(QStringLiteral("reloadQuestion"));
        QPushButton* copy = question.addButton(tr("Save them elsewhere\u2026"), QMessageBox::AcceptRole);
        QPushButton* drop = question.addButton(tr("Drop them"), QMessageBox::DestructiveRole);
        question.exec();
        const bool kept = question.clickedButton() == copy && saveChartAs();
        if (!kept && question.clickedButton() != drop) {
            return;
        }
    }
    m_document.open(path);
}

void MainWindow::whenLeft(const std::function<void()>& action) {
    if (!m_document.isModified()) {
        action();
        return;
    }
    QMessageBox question(QMessageBox::Question, tr("Unsaved changes"),
                         tr("%1 has changes that are not saved.").arg(m_document.title()),
                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    question.setObjectName(QStringLiteral("unsaved"));
    question.setDefaultButton(QMessageBox::Save);
    const int answer = question.exec();
    if (answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveChart())) {
        action();
    }
}

} // namespace knittsim::ui
