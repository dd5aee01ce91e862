#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/history/history_card.h"
#include "ui/views/needle_beds/needle_beds.h"
#include "ui/window/comparison.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

namespace knittsim::ui {

using document::Appearance;
using render::DrawStyle;

void MainWindow::buildViewMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&View"));
    addAction(menu, "actionFront", tr("&Front"), Qt::Key_1, "view-front", [this] { m_fabric->lookFront(); });
    addAction(menu, "actionBack", tr("&Back"), Qt::CTRL | Qt::Key_1, "view-back",
              [this] { m_fabric->lookBack(); });
    addAction(menu, "actionRight", tr("&Right"), Qt::Key_3, {}, [this] { m_fabric->lookRight(); });
    addAction(menu, "actionLeft", tr("&Left"), Qt::CTRL | Qt::Key_3, {}, [this] { m_fabric->lookLeft(); });
    addAction(menu, "actionTop", tr("&Top"), Qt::Key_7, "view-top", [this] { m_fabric->lookTop(); });
    addAction(menu, "actionBottom", tr("B&ottom"), Qt::CTRL | Qt::Key_7, {},
              [this] { m_fabric->lookBottom(); });
    menu->addSeparator();
    QAction* flat =
        addChoice(menu, nullptr, "actionOrthographic", tr("Ort&hographic"), Qt::Key_5, "ortho", [] {});
    connect(flat, &QAction::toggled, this, [this](bool on) { m_fabric->setOrthographic(on); });
    addAction(menu, "actionFit", tr("Fit the fa&bric"), Qt::Key_F, "fit", [this] { m_comparison->fit(); });
    addAction(menu, "actionCentre", tr("&Centre on the selection"), Qt::Key_C, {}, [this] {
        if (m_fabric->selection() >= 0) {
            m_fabric->centreOn(m_fabric->selection());
        }
    });
    addAction(menu, "actionNearer", tr("Zoom &in"), QKeySequence::ZoomIn, {},
              [this] { m_fabric->zoomBy(1.25); });
    addAction(menu, "actionFarther", tr("Zoom o&ut"), QKeySequence::ZoomOut, {},
              [this] { m_fabric->zoomBy(0.8); });
    addAction(menu, "actionFitChart", tr("Fit the &pattern grid"), Qt::CTRL | Qt::SHIFT | Qt::Key_F, {},
              [this] { shownChart()->fitChart(); });
    menu->addSeparator();
    auto* styles = new QActionGroup(this);
    addChoice(menu, styles, "actionStyleYarn", tr("Lit &yarn"), Qt::ALT | Qt::Key_1, "style-yarn",
              [this] { m_fabric->setStyle(DrawStyle::Yarn); });
    addChoice(menu, styles, "actionStyleStrokes", tr("Three &strokes"), Qt::ALT | Qt::Key_2, "style-strokes",
              [this] { m_fabric->setStyle(DrawStyle::Strokes); });
    addChoice(menu, styles, "actionStyleMesh", tr("Bonding points and &mesh"), Qt::ALT | Qt::Key_3,
              "style-mesh", [this] { m_fabric->setStyle(DrawStyle::Mesh); });
    QAction* hair = addChoice(menu, nullptr, "actionHair", tr("Fu&zz of hairy yarn"), Qt::Key_Z, {}, [] {});
    hair->setToolTip(tr("Loose fibres around hairy yarn, seen near by (Z)"));
    connect(hair, &QAction::toggled, this, [this](bool on) { m_fabric->setHair(on); });
    buildDetailMenu(menu);
    auto* colours = new QActionGroup(this);
    colours->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    QAction* tension =
        addChoice(menu, colours, "actionTension", tr("Yarn &tension as colour"), Qt::Key_T, {}, [] {});
    QAction* contact = addChoice(menu, colours, "actionContact", tr("Contact force as colour"),
                                 Qt::SHIFT | Qt::Key_T, {}, [] {});
    contact->setToolTip(tr("How hard other yarn presses, when settled as yarn (Shift+T)"));
    QAction* speed = addChoice(menu, colours, "actionSpeed", tr("Speed of settling as colour"),
                               Qt::CTRL | Qt::SHIFT | Qt::Key_Y, {}, [] {});
    speed->setToolTip(tr("How far the yarn has moved since the last picture (Ctrl+Shift+Y)"));
    connect(colours, &QActionGroup::triggered, this, [this, tension, contact, speed] {
        m_fabric->setColourBy(tension->isChecked()   ? render::ColourBy::Tension
                              : speed->isChecked()   ? render::ColourBy::Speed
                              : contact->isChecked() ? render::ColourBy::Contact
                                                     : render::ColourBy::Yarn);
    });
    QAction* history = addChoice(menu, nullptr, "actionHistory", tr("H&istory of the selected bonding point"),
                                 Qt::Key_H, {}, [] {});
    connect(history, &QAction::toggled, this, [this](bool on) { m_history->setSwitchedOn(on); });
    buildOverlayMenu(menu);
    buildCompareMenu(menu);
    buildViewsMenu(menu);
    buildPhotographMenu(menu);
    menu->addSeparator();
    QAction* beds = m_bedDock->toggleViewAction();
    beds->setObjectName(QStringLiteral("actionNeedleBeds"));
    beds->setShortcut(Qt::Key_N);
    beds->setToolTip(tr("Shows the needle beds while they work (N)"));
    menu->addAction(beds);
    connect(beds, &QAction::triggered, this, [this](bool on) {
        if (on) {
            m_bedDock->raise();
        }
    });
    addAction(menu, "actionFollowNeedle", tr("Follo&w the working needle"), Qt::SHIFT | Qt::Key_N, {},
              [this] { m_beds->follow(); });
    menu->addSeparator();
    buildLanguageMenu(menu);
    QMenu* appearance = menu->addMenu(tr("&Appearance"));
    auto* looks = new QActionGroup(this);
    const std::initializer_list<std::tuple<const char*, QString, Appearance>> choices{
        {"actionSystemLook", tr("As the &system"), Appearance::System},
        {"actionLight", tr("&Light"), Appearance::Light},
        {"actionDark", tr("&Dark"), Appearance::Dark}};
    for (const auto& [name, text, value] : choices) {
        QAction* action =
            addChoice(appearance, looks, name, text, {}, {}, [this, value = value] { setAppearance(value); });
        action->setChecked(m_session.appearance() == value);
    }
    QAction* full = addChoice(menu, nullptr, "actionFullScreen", tr("F&ull screen"), Qt::Key_F11, {}, [] {});
    connect(full, &QAction::toggled, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
}

} // namespace knittsim::ui
