#include "ui/document/operation_text.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/icons.h"
#include "ui/views/style/numbers.h"

#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace knittsim::ui {

using document::StopRules;
using machine::OperationKind;

QAction* StepPlayer::add(QMenu* menu, const char* name, const QString& text, const QKeySequence& keys,
                         const std::function<void()>& action) {
    QAction* made = menu->addAction(text);
    made->setObjectName(QString::fromLatin1(name));
    made->setShortcut(keys);
    const QString plain = QString(text).remove(u'&').remove(QChar(0x2026));
    made->setToolTip(keys.isEmpty()
                         ? plain
                         : QStringLiteral("%1 (%2)").arg(plain, keys.toString(QKeySequence::NativeText)));
    connect(made, &QAction::triggered, this, action);
    return made;
}

QToolButton* StepPlayer::addMenuButton(const char* name, const char* iconName, const QString& text,
                                       QMenu* menu) {
    auto* button = new QToolButton(this);
    button->setObjectName(QString::fromLatin1(name));
    button->setIcon(icon(QString::fromLatin1(iconName)));
    button->setIconSize({18, 18});
    button->setAutoRaise(true);
    button->setCheckable(true);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(menu);
    button->setToolTip(text);
    button->setAccessibleName(text);
    return button;
}

void StepPlayer::buildLoopMenu() {
    m_loopMenu = new QMenu(tr("Play a part again a&nd again"), this);
    m_loopMenu->setToolTipsVisible(true);
    add(m_loopMenu, "actionLoopFrom", tr("&From here"), Qt::SHIFT | Qt::Key_Home,
        [this] { m_marks.setLoopFrom(m_document.step()); });
    add(m_loopMenu, "actionLoopTo", tr("Up &to here"), Qt::SHIFT | Qt::Key_End,
        [this] { m_marks.setLoopTo(m_document.step()); });
    add(m_loopMenu, "actionLoopEnd", tr("Play &all again"), Qt::SHIFT | Qt::Key_Escape,
        [this] { m_marks.endLoop(); });
}

void StepPlayer::buildBookmarkMenu() {
    m_bookmarkMenu = new QMenu(tr("Book&marks"), this);
    m_bookmarkMenu->setToolTipsVisible(true);
    add(m_bookmarkMenu, "actionBookmark", tr("&Bookmark here, or remove it"), QKeySequence(tr("Ctrl+B")),
        [this] { m_marks.toggleBookmark(m_document.step()); });
    add(m_bookmarkMenu, "actionNextBookmark", tr("&Next bookmark"), Qt::Key_F2,
        [this] { walkBookmarks(+1); });
    add(m_bookmarkMenu, "actionPreviousBookmark", tr("&Previous bookmark"), Qt::SHIFT | Qt::Key_F2,
        [this] { walkBookmarks(-1); });
    m_bookmarkMenu->addSeparator();
}

void StepPlayer::listBookmarks() {
    for (QAction* old : m_bookmarkActions) {
        delete old;
    }
    m_bookmarkActions.clear();
    const auto file = m_document.file();
    for (const int step : m_marks.bookmarks()) {
        const QString words = file && step > 0 ? document::operationText(file->timeline->program(), step - 1)
                                               : tr("Empty machine");
        QAction* made = m_bookmarkMenu->addAction(tr("%1: %2").arg(countText(step), words));
        connect(made, &QAction::triggered, this, [this, step] { m_document.setStep(step); });
        m_bookmarkActions.push_back(made);
    }
}

void StepPlayer::walkBookmarks(int direction) {
    if (const int step = m_marks.bookmarkFrom(m_document.step(), direction); step >= 0) {
        m_document.setStep(step);
    }
}

void StepPlayer::addStop(const QString& text, const std::function<void(StopRules&, bool)>& set,
                         const std::function<bool(const StopRules&)>& get, QMenu* menu) {
    QAction* made = (menu ? menu : m_stopMenu)->addAction(text);
    made->setCheckable(true);
    made->setChecked(get(m_marks.rules()));
    connect(made, &QAction::toggled, this, [this, set](bool on) {
        StopRules rules = m_marks.rules();
        set(rules, on);
        m_marks.setRules(rules);
    });
    connect(this, &StepPlayer::rulesShown, made, [this, made, get] {
        const QSignalBlocker quiet(made);
        made->setChecked(get(m_marks.rules()));
    });
}

void StepPlayer::buildStopMenu() {
    m_stopMenu = new QMenu(tr("Stop &playing at"), this);
    m_stopMenu->setToolTipsVisible(true);
    const std::initializer_list<std::pair<OperationKind, QString>> kinds{
        {OperationKind::Knit, tr("&Knit")},
        {OperationKind::Tuck, tr("&Tuck")},
        {OperationKind::Miss, tr("&Miss")},
        {OperationKind::Split, tr("&Split")},
        {OperationKind::Xfer, tr("Trans&fer")},
        {OperationKind::Drop, tr("&Drop")},
        {OperationKind::Rack, tr("&Rack")},
        {OperationKind::InHook, tr("Carrier comes &in")},
        {OperationKind::OutHook, tr("Carrier goes &out")}};
    for (const auto& [kind, text] : kinds) {
        const auto twin = kind == OperationKind::InHook    ? OperationKind::In
                          : kind == OperationKind::OutHook ? OperationKind::Out
                                                           : kind;
        addStop(
            text,
            [kind = kind, twin](StopRules& rules, bool on) {
                rules.set(kind, on);
                rules.set(twin, on);
            },
            [kind = kind](const StopRules& rules) { return rules.has(kind); });
    }
    m_stopMenu->addSeparator();
    addStop(
        tr("A racking that is &not 0"), [](StopRules& rules, bool on) { rules.racked = on; },
        [](const StopRules& rules) { return rules.racked; });
    addStop(
        tr("A &problem"), [](StopRules& rules, bool on) { rules.problem = on; },
        [](const StopRules& rules) { return rules.problem; });
    m_needleStop = add(m_stopMenu, "actionStopNeedle", tr("A n&eedle\u2026"), {}, [this] { askForNeedle(); });
    m_carrierMenu = m_stopMenu->addMenu(tr("A &carrier that comes to work"));
    m_stopMenu->addSeparator();
    add(m_stopMenu, "actionNoStops", tr("No&where"), {}, [this] { m_marks.setRules({}); });
}

void StepPlayer::listCarriers() {
    m_carrierMenu->clear();
    for (std::size_t i = 0; i < m_document.carriers().size(); ++i) {
        const auto carrier = static_cast<machine::CarrierIndex>(i);
        addStop(
            tr("Carrier %1").arg(QString::fromStdString(m_document.carriers()[i].carrier)),
            [carrier](StopRules& rules, bool on) {
                rules.carrier = on ? std::optional(carrier) : std::nullopt;
            },
            [carrier](const StopRules& rules) { return rules.carrier == carrier; }, m_carrierMenu);
    }
    m_carrierMenu->setEnabled(!m_document.carriers().empty());
}

void StepPlayer::takeRules() {
    const auto& needle = m_marks.rules().needle;
    m_needleStop->setText(needle ? tr("A n&eedle (%1)\u2026").arg(document::needleText(*needle))
                                 : tr("A n&eedle\u2026"));
    emit rulesShown();
}

void StepPlayer::askForNeedle() {
    auto* dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("needleDialog"));
    dialog->setWindowTitle(tr("Stop at a needle"));
    dialog->setLabelText(tr("Bed and number, for example f5 or b12; empty for none:"));
    const auto& needle = m_marks.rules().needle;
    dialog->setTextValue(needle ? QString::fromStdString(machine::toString(*needle)) : QString());
    connect(dialog, &QInputDialog::textValueSelected, this, &StepPlayer::takeNeedle);
    dialog->open();
}

void StepPlayer::takeNeedle(const QString& text) {
    StopRules rules = m_marks.rules();
    rules.needle = document::needleFromText(text.trimmed().toStdString());
    if (!rules.needle && !text.trimmed().isEmpty()) {
        auto* box = new QMessageBox(QMessageBox::Warning, tr("Stop at a needle"),
                                    tr("\u201c%1\u201d is no needle. Write the bed (f, b, fs or bs) and a "
                                       "number, for example f5.")
                                        .arg(text.trimmed()),
                                    QMessageBox::Ok, this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
        return;
    }
    m_marks.setRules(rules);
}

void StepPlayer::goToLine(int line) {
    const auto file = m_document.file();
    if (!file) {
        return;
    }
    const auto& operations = file->timeline->program().operations;
    const auto found = std::ranges::find_if(operations, [line](const auto& op) { return op.line >= line; });
    m_document.setStep(found == operations.end() ? m_document.operationCount()
                                                 : static_cast<int>(found - operations.begin()) + 1);
}

void StepPlayer::askForLine() {
    const auto file = m_document.file();
    if (!file) {
        return;
    }
    auto* dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("lineDialog"));
    dialog->setWindowTitle(tr("Go to line"));
    dialog->setLabelText(tr("Line of the source:"));
    dialog->setInputMode(QInputDialog::IntInput);
    dialog->setIntRange(1, std::max(1, file->source ? file->source->lineCount() : 1));
    dialog->setIntValue(std::max(1, m_document.selection().line));
    connect(dialog, &QInputDialog::intValueSelected, this, &StepPlayer::goToLine);
    dialog->open();
}

} // namespace knittsim::ui
