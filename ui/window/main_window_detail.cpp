#include "ui/views/fabric_view/fabric_view.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"

#include <QActionGroup>
#include <QMenu>

#include <array>
#include <optional>

namespace knittsim::ui {

namespace {

using render::DetailLevel;

const QString kDetail = QStringLiteral("window/detail");

struct Choice {
    const char* name; ///< of the action; what is remembered is all behind "actionDetail"
    std::optional<DetailLevel> level;
    const char* text;
    const char* toolTip;
};

constexpr std::array kChoices{
    Choice{"actionDetailAuto", std::nullopt, QT_TRANSLATE_NOOP("knittsim::ui::MainWindow", "&Automatic"),
           QT_TRANSLATE_NOOP("knittsim::ui::MainWindow",
                             "As fine as the width of the yarn on the screen can show")},
    Choice{"actionDetailYarn", DetailLevel::Yarn, QT_TRANSLATE_NOOP("knittsim::ui::MainWindow", "Full &yarn"),
           QT_TRANSLATE_NOOP("knittsim::ui::MainWindow", "Plies and fibres at any distance; the slowest")},
    Choice{"actionDetailTubes", DetailLevel::Tubes,
           QT_TRANSLATE_NOOP("knittsim::ui::MainWindow", "Plain &tubes"),
           QT_TRANSLATE_NOOP("knittsim::ui::MainWindow", "Round yarn without plies at any distance")},
    Choice{"actionDetailStrokes", DetailLevel::Strokes,
           QT_TRANSLATE_NOOP("knittsim::ui::MainWindow", "&Strokes"),
           QT_TRANSLATE_NOOP("knittsim::ui::MainWindow", "Flat bands at any distance; the fastest")}};

} // namespace

void MainWindow::buildDetailMenu(QMenu* view) {
    QMenu* menu = view->addMenu(tr("&Detail of the yarn"));
    menu->setObjectName(QStringLiteral("detailMenu"));
    menu->setToolTipsVisible(true);
    auto* group = new QActionGroup(this);
    const QByteArray remembered = m_session.value(kDetail);
    for (const Choice& choice : kChoices) {
        const QByteArray id = QByteArray(choice.name).mid(12);
        QAction* action =
            addChoice(menu, group, choice.name, tr(choice.text), {}, {}, [this, id, level = choice.level] {
                m_fabric->setDetail(level);
                m_session.setValue(kDetail, id);
            });
        action->setToolTip(tr(choice.toolTip));
        if (!choice.level || id == remembered) {
            action->setChecked(true);
            m_fabric->setDetail(choice.level);
        }
    }
    connect(m_fabric, &FabricView::detailDrawnChanged, this, &MainWindow::takeDetail);
    connect(m_fabric, &FabricView::displayChanged, this, &MainWindow::takeDetail);
}

/// Tells which level is drawn, and whether it was chosen.
void MainWindow::takeDetail() {
    const auto drawn = m_fabric->detailDrawn();
    const QString text = !drawn                         ? QString()
                         : *drawn == DetailLevel::Yarn  ? tr("full yarn")
                         : *drawn == DetailLevel::Tubes ? tr("plain tubes")
                                                        : tr("strokes");
    m_status->setDetail(text, m_fabric->detail().has_value());
}

} // namespace knittsim::ui
