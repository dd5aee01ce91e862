#include "ui/window/banner.h"

#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

namespace knittsim::ui {

Banner::Banner(QWidget* parent)
    : QFrame(parent), m_icon(new QLabel(this)), m_text(new QLabel(this)), m_action(new QPushButton(this)),
      m_other(new QPushButton(this)), m_close(new QToolButton(this)) {
    setObjectName(QStringLiteral("banner"));
    m_text->setObjectName(QStringLiteral("bannerText"));
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close->setAutoRaise(true);
    m_close->setIcon(icon(QStringLiteral("close")));
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(tr("Close this message"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 6, 6);
    row->setSpacing(10);
    row->addWidget(m_icon);
    row->addWidget(m_text, 1);
    m_action->setObjectName(QStringLiteral("bannerAction"));
    m_other->setObjectName(QStringLiteral("bannerOther"));
    row->addWidget(m_action);
    row->addWidget(m_other);
    row->addWidget(m_close);
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
    connect(m_action, &QPushButton::clicked, this, [this] { m_run ? answer(m_run) : emit actionWanted(); });
    connect(m_other, &QPushButton::clicked, this, [this] { answer(m_runOther); });
    hide();
}

void Banner::showMessage(Kind kind, const QString& text, const QString& action) {
    m_kind = kind;
    const Accents accents = accentsOf(palette());
    m_icon->setPixmap((kind == Kind::Error ? icon(QStringLiteral("error"), accents.error)
                                           : icon(QStringLiteral("info"), accents.busy))
                          .pixmap(QSize(20, 20), devicePixelRatioF()));
    m_text->setText(text);
    m_action->setText(action);
    m_action->setVisible(!action.isEmpty());
    m_other->hide();
    m_run = {};
    m_runOther = {};
    show();
}

void Banner::ask(const QString& text, const QString& action, std::function<void()> run, const QString& other,
                 std::function<void()> runOther) {
    showMessage(Kind::Note, text, action);
    m_run = std::move(run);
    m_other->setText(other);
    m_other->setVisible(!other.isEmpty());
    m_runOther = std::move(runOther);
}

void Banner::answer(const std::function<void()>& run) {
    const std::function<void()> kept = run; // it may ask the next question
    hide();
    kept();
}

QString Banner::text() const {
    return m_text->text();
}

void Banner::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Accents accents = accentsOf(palette());
    const QColor tone = m_kind == Kind::Error ? accents.error : accents.busy;
    QColor ground = tone;
    ground.setAlphaF(isDark(palette()) ? 0.16F : 0.10F);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.fillRect(rect(), ground);
    painter.fillRect(QRect(0, 0, 3, height()), tone);
    painter.setPen(accents.line);
    painter.drawLine(0, height() - 1, width(), height() - 1);
}

} // namespace knittsim::ui
