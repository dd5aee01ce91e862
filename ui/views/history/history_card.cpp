#include "ui/views/history/history_card.h"

#include "ui/document/history_text.h"
#include "ui/document/operation_text.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace knittsim::ui {

namespace {

constexpr int kMargin = 12;
constexpr int kWidth = 330;
constexpr int kPadding = 12;

} // namespace

HistoryCard::HistoryCard(document::Document& document, QWidget* parent)
    : QFrame(parent), m_document(document), m_title(new QLabel(this)), m_stitch(new QLabel(this)),
      m_events(new QLabel(this)), m_scroll(new QScrollArea(this)) {
    setObjectName(QStringLiteral("historyCard"));
    setAccessibleName(tr("History of the bonding point"));
    setAttribute(Qt::WA_NoMousePropagation);
    setCursor(Qt::ArrowCursor);
    m_title->setObjectName(QStringLiteral("historyTitle"));
    m_events->setObjectName(QStringLiteral("historyEvents"));
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_stitch->setWordWrap(true);
    m_events->setWordWrap(true);
    m_events->setTextFormat(Qt::RichText);
    m_events->setTextInteractionFlags(Qt::TextBrowserInteraction);
    m_events->setAlignment(Qt::AlignTop);
    auto* close = new QToolButton(this);
    close->setObjectName(QStringLiteral("historyClose"));
    close->setAutoRaise(true);
    close->setIcon(icon(QStringLiteral("close")));
    close->setToolTip(tr("Close; H shows histories again"));
    close->setAccessibleName(tr("Close the history"));
    m_scroll->setWidget(m_events);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->viewport()->setAutoFillBackground(false);
    m_events->setAutoFillBackground(false);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(close);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(kPadding, 8, 8, 10);
    rows->setSpacing(4);
    rows->addLayout(head);
    rows->addWidget(m_stitch);
    rows->addWidget(m_scroll, 1);
    hide();
    parent->installEventFilter(this);
    connect(close, &QToolButton::clicked, this, &HistoryCard::closeWanted);
    connect(m_events, &QLabel::linkActivated, this,
            [this](const QString& link) { emit lineWanted(link.toInt()); });
    connect(&m_document, &document::Document::pointChanged, this, &HistoryCard::take);
}

void HistoryCard::setSwitchedOn(bool on) {
    m_on = on;
    take();
}

void HistoryCard::take() {
    const auto history = m_on ? m_document.pointHistory() : std::nullopt;
    if (!history) {
        hide();
        return;
    }
    const auto file = m_document.file();
    m_title->setText(document::pointText(*history));
    m_stitch->setText(
        document::stitchText(file->timeline->program(), file->timeline->loops(), *file->grid, history->loop));
    QPalette faint = palette();
    faint.setColor(QPalette::WindowText, accentsOf(palette()).faintText);
    m_stitch->setPalette(faint);
    m_events->setText(rows(*history));
    m_scroll->verticalScrollBar()->setValue(0);
    place();
    show();
    raise();
}

/// A table: the line of the source, and what happened there.
QString HistoryCard::rows(const fabric::PointHistory& history) const {
    const auto lines = document::historyLines(*m_document.file()->timeline, history);
    const QString link = palette().color(QPalette::Link).name();
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='2'>");
    for (const document::HistoryLine& line : lines) {
        const QString number =
            line.line > 0 ? QStringLiteral("<a href='%1' style='color:%2'>%1</a>").arg(line.line).arg(link)
                          : QString();
        html += QStringLiteral("<tr><td align='right' style='padding-right:8px'>%1</td><td>%2</td></tr>")
                    .arg(number, line.text.toHtmlEscaped());
    }
    return html + QStringLiteral("</table>");
}

void HistoryCard::place() {
    const QSize room = parentWidget()->size() - QSize(2 * kMargin, 2 * kMargin);
    const int width = std::min(kWidth, room.width());
    const int inner = width - kPadding - 8;
    const int wanted = 8 + m_title->sizeHint().height() + 10 + m_stitch->heightForWidth(inner) + 8 +
                       m_events->heightForWidth(inner) + 12;
    resize(width, std::min(wanted, room.height() * 3 / 5));
    move(parentWidget()->width() - width - kMargin, kMargin);
}

bool HistoryCard::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize && isVisible()) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

void HistoryCard::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && isVisible()) {
        take();
    }
    QFrame::changeEvent(event);
}

void HistoryCard::paintEvent(QPaintEvent*) {
    paintCard(*this);
}

} // namespace knittsim::ui
