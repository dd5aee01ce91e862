#include "ui/window/opening_card.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace knittsim::ui {

namespace {

QString stageText(document::OpeningStage stage) {
    switch (stage) {
    case document::OpeningStage::Reading:
        return OpeningCard::tr("Reading the file");
    case document::OpeningStage::Machine:
        return OpeningCard::tr("Running the machine");
    case document::OpeningStage::Fabric:
        break;
    }
    return OpeningCard::tr("Building the fabric");
}

} // namespace

OpeningCard::OpeningCard(document::Document& document, QWidget* parent)
    : QFrame(parent), m_document(document), m_title(new QLabel(this)), m_stage(new QLabel(this)),
      m_progress(new QProgressBar(this)) {
    setObjectName(QStringLiteral("openingCard"));
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_progress->setRange(0, 0);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(8);
    auto* cancel = new QPushButton(tr("Cancel"), this);
    cancel->setObjectName(QStringLiteral("cancelOpening"));
    cancel->setToolTip(tr("Stops opening this file; what was open stays"));
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_stage, 1);
    foot->addWidget(cancel);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(18, 14, 18, 12);
    rows->setSpacing(9);
    rows->addWidget(m_title);
    rows->addWidget(m_progress);
    rows->addLayout(foot);
    hide();

    m_delay.setSingleShot(true);
    m_delay.setInterval(kDelayMs);
    parent->installEventFilter(this);
    connect(cancel, &QPushButton::clicked, &m_document, &document::Document::cancelOpening);
    connect(&m_delay, &QTimer::timeout, this, [this] {
        place();
        show();
        raise();
    });
    connect(&m_document, &document::Document::openingStarted, this, [this] {
        m_title->setText(tr("Opening %1").arg(m_document.openingTitle()));
        m_stage->setText(stageText(document::OpeningStage::Reading));
        m_delay.start();
    });
    connect(&m_document, &document::Document::openingStage, this,
            [this](document::OpeningStage stage) { m_stage->setText(stageText(stage)); });
    connect(&m_document, &document::Document::openingEnded, this, [this] {
        m_delay.stop();
        hide();
    });
}

void OpeningCard::place() {
    resize(360, sizeHint().height());
    move((parentWidget()->width() - width()) / 2, (parentWidget()->height() - height()) / 3);
}

void OpeningCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.2));
    painter.setBrush(palette().color(QPalette::ToolTipBase));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8, 8);
}

bool OpeningCard::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize && isVisible()) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace knittsim::ui
